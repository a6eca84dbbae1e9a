// The 3D view of the instrument. Clicks strike, drags over an object scrape it, and drags beside
// the objects or with the right button turn the view. On a stage, clicks set bodies in motion.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"
#include "Editor/PathOverlay.h"
#include "Editor/PictureRenderer.h"
#include "Editor/ProcessorView.h"
#include "Editor/SlowMotion.h"
#include "Editor/SurfaceMotion.h"

#include <array>
#include <juce_gui_basics/juce_gui_basics.h>
#include <juce_opengl/juce_opengl.h>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace idiophone {

/// Draws only when something changed or moves. Shows a message if there is no OpenGL.
class ObjectView final : public juce::Component, private juce::Timer {
public:
    static constexpr double defaultPressure = 0.7; ///< for a mouse, which has no pressure

    explicit ObjectView(ProcessorView& view);
    ~ObjectView() override;

    /// Follows the current instrument. The window's timer calls it.
    void refresh();
    /// Lights up the resonators, and animates the object whose modes the frame has.
    void showSound(const SoundFrame& frame);
    /// Shows the shape of one mode of the last frame's object, or none.
    void showMode(std::optional<std::size_t> mode);

    /// Whether the instrument is on a stage, where keys set bodies in motion.
    bool isOnStage() const { return onStage; }

    void setShowsVibration(bool shows);
    /// Shows the nodal lines of the resonator's strongest mode, or of its lowest mode in
    /// silence.
    void setShowsNodes(bool shows);
    void setShowsPath(bool shows);
    /// While on, drags draw a new strike path instead of scraping.
    void setDrawsPath(bool draws);

    /// Strikes the object at a position of the component. Lower on the object (nearer to the
    /// player) or a faster mouse is harder. Returns nothing on the background.
    std::optional<ScenePick> strikeAt(juce::Point<float> position, double pixelsPerSecond = 0);
    /// Scrapes from the last position to this one. An object entered on the way is struck.
    void dragTo(juce::Point<float> position, double pressure = defaultPressure);
    /// Releases the object that is struck or scraped.
    void lift();

    void paint(juce::Graphics& g) override;
    void resized() override;
    void lookAndFeelChanged() override;
    void mouseMove(const juce::MouseEvent& event) override;
    void mouseDown(const juce::MouseEvent& event) override;
    void mouseDrag(const juce::MouseEvent& event) override;
    void mouseUp(const juce::MouseEvent& event) override;
    void mouseDoubleClick(const juce::MouseEvent& event) override;
    void mouseWheelMove(const juce::MouseEvent& event,
                        const juce::MouseWheelDetails& wheel) override;

private:
    void timerCallback() override;
    void newScene();
    float aspect() const;
    std::optional<ScenePick> pickAt(juce::Point<float> position) const;
    void strike(const ScenePick& pick, double pixelsPerSecond);
    int noteFor(std::size_t object) const;
    void drawTo(juce::Point<float> position);
    void finishPath();
    const SurfaceMotion* motionOf(std::size_t object);
    std::optional<std::size_t> modeWithNodes() const;
    std::optional<SceneMotion> sceneMotion();
    bool moves() const;
    void wake();
    void cameraMoved();
    void redraw();

    ProcessorView& view;
    int shownInstrument = -1;
    std::vector<InstrumentView::PlayedObject> played;
    std::shared_ptr<const ObjectScene> scene;
    bool onStage = false;
    std::vector<BodyNow> bodies; ///< on a stage: bodies as drawn
    float glowMetres = 0.01f;
    OrbitCamera camera;
    PathOverlay path;
    juce::OpenGLContext context;
    PictureRenderer renderer{context};
    int ticksWithoutContext = 0;

    // Mouse input.
    std::optional<ScenePick> struck; ///< last strike, while the button is down
    bool scraping = false;
    std::optional<juce::Point<float>> turningFrom;
    juce::Point<float> cameFrom;
    juce::Time cameAt;
    double cameAtPixelsPerSecond = 0;
    float glow = 0; ///< brightness of the touched place, 1 at the strike
    ScenePlace glowPlace{};
    std::vector<std::array<double, 3>> drawn; ///< points of the path being drawn
    std::optional<std::size_t> drawnOn;

    // Vibration.
    std::vector<float> lights;
    SlowMotion slowMotion;
    std::size_t watched = 0; ///< index of the object in `slowMotion`
    std::map<std::size_t, SurfaceMotion> surfaceMotions;
    std::optional<std::size_t> shownMode;
    double shownModePhase = 0; ///< radians
    std::shared_ptr<const std::vector<ScenePlace>> shapeOffsets;
    std::pair<std::size_t, std::size_t> shapeOf{}; ///< object and mode of `shapeOffsets`

    bool showsVibration = true, showsNodes = false, showsPath = false, drawsPath = false;
};

} // namespace idiophone
