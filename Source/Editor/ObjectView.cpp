#include "Editor/ObjectView.h"

#include "Editor/Look.h"
#include "Editor/OpenGlSupport.h"

#include <algorithm>
#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>
#include <new>

namespace idiophone {
namespace {

constexpr int framesPerSecond = 30;
constexpr int ticksToWait = 50;       // ticks of the window's timer before OpenGL counts as missing
constexpr float glowFraction = 0.02f; // of the scene's radius
constexpr float darkDecibels = -60;   // an object at or below this level is not lit
constexpr float pixelsToDrag = 4;

} // namespace

ObjectView::ObjectView(ProcessorView& processor) : view(processor), hand(processor) {
    setTitle("Instrument");
    setDescription("Click to strike, drag to scrape; drag beside it to turn, wheel to zoom");
    setOpaque(true);
    juce::OpenGLPixelFormat format;
    format.multisamplingLevel = 4;
    format.depthBufferBits = 24;
    context.setPixelFormat(format);
    context.setMultisamplingEnabled(true);
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
}

void ObjectView::newScene() {
    played = view.instrument.playedObjects();
    bodies = view.stage.stageBodies();
    onStage = view.stage.hasStage();
    try {
        scene = std::make_shared<const ObjectScene>(
            played, onStage ? ObjectScene::Layout::stage : ObjectScene::Layout::keyboard);
    } catch (const std::bad_alloc&) { // keep playing without a picture
        played.clear();
        bodies.clear();
        onStage = false;
        scene = std::make_shared<const ObjectScene>(played);
    }
    if (!scene->empty())
        camera.lookAt(bodies.empty() ? scene->outline() : scene->outline(bodies));
    paths.reset();
    if (!onStage)
        paths.showStruckPlaces(view, played, *scene);
    hand.darken();
    lights.clear();
    vibration.reset(played);
    cameraMoved();
}

void ObjectView::showSound(const SoundFrame& frame) {
    if (frame.instrumentNumber != shownInstrument)
        return;
    std::vector<float> loudness(played.size(), 0);
    for (const auto& slot : frame.slots)
        if (const auto object = static_cast<std::size_t>(slot.object); object < loudness.size())
            loudness[object] = std::max(
                loudness[object],
                1 - juce::Decibels::gainToDecibels(slot.amplitude, darkDecibels) / darkDecibels);
    const bool wasMoving = moves();
    if (frame.object >= 0)
        vibration.follow(static_cast<std::size_t>(frame.object), frame.modes);
    const bool bodiesMoved = onStage && frame.bodies != bodies;
    if (bodiesMoved)
        bodies = frame.bodies;
    if (loudness != lights || wasMoving || moves() || bodiesMoved) {
        lights = std::move(loudness);
        wake();
    }
}

void ObjectView::showMode(std::optional<std::size_t> mode) {
    vibration.showMode(mode);
    wake();
}

void ObjectView::setLayers(const Layers& wanted) {
    if (wanted.drawsPath != layers.drawsPath)
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
    hand.fade();
    vibration.advance(1.0 / framesPerSecond);
    if (!moves() || !isShowing())
        stopTimer();
    redraw();
}

void ObjectView::cameraMoved() {
    if (layers.path || paths.isDrawing())
        repaint();
    redraw();
}

void ObjectView::redraw() {
    std::optional<std::vector<SceneBody>> drawnBodies;
    if (onStage) {
        drawnBodies.emplace();
        for (const auto& body : bodies) {
            SceneBody next{.object = static_cast<std::size_t>(body.object)};
            Eigen::Map<Eigen::Matrix4f>(next.pose.data()) = poseOf(body).matrix();
            drawnBodies->push_back(next);
        }
    }
    renderer.show({.scene = scene,
                   .viewProjection = camera.viewProjection(aspect()),
                   .eye = camera.eye(aspect()),
                   .background = colourOf(*this, LookColour::panel),
                   .accent = colourOf(*this, LookColour::accent),
                   .glowPlace = hand.glowPlace(),
                   .glow = hand.glow(),
                   .glowMetres = glowFraction * scene->radius(),
                   .lights = lights,
                   .motion = scene->empty() ? std::nullopt : vibration.motionIn(*scene),
                   .bodies = std::move(drawnBodies)});
    context.triggerRepaint();
}

void ObjectView::paint(juce::Graphics& g) {
    if (renderer.works()) {
        if (!scene->empty())
            paths.paint(g, *this, *scene, camera, layers.path);
        return;
    }
    g.fillAll(colourOf(*this, LookColour::panel));
    if (ticksWithoutContext < ticksToWait)
        return;
    g.setColour(colourOf(*this, LookColour::dimText));
    g.setFont(Look::textFont());
    g.drawFittedText("There is no OpenGL here to draw the instrument with. Everything else works.",
                     getLocalBounds().reduced(12), juce::Justification::centred, 3);
}

// Mouse input.

float ObjectView::aspect() const {
    return static_cast<float>(juce::jmax(1, getWidth())) /
           static_cast<float>(juce::jmax(1, getHeight()));
}

std::optional<ScenePick> ObjectView::pickAt(juce::Point<float> position) const {
    if (getLocalBounds().isEmpty())
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

std::optional<ScenePick> ObjectView::strikeAt(juce::Point<float> position, double pixelsPerSecond) {
    hand.lift();
    const auto pick = pickAt(position);
    if (pick) {
        hand.strike(*pick, pixelsPerSecond,
                    onStage ? std::optional(noteFor(pick->object)) : std::nullopt);
        wake();
    }
    return pick;
}

void ObjectView::drawTo(juce::Point<float> position) {
    if (const auto pick = pickAt(position)) {
        paths.drawTo(*pick);
        repaint();
    }
}

void ObjectView::mouseMove(const juce::MouseEvent& event) {
    const double seconds = (event.eventTime - cameAt).inSeconds();
    if (seconds > 0)
        cameAtPixelsPerSecond = double(event.position.getDistanceFrom(cameFrom)) / seconds;
    cameFrom = event.position;
    cameAt = event.eventTime;
}

void ObjectView::mouseDown(const juce::MouseEvent& event) {
    if (event.mods.isLeftButtonDown() && layers.drawsPath && !onStage) {
        drawTo(event.position);
        if (paths.isDrawing())
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
    if (paths.isDrawing())
        return drawTo(event.position);
    if (!turningFrom) {
        if (onStage || layers.drawsPath) // the path's instrument may no longer exist
            return;
        if (hand.isScraping() || event.getDistanceFromDragStart() > pixelsToDrag) {
            hand.dragTo(pickAt(event.position), event.isPressureValid()
                                                    ? double(event.pressure)
                                                    : ObjectHand::defaultPressure);
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
    if (paths.isDrawing()) {
        paths.finishDrawing(view);
        repaint();
    }
    hand.lift();
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
