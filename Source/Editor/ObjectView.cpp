#include "Editor/ObjectView.h"

#include "Editor/Look.h"
#include "Editor/OpenGlSupport.h"

#include <cmath>

namespace idiophone {
namespace {

constexpr int framesPerSecond = 30;
constexpr float glowFallPerFrame = 0.85f, faintestGlow = 0.01f;
constexpr int ticksToWait = 50; // of the window's timer, for a context to come
constexpr double softest = 45, hardest = 127;

int velocityOf(const ScenePick& pick) {
    return juce::roundToInt(softest + (hardest - softest) * pick.towardsPlayer);
}

} // namespace

ObjectView::ObjectView(ProcessorView& processor) : view(processor) {
    setTitle("Instrument");
    setDescription("Click to strike; drag beside it to turn, wheel to zoom");
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
    context.detach();
}

void ObjectView::refresh() {
    if (!renderer.works() && ticksWithoutContext < ticksToWait && isShowing() &&
        ++ticksWithoutContext == ticksToWait)
        repaint();
    if (const int playing = view.instrumentNumber(); playing != shownInstrument) {
        lift();
        shownInstrument = playing;
        scene = std::make_shared<const ObjectScene>(view.playedObjects());
        if (!scene->empty())
            camera.lookAt(scene->outline());
        glow = 0;
        redraw();
    }
}

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
    return scene->pick(ray.origin, ray.direction);
}

std::optional<ScenePick> ObjectView::strikeAt(juce::Point<float> position) {
    lift();
    struck = pickAt(position);
    if (struck) {
        view.strikeObject(struck->object, struck->pointMetres, velocityOf(*struck));
        glow = 1;
        glowPlace = struck->place;
        startTimerHz(framesPerSecond);
        redraw();
    }
    return struck;
}

void ObjectView::lift() {
    if (struck)
        view.strikeObject(struck->object, struck->pointMetres, 0);
    struck.reset();
}

void ObjectView::mouseDown(const juce::MouseEvent& event) {
    if (event.mods.isLeftButtonDown() && strikeAt(event.position))
        return;
    turningFrom = event.position;
}

void ObjectView::mouseDrag(const juce::MouseEvent& event) {
    if (!turningFrom)
        return;
    const auto moved =
        (event.position - *turningFrom) / static_cast<float>(juce::jmax(1, getHeight()));
    turningFrom = event.position;
    if (event.mods.isShiftDown() || event.mods.isMiddleButtonDown())
        camera.moveBy(moved.x, -moved.y);
    else
        camera.turnBy(-3 * moved.x, 3 * moved.y);
    redraw();
}

void ObjectView::mouseUp(const juce::MouseEvent&) {
    lift();
    turningFrom.reset();
}

void ObjectView::mouseDoubleClick(const juce::MouseEvent& event) {
    if (pickAt(event.position))
        return;
    camera.reset();
    redraw();
}

void ObjectView::mouseWheelMove(const juce::MouseEvent&, const juce::MouseWheelDetails& wheel) {
    camera.zoomBy(std::exp(0.8f * wheel.deltaY));
    redraw();
}

void ObjectView::timerCallback() {
    glow *= glowFallPerFrame;
    if (glow < faintestGlow) {
        glow = 0;
        stopTimer();
    }
    redraw();
}

void ObjectView::redraw() {
    renderer.show({.scene = scene,
                   .viewProjection = camera.viewProjection(aspect()),
                   .eye = camera.eye(aspect()),
                   .background = colourOf(*this, LookColour::panel),
                   .glowColour = colourOf(*this, LookColour::accent),
                   .glowPlace = glowPlace,
                   .glow = glow});
    context.triggerRepaint();
}

void ObjectView::resized() {
    redraw();
}

void ObjectView::lookAndFeelChanged() {
    redraw();
}

void ObjectView::paint(juce::Graphics& g) {
    if (renderer.works())
        return;
    g.fillAll(colourOf(*this, LookColour::panel));
    if (ticksWithoutContext < ticksToWait)
        return;
    g.setColour(colourOf(*this, LookColour::dimText));
    g.setFont(Look::textFont());
    g.drawFittedText("There is no OpenGL here to draw the instrument with. Everything else works.",
                     getLocalBounds().reduced(12), juce::Justification::centred, 2);
}

} // namespace idiophone
