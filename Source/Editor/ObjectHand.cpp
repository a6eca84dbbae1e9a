#include "Editor/ObjectHand.h"

#include <algorithm>
#include <juce_core/juce_core.h>

namespace idiophone {
namespace {

constexpr double softest = 45, hardest = 127;
constexpr double fastestPixelsPerSecond = 3000;
constexpr float glowFallPerFrame = 0.85f, faintestGlow = 0.01f;

} // namespace

void ObjectHand::touch(const ScenePick& pick) {
    struck = pick;
    brightness = 1;
    litPlace = pick.place;
}

void ObjectHand::strike(const ScenePick& pick,
                        double pixelsPerSecond,
                        std::optional<int> stageNote) {
    const double hard =
        std::max(pick.towardsPlayer, std::min(pixelsPerSecond / fastestPixelsPerSecond, 1.0));
    const int velocity = juce::roundToInt(softest + (hardest - softest) * hard);
    note = stageNote;
    if (note)
        view.instrument.playNote(*note, velocity);
    else
        view.instrument.strikeObject(pick.object, pick.pointMetres, velocity);
    touch(pick);
}

void ObjectHand::dragTo(const std::optional<ScenePick>& pick, double pressure) {
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
    touch(*pick);
}

void ObjectHand::endScrape() {
    if (scraping && struck)
        view.instrument.scrapeObject(struck->object, struck->pointMetres, 0);
    scraping = false;
}

void ObjectHand::lift() {
    endScrape();
    if (struck && note)
        view.instrument.playNote(*note, 0);
    else if (struck)
        view.instrument.strikeObject(struck->object, struck->pointMetres, 0);
    struck.reset();
}

void ObjectHand::fade() {
    if (scraping)
        return;
    brightness *= glowFallPerFrame;
    if (brightness < faintestGlow)
        brightness = 0;
}

} // namespace idiophone
