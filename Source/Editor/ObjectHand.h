// The mouse as a hand: strikes and scrapes objects of the picture, and lights the touched place.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/ProcessorView.h"

#include <optional>

namespace idiophone {

/// For the message thread.
class ObjectHand {
public:
    static constexpr double defaultPressure = 0.7; ///< for a mouse, which has no pressure

    explicit ObjectHand(ProcessorView& processor) : view(processor) {}

    /// Strikes an object. A strike lower on the object (nearer to the player), or with a faster
    /// mouse, is harder. On a stage, plays `stageNote` instead.
    void strike(const ScenePick& pick, double pixelsPerSecond, std::optional<int> stageNote);
    /// Scrapes from the last place to this one. An object entered on the way is struck. Without a
    /// pick the scrape ends.
    void dragTo(const std::optional<ScenePick>& pick, double pressure);
    /// Releases the object that is struck or scraped.
    void lift();
    bool isScraping() const { return scraping; }

    /// Fades the light by one frame, unless the hand scrapes.
    void fade();
    void darken() { brightness = 0; }
    float glow() const { return brightness; } ///< 1 at the strike
    const ScenePlace& glowPlace() const { return litPlace; }

private:
    void touch(const ScenePick& pick);
    void endScrape();

    ProcessorView& view;
    std::optional<ScenePick> struck; ///< last place, until the hand is lifted
    std::optional<int> note;         ///< played on a stage
    bool scraping = false;
    float brightness = 0;
    ScenePlace litPlace{};
};

} // namespace idiophone
