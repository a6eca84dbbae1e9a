// Mouse input of the 3D view: strike, scrape, draw the strike path, turn the view.
#include "Editor/ObjectView.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr double softest = 45, hardest = 127;
constexpr double fastestPixelsPerSecond = 3000;
constexpr float pixelsToDrag = 4;
constexpr std::size_t mostPathPoints = 500;

int velocityOf(const ScenePick& pick, double pixelsPerSecond) {
    const double hard =
        std::max(pick.towardsPlayer, std::min(pixelsPerSecond / fastestPixelsPerSecond, 1.0));
    return juce::roundToInt(softest + (hardest - softest) * hard);
}

} // namespace

float ObjectView::aspect() const {
    return static_cast<float>(juce::jmax(1, getWidth())) /
           static_cast<float>(juce::jmax(1, getHeight()));
}

std::optional<ScenePick> ObjectView::pickAt(juce::Point<float> position) const {
    if (scene == nullptr || getLocalBounds().isEmpty())
        return std::nullopt;
    const float x = 2 * position.x / static_cast<float>(getWidth()) - 1;
    const float y = 1 - 2 * position.y / static_cast<float>(getHeight());
    const auto ray = camera.rayThrough(x, y, aspect());
    return onStage ? scene->pick(ray.origin, ray.direction, bodies)
                   : scene->pick(ray.origin, ray.direction);
}

/// Returns the note that sets an object in motion: its own key, or else one in the middle.
int ObjectView::noteFor(std::size_t object) const {
    const auto& own = played[object];
    const auto range = view.instrument.keyRange();
    return own.lowestNote == own.highestNote ? own.lowestNote : (range.lowest + range.highest) / 2;
}

void ObjectView::strike(const ScenePick& pick, double pixelsPerSecond) {
    const int velocity = velocityOf(pick, pixelsPerSecond);
    if (onStage)
        view.instrument.playNote(noteFor(pick.object), velocity);
    else
        view.instrument.strikeObject(pick.object, pick.pointMetres, velocity);
    struck = pick;
    glow = 1;
    glowPlace = pick.place;
    wake();
}

std::optional<ScenePick> ObjectView::strikeAt(juce::Point<float> position, double pixelsPerSecond) {
    lift();
    const auto pick = pickAt(position);
    if (pick)
        strike(*pick, pixelsPerSecond);
    return pick;
}

void ObjectView::dragTo(juce::Point<float> position, double pressure) {
    if (onStage)
        return;
    const auto pick = pickAt(position);
    if (!pick) {
        if (scraping && struck)
            view.instrument.scrapeObject(struck->object, struck->pointMetres, 0);
        scraping = false;
        return;
    }
    if (!struck || struck->object != pick->object) {
        lift();
        strike(*pick, 0);
    }
    if (!scraping)
        view.instrument.scrapeObject(struck->object, struck->pointMetres, pressure);
    scraping = true;
    view.instrument.scrapeObject(pick->object, pick->pointMetres, pressure);
    struck = pick;
    glow = 1;
    glowPlace = pick->place;
    wake();
}

void ObjectView::lift() {
    if (struck) {
        if (scraping)
            view.instrument.scrapeObject(struck->object, struck->pointMetres, 0);
        if (onStage)
            view.instrument.playNote(noteFor(struck->object), 0);
        else
            view.instrument.strikeObject(struck->object, struck->pointMetres, 0);
    }
    struck.reset();
    scraping = false;
}

void ObjectView::drawTo(juce::Point<float> position) {
    const auto pick = pickAt(position);
    if (!pick || (drawnOn && *drawnOn != pick->object) || drawn.size() >= mostPathPoints)
        return;
    drawnOn = pick->object;
    drawn.push_back(pick->pointMetres);
    path.drawn.push_back(pick->place);
    repaint();
}

void ObjectView::finishPath() {
    if (drawnOn && drawn.size() > 1)
        view.workshop.setStrikePath(*drawnOn, drawn);
    drawn.clear();
    path.drawn.clear();
    drawnOn.reset();
    repaint();
}

void ObjectView::mouseMove(const juce::MouseEvent& event) {
    const double seconds = (event.eventTime - cameAt).inSeconds();
    if (seconds > 0)
        cameAtPixelsPerSecond = double(event.position.getDistanceFrom(cameFrom)) / seconds;
    cameFrom = event.position;
    cameAt = event.eventTime;
}

void ObjectView::mouseDown(const juce::MouseEvent& event) {
    if (event.mods.isLeftButtonDown() && drawsPath && !onStage) {
        drawTo(event.position);
        if (drawnOn)
            return;
    } else if (event.mods.isLeftButtonDown()) {
        // If the mouse stood still before the click, its speed is 0.
        const bool justCame = (event.eventTime - cameAt).inMilliseconds() < 60;
        if (strikeAt(event.position, justCame ? cameAtPixelsPerSecond : 0))
            return;
    }
    turningFrom = event.position;
}

void ObjectView::mouseDrag(const juce::MouseEvent& event) {
    if (drawnOn)
        return drawTo(event.position);
    if (!turningFrom && drawsPath && !onStage)
        return; // the path belonged to an instrument that is gone
    if (!turningFrom) {
        if (scraping || event.getDistanceFromDragStart() > pixelsToDrag)
            dragTo(event.position,
                   event.isPressureValid() ? double(event.pressure) : defaultPressure);
        return;
    }
    const auto moved =
        (event.position - *turningFrom) / static_cast<float>(juce::jmax(1, getHeight()));
    turningFrom = event.position;
    if (event.mods.isShiftDown() || event.mods.isMiddleButtonDown())
        camera.moveBy(moved.x, -moved.y);
    else
        camera.turnBy(-3 * moved.x, 3 * moved.y);
    cameraMoved();
}

void ObjectView::mouseUp(const juce::MouseEvent&) {
    if (drawnOn)
        finishPath();
    lift();
    turningFrom.reset();
}

void ObjectView::mouseDoubleClick(const juce::MouseEvent& event) {
    if (pickAt(event.position))
        return;
    camera.reset();
    cameraMoved();
}

void ObjectView::mouseWheelMove(const juce::MouseEvent&, const juce::MouseWheelDetails& wheel) {
    camera.zoomBy(std::exp(0.8f * wheel.deltaY));
    cameraMoved();
}

} // namespace idiophone
