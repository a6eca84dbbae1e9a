// The instrument in three dimensions: what is seen can be struck and scraped. Clicks strike, drags
// over an object scrape it, drags beside the objects or with the right button turn the view. On a
// stage clicks set its bodies in motion.
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

/// Draws only what changed, and nothing while nothing moves. Where there is no OpenGL it says so.
class ObjectView final : public juce::Component, private juce::Timer {
public:
    static constexpr double defaultPressure = 0.7; ///< of a mouse, which feels none

    explicit ObjectView(ProcessorView& view);
    ~ObjectView() override;

    /// Follows the instrument that plays. For the window's timer.
    void refresh();
    /// What sounds lights up; the object whose modes these are is seen to vibrate.
    void showSound(const SoundFrame& frame);
    /// Shows the shape of one mode of the object whose modes were shown last, or of none.
    void showMode(std::optional<std::size_t> mode);

    /// Whether there are bodies that keys set in motion.
    bool isOnStage() const { return onStage; }

    /// Sounding objects are seen to vibrate.
    void setShowsVibration(bool shows);
    /// The strongest mode of the object that sounds, or else its lowest, with its nodal lines.
    void setShowsNodes(bool shows);
    /// Where the keys strike.
    void setShowsPath(bool shows);
    /// While it is on, drags draw the strike path anew instead of scraping.
    void setDrawsPath(bool draws);

    /// Strikes what is seen at a place of the component, or nothing where only the background is:
    /// the lower on the object as seen from the player, or the faster the mouse came, the harder.
    std::optional<ScenePick> strikeAt(juce::Point<float> position, double pixelsPerSecond = 0);
    /// Drags from the place struck or dragged to last to another one; an object that is entered on
    /// the way is struck there.
    void dragTo(juce::Point<float> position, double pressure = defaultPressure);
    /// Lifts the hand.
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
    std::vector<ProcessorView::PlayedObject> played;
    std::shared_ptr<const ObjectScene> scene;
    bool onStage = false;
    std::vector<BodyNow> bodies; ///< on a stage, as seen now
    float glowMetres = 0.01f;
    OrbitCamera camera;
    PathOverlay path;
    juce::OpenGLContext context;
    PictureRenderer renderer{context};
    int ticksWithoutContext = 0;

    // The hand.
    std::optional<ScenePick> struck; ///< and held
    bool scraping = false;
    std::optional<juce::Point<float>> turningFrom;
    juce::Point<float> cameFrom;
    juce::Time cameAt;
    double cameAtPixelsPerSecond = 0;
    float glow = 0; ///< of the place touched, 1 at the blow
    ScenePlace glowPlace{};
    std::vector<std::array<double, 3>> drawn; ///< of the path that is being drawn
    std::optional<std::size_t> drawnOn;

    // What vibrates.
    std::vector<float> lights;
    SlowMotion slowMotion;
    std::size_t watched = 0; ///< the object whose modes `slowMotion` shows
    std::map<std::size_t, SurfaceMotion> surfaceMotions;
    std::optional<std::size_t> shownMode;
    double shownModePhase = 0; ///< radians
    /// The shape of a mode, kept while it is shown.
    std::shared_ptr<const std::vector<ScenePlace>> shapeOffsets;
    std::pair<std::size_t, std::size_t> shapeOf{}; ///< object and mode of `shapeOffsets`

    bool showsVibration = true, showsNodes = false, showsPath = false, drawsPath = false;
};

} // namespace idiophone
