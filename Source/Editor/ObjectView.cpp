#include "Editor/ObjectView.h"

#include "Editor/BodyPlacement.h"
#include "Editor/Look.h"
#include "Editor/OpenGlSupport.h"

#include <algorithm>
#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>
#include <new>
#include <numbers>

namespace idiophone {
namespace {

constexpr int framesPerSecond = 30;
constexpr float glowFallPerFrame = 0.85f, faintestGlow = 0.01f;
constexpr int ticksToWait = 50;       // ticks of the window's timer before OpenGL counts as missing
constexpr float exaggeration = 0.05f; // share of the object's radius, at the largest amplitude
constexpr double modeSwingHz = 1.2;
constexpr float glowShare = 0.02f;  // share of the scene's radius
constexpr float darkDecibels = -60; // an object at or below this level is not lit

} // namespace

ObjectView::ObjectView(ProcessorView& processor) : view(processor) {
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
    lift();
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
        lift();
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
    glowMetres = glowShare * scene->radius();
    path.paths.clear();
    const bool keysLieAlongPath = view.workshop.keyLayout() == KeyLayout::zones;
    for (std::size_t i = 0; i < played.size() && !onStage; ++i) {
        PathOverlay::Path line;
        for (const auto& place : view.instrument.struckPlaces(i))
            line.places.push_back(scene->placeOf(i, place));
        if (keysLieAlongPath && played[i].highestNote > played[i].lowestNote) {
            line.lowestKey =
                juce::MidiMessage::getMidiNoteName(played[i].lowestNote, true, true, 4);
            line.highestKey =
                juce::MidiMessage::getMidiNoteName(played[i].highestNote, true, true, 4);
        }
        path.paths.push_back(std::move(line));
    }
    drawn.clear();
    drawnOn.reset();
    path.drawn.clear();
    glow = 0;
    lights.clear();
    slowMotion.reset();
    surfaceMotions.clear();
    shapeOffsets.reset();
    shownMode.reset();
    watched = 0;
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
    if (frame.object >= 0) {
        if (static_cast<std::size_t>(frame.object) != watched)
            slowMotion.reset();
        watched = static_cast<std::size_t>(frame.object);
        slowMotion.follow(frame.modes);
    }
    const bool bodiesMoved = onStage && frame.bodies != bodies;
    if (bodiesMoved)
        bodies = frame.bodies;
    if (loudness != lights || wasMoving || moves() || bodiesMoved) {
        lights = std::move(loudness);
        wake();
    }
}

void ObjectView::showMode(std::optional<std::size_t> mode) {
    if (mode == shownMode)
        return;
    shownMode = mode;
    shownModePhase = std::numbers::pi / 2;
    wake();
}

void ObjectView::setShowsVibration(bool shows) {
    showsVibration = shows;
    wake();
}

void ObjectView::setShowsNodes(bool shows) {
    showsNodes = shows;
    wake();
}

void ObjectView::setShowsPath(bool shows) {
    showsPath = shows;
    repaint();
}

void ObjectView::setDrawsPath(bool draws) {
    drawsPath = draws;
    lift();
}

std::optional<std::size_t> ObjectView::modeWithNodes() const {
    if (shownMode || !showsNodes)
        return shownMode;
    const auto swings = slowMotion.swings();
    const auto strongest = std::ranges::max_element(
        swings, {}, [](const auto& swing) { return std::abs(swing.displacement); });
    return strongest == swings.end() ? 0 : strongest->mode;
}

const SurfaceMotion* ObjectView::motionOf(std::size_t object) {
    if (object >= played.size())
        return nullptr;
    return &surfaceMotions.try_emplace(object, played[object].object).first->second;
}

std::optional<SceneMotion> ObjectView::sceneMotion() {
    const auto mode = modeWithNodes();
    if (!mode && (!showsVibration || slowMotion.atRest()))
        return std::nullopt;
    if (watched >= played.size())
        return std::nullopt;
    const auto& box = scene->objects()[watched];
    if (box.isBox) // too many faces to animate
        return std::nullopt;
    const auto* motion = motionOf(watched);
    if (mode && *mode >= motion->modeCount())
        return std::nullopt;
    SceneMotion result{.object = watched, .offsets = {}, .scale = exaggeration * box.radius};
    std::vector<float> displacements(played[watched].object->vertices.size());
    if (mode) {
        if (shapeOffsets == nullptr || shapeOf != std::pair(watched, *mode)) {
            motion->add(*mode, 1, displacements);
            shapeOf = {watched, *mode};
            shapeOffsets = std::make_shared<const std::vector<ScenePlace>>(
                scene->offsetsOf(watched, displacements));
        }
        result.offsets = shapeOffsets;
        result.scale *= static_cast<float>(std::sin(shownModePhase));
        result.showsNodes = true;
        return result;
    }
    for (const auto& swing : slowMotion.swings())
        motion->add(swing.mode, swing.displacement, displacements);
    result.offsets =
        std::make_shared<const std::vector<ScenePlace>>(scene->offsetsOf(watched, displacements));
    return result;
}

bool ObjectView::moves() const {
    const bool swings = !slowMotion.atRest() && (showsVibration || showsNodes);
    return glow > 0 || shownMode || swings;
}

void ObjectView::wake() {
    if (moves() && isShowing() && !isTimerRunning())
        startTimerHz(framesPerSecond);
    else if (!isTimerRunning())
        redraw();
}

void ObjectView::timerCallback() {
    glow = scraping ? glow : glow * glowFallPerFrame;
    if (glow < faintestGlow)
        glow = 0;
    slowMotion.advance(1.0 / framesPerSecond);
    shownModePhase =
        std::remainder(shownModePhase + 2 * std::numbers::pi * modeSwingHz / framesPerSecond,
                       2 * std::numbers::pi);
    if (!moves() || !isShowing())
        stopTimer();
    redraw();
}

void ObjectView::cameraMoved() {
    if (showsPath || !drawn.empty())
        repaint();
    redraw();
}

void ObjectView::redraw() {
    std::optional<std::vector<SceneBody>> drawnBodies;
    if (onStage) {
        drawnBodies.emplace();
        for (const auto& body : bodies)
            drawnBodies->push_back(
                {.object = static_cast<std::size_t>(body.object), .pose = matrixOf(body)});
    }
    renderer.show({.scene = scene,
                   .viewProjection = camera.viewProjection(aspect()),
                   .eye = camera.eye(aspect()),
                   .background = colourOf(*this, LookColour::panel),
                   .accent = colourOf(*this, LookColour::accent),
                   .glowPlace = glowPlace,
                   .glow = glow,
                   .glowMetres = glowMetres,
                   .lights = lights,
                   .motion = scene == nullptr || scene->empty() ? std::nullopt : sceneMotion(),
                   .bodies = std::move(drawnBodies)});
    context.triggerRepaint();
}

void ObjectView::resized() {
    cameraMoved();
}

void ObjectView::lookAndFeelChanged() {
    cameraMoved();
}

void ObjectView::paint(juce::Graphics& g) {
    if (renderer.works()) {
        if (scene != nullptr && !scene->empty() && (showsPath || !drawn.empty())) {
            auto shown = path;
            if (!showsPath)
                shown.paths.clear();
            shown.paint(g, getLocalBounds().toFloat(), *scene, camera,
                        colourOf(*this, LookColour::accent), colourOf(*this, LookColour::text));
        }
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

} // namespace idiophone
