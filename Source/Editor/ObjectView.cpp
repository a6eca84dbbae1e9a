#include "Editor/ObjectView.h"

#include "Editor/Look.h"
#include "Editor/MaterialInEffect.h"
#include "Editor/OpenGlSupport.h"
#include "Editor/PlainPicture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr int framesPerSecond = 30;
constexpr int ticksToWait = 50; // ticks of the window's timer before OpenGL counts as missing
constexpr int pixelsToDrag = 4;

} // namespace

ObjectView::ObjectView(ProcessorView& processor)
    : view(processor), strikes(processor), hand(processor) {
    setTitle("Instrument");
    setOpaque(true);
    context.setOpenGLVersionRequired(juce::OpenGLContext::openGL3_2);
    context.setContinuousRepainting(false);
    context.setRenderer(&renderer);
    if (hasOpenGl())
        context.attachTo(*this);
    else
        ticksWithoutContext = ticksToWait;
    refresh();
}

ObjectView::~ObjectView() {
    hand.lift();
    context.detach();
}

// Picture.

void ObjectView::refresh() {
    if (renderer.works())
        ticksWithoutContext = 0;
    else if (ticksWithoutContext < ticksToWait && isShowing() &&
             ++ticksWithoutContext == ticksToWait)
        repaint();
    if (const int playing = view.instrument.instrumentNumber(); playing != shownInstrument) {
        hand.lift();
        shownInstrument = playing;
        newScene();
    }
    followMaterial();
}

void ObjectView::newScene() {
    shown = ShownInstrument::of(view);
    appearances = appearancesOf(view, shown.played);
    if (!shown.scene->empty())
        camera.lookAt(shown.outline());
    const auto name = view.presets.playingPreset().details.name;
    if (std::exchange(shownPreset, name) != name) // its own changes keep the view
        camera.reset();
    paths.reset();
    if (!shown.onStage)
        paths.showStruckPlaces(view, shown.played, *shown.scene);
    brush.show(view, shown);
    strikes.reset(*shown.scene, shown.onStage);
    hover(std::nullopt);
    vibration.reset(shown.played);
    cameraMoved();
}

/// Looks at the current material, which may have changed.
void ObjectView::followMaterial() {
    auto now = appearancesOf(view, shown.played);
    if (now == appearances)
        return;
    appearances = std::move(now);
    redraw();
}

void ObjectView::showSound(const SoundFrame& frame) {
    if (frame.instrumentNumber != shownInstrument)
        return;
    const bool wasMoving = moves();
    if (frame.object >= 0)
        vibration.follow(static_cast<std::size_t>(frame.object), frame.modes);
    const bool bodiesMoved = shown.onStage && shown.follow(frame.bodies);
    if (const auto& under = outline.hover(); under && under->body && !shown.rests(*under->body))
        hover(std::nullopt);
    if (strikes.follow(frame, shown.played, *shown.scene) || wasMoving || moves() || bodiesMoved)
        wake();
}

void ObjectView::showMode(std::optional<std::size_t> mode) {
    vibration.showMode(mode);
    wake();
}

void ObjectView::setLayers(const Layers& wanted) {
    if (wanted.draws() != layers.draws())
        hand.lift();
    layers = wanted;
    vibration.setShown(layers.vibration, layers.nodes);
    repaint();
    wake();
}

void ObjectView::wake() {
    if (moves() && isShowing() && !isTimerRunning())
        startTimerHz(framesPerSecond);
    else if (!isTimerRunning())
        redraw();
}

void ObjectView::timerCallback() {
    strikes.advance(1.0 / framesPerSecond);
    vibration.advance(1.0 / framesPerSecond);
    if (!moves() || !isShowing())
        stopTimer();
    redraw();
}

void ObjectView::cameraMoved() {
    if (layers.path || layers.held || isDrawing() || outline.hover())
        repaint();
    redraw();
}

SceneFrame ObjectView::frameNow() {
    SceneFrame frame{.scene = shown.scene,
                     .furniture = shown.furniture,
                     .appearances = appearances,
                     .viewProjection = camera.viewProjection(aspect()),
                     .eye = camera.eye(aspect()),
                     .background = colourOf(*this, LookColour::panel),
                     .accent = colourOf(*this, LookColour::accent),
                     .isDark = colourOf(*this, LookColour::panel).getPerceivedBrightness() < 0.5f,
                     .motion =
                         shown.scene->empty() ? std::nullopt : vibration.motionIn(*shown.scene),
                     .bodies = shown.drawnBodies()};
    strikes.addTo(frame, shown.scene->radius());
    return frame;
}

void ObjectView::redraw() {
    if (ticksWithoutContext >= ticksToWait)
        return repaint();
    renderer.show(frameNow());
    context.triggerRepaint();
}

void ObjectView::paint(juce::Graphics& g) {
    const bool isPlain = !renderer.works();
    if (isPlain)
        g.fillAll(colourOf(*this, LookColour::panel));
    const bool waits = isShowing() && ticksWithoutContext < ticksToWait; // for OpenGL
    if (shown.scene->empty() || (isPlain && waits))
        return;
    if (isPlain)
        paintPlainPicture(g, getLocalBounds().toFloat(), frameNow());
    paths.paint(g, *this, *shown.scene, camera, layers.path);
    if (layers.held)
        brush.paint(g, *this, *shown.scene, camera);
    outline.paint(g, *this, *shown.scene, camera);
}

// Mouse input.

std::optional<ScenePick> ObjectView::pickAt(juce::Point<float> position) const {
    if (getLocalBounds().isEmpty())
        return std::nullopt;
    const float x = 2 * position.x / static_cast<float>(getWidth()) - 1;
    const float y = 1 - 2 * position.y / static_cast<float>(getHeight());
    const auto ray = camera.rayThrough(x, y, aspect());
    return shown.pick(ray);
}

/// Returns the note that sets an object in motion: its own key, or else one in the middle.
int ObjectView::noteFor(std::size_t object) const {
    const auto& own = shown.played[object];
    const auto range = view.instrument.keyRange();
    return own.lowestNote == own.highestNote ? own.lowestNote : (range.lowest + range.highest) / 2;
}

std::optional<ScenePick> ObjectView::strikeAt(juce::Point<float> position, double pixelsPerSecond) {
    hand.lift();
    const auto pick = pickAt(position);
    if (pick) {
        hand.strike(*pick, pixelsPerSecond,
                    shown.onStage ? std::optional(noteFor(pick->object)) : std::nullopt);
        if (!shown.onStage)
            strikes.strike(*pick, *shown.scene,
                           float(ObjectHand::velocityOf(*pick, pixelsPerSecond)) / 127);
        wake();
    }
    return pick;
}

void ObjectView::drawTo(const juce::MouseEvent& event) {
    if (const auto pick = pickAt(event.position)) {
        if (layers.paintsHeld)
            brush.drawTo(*pick, event.mods.isShiftDown());
        else
            paths.drawTo(*pick);
        repaint();
    }
}

/// Outlines the object under the mouse, on a stage only while it rests.
void ObjectView::hover(std::optional<ScenePick> pick) {
    std::optional<HoverOutline::Hover> next;
    if (pick && (pick->body ? shown.rests(*pick->body) : !layers.draws())) {
        const auto& own = shown.played[pick->object];
        const bool playsNote = shown.onStage || own.lowestNote == own.highestNote;
        next = {.object = pick->object,
                .note = playsNote ? noteFor(pick->object) : -1,
                .velocity = ObjectHand::velocityOf(*pick, 0),
                .body = pick->body};
    }
    if (outline.show(next))
        repaint();
}

void ObjectView::mouseMove(const juce::MouseEvent& event) {
    hover(pickAt(event.position));
    const double seconds = (event.eventTime - cameAt).inSeconds();
    if (seconds > 0)
        cameAtPixelsPerSecond = double(event.position.getDistanceFrom(cameFrom)) / seconds;
    cameFrom = event.position;
    cameAt = event.eventTime;
}

void ObjectView::mouseDown(const juce::MouseEvent& event) {
    if (event.mods.isLeftButtonDown() && layers.draws() && !shown.onStage) {
        drawTo(event);
        if (isDrawing())
            return;
    } else if (event.mods.isLeftButtonDown()) {
        // If the mouse stood still before the click, its speed is 0.
        const bool justCame = (event.eventTime - cameAt).inMilliseconds() < 60;
        if (strikeAt(event.position, justCame ? cameAtPixelsPerSecond : 0))
            return;
    }
    turningFrom = event.position;
    hover(std::nullopt);
}

void ObjectView::mouseDrag(const juce::MouseEvent& event) {
    if (isDrawing())
        return drawTo(event);
    if (!turningFrom) {
        if (shown.onStage || layers.draws()) // the path's instrument may no longer exist
            return;
        if (hand.isScraping() || event.getDistanceFromDragStart() > pixelsToDrag) {
            const auto pick = pickAt(event.position);
            hand.dragTo(pick, event.isPressureValid() ? double(event.pressure)
                                                      : ObjectHand::defaultPressure);
            if (pick)
                strikes.touch(*pick);
            hover(std::nullopt);
            wake();
        }
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
    if (isDrawing()) {
        paths.finishDrawing(view);
        brush.finishDrawing(view);
        repaint();
    }
    hand.lift();
    turningFrom.reset();
}

void ObjectView::mouseDoubleClick(const juce::MouseEvent& event) {
    if (!pickAt(event.position))
        frame();
}

void ObjectView::mouseWheelMove(const juce::MouseEvent& event,
                                const juce::MouseWheelDetails& wheel) {
    camera.zoomBy(std::exp(0.8f * wheel.deltaY));
    cameraMoved();
    if (!turningFrom)
        hover(pickAt(event.position));
}

} // namespace idiophone
