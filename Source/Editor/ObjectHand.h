// The mouse as a hand: strikes and scrapes objects of the picture.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/ProcessorView.h"

#include <algorithm>
#include <juce_core/juce_core.h>
#include <optional>

namespace idiophone {

/// For the message thread.
class ObjectHand {
public:
    static constexpr double defaultPressure = 0.7; ///< for a mouse, which has no pressure

    explicit ObjectHand(ProcessorView& processor) : view(processor) {}

    /// Says in a sentence for the user how the mouse acts in the picture.
    static const char* hint(bool onStage, bool drawsPath) {
        if (onStage)
            return "Click to set bodies in motion; drag beside them to turn the view, wheel to "
                   "zoom";
        if (drawsPath)
            return "Drag over an object to draw where the keys strike it";
        return "Click to strike, lower down for louder; drag to scrape; drag beside it to turn, "
               "wheel to zoom";
    }

    /// The velocity of a click there. Lower on the object (nearer to the player) or a faster mouse
    /// is harder.
    static int velocityOf(const ScenePick& pick, double pixelsPerSecond) {
        const double hard =
            std::max(pick.towardsPlayer, std::min(pixelsPerSecond / fastestPixelsPerSecond, 1.0));
        return juce::roundToInt(softest + (hardest - softest) * hard);
    }
    /// Strikes an object. On a stage, plays `stageNote` instead.
    void strike(const ScenePick& pick, double pixelsPerSecond, std::optional<int> stageNote) {
        const int velocity = velocityOf(pick, pixelsPerSecond);
        note = stageNote;
        if (note)
            view.instrument.playNote(*note, velocity);
        else
            view.instrument.strikeObject(pick.object, pick.pointMetres, velocity);
        struck = pick;
    }
    /// Scrapes from the last place to this one. An object entered on the way is struck. Without a
    /// pick the scrape ends.
    void dragTo(const std::optional<ScenePick>& pick, double pressure) {
        if (!pick)
            return endScrape();
        if (!struck || struck->object != pick->object) {
            lift();
            strike(*pick, 0, std::nullopt);
        }
        if (!scraping)
            view.instrument.scrapeObject(struck->object, struck->pointMetres, pressure);
        scraping = true;
        view.instrument.scrapeObject(pick->object, pick->pointMetres, pressure);
        struck = pick;
    }
    /// Releases the object that is struck or scraped.
    void lift() {
        endScrape();
        if (struck && note)
            view.instrument.playNote(*note, 0);
        else if (struck)
            view.instrument.strikeObject(struck->object, struck->pointMetres, 0);
        struck.reset();
    }
    bool isScraping() const { return scraping; }

private:
    static constexpr double softest = 45, hardest = 127; ///< velocities
    static constexpr double fastestPixelsPerSecond = 3000;

    void endScrape() {
        if (scraping && struck)
            view.instrument.scrapeObject(struck->object, struck->pointMetres, 0);
        scraping = false;
    }

    ProcessorView& view;
    std::optional<ScenePick> struck; ///< last place, until the hand is lifted
    std::optional<int> note;         ///< played on a stage
    bool scraping = false;
};

} // namespace idiophone
