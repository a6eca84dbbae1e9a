// The 3D view of the instrument. Clicks strike, drags over an object scrape it, and drags beside
// the objects or with the right button turn the view. On a stage, clicks set bodies in motion.
#pragma once

#include "Editor/HeldBrush.h"
#include "Editor/HoverOutline.h"
#include "Editor/ObjectHand.h"
#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"
#include "Editor/PathOverlay.h"
#include "Editor/PictureRenderer.h"
#include "Editor/ProcessorView.h"
#include "Editor/ShownInstrument.h"
#include "Editor/StrikePicture.h"
#include "Editor/VibrationPicture.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <juce_opengl/juce_opengl.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// Draws only when something has changed or moves. Without OpenGL the picture is plain.
class ObjectView final : public juce::Component, public juce::TooltipClient, private juce::Timer {
public:
    struct Layers {
        bool vibration = true;
        bool nodes = false;      ///< nodal lines, see VibrationPicture
        bool path = false;       ///< where the keys strike
        bool drawsPath = false;  ///< drags draw a new strike path instead of scraping
        bool held = false;       ///< where objects are held
        bool paintsHeld = false; ///< drags set where the object is held instead of scraping

        bool draws() const { return drawsPath || paintsHeld; }
    };

    explicit ObjectView(ProcessorView& view);
    ~ObjectView() override;

    /// Follows the current instrument. The window's timer calls it.
    void refresh();
    /// Lights up the resonators, and animates the object whose modes the frame has.
    void showSound(const SoundFrame& frame);
    /// Shows the shape of one mode of the last frame's object, or none.
    void showMode(std::optional<std::size_t> mode);
    void setLayers(const Layers& wanted);
    /// Shows the whole instrument from the usual direction.
    void frame() {
        camera.reset();
        cameraMoved();
    }

    /// Whether the instrument is on a stage, where keys set bodies in motion.
    bool isOnStage() const { return shown.onStage; }

    /// Strikes the object at a position of the component, see ObjectHand. Returns nothing on the
    /// background.
    std::optional<ScenePick> strikeAt(juce::Point<float> position, double pixelsPerSecond = 0);
    void lift() { hand.lift(); }

    juce::String getTooltip() override {
        return layers.paintsHeld && !shown.onStage
                   ? HeldBrush::hint
                   : ObjectHand::hint(shown.onStage, layers.drawsPath);
    }
    void paint(juce::Graphics& g) override;
    void resized() override { cameraMoved(); }
    void lookAndFeelChanged() override { cameraMoved(); }
    void mouseMove(const juce::MouseEvent& event) override;
    void mouseExit(const juce::MouseEvent&) override { hover(std::nullopt); }
    void mouseDown(const juce::MouseEvent& event) override;
    void mouseDrag(const juce::MouseEvent& event) override;
    void mouseUp(const juce::MouseEvent& event) override;
    void mouseDoubleClick(const juce::MouseEvent& event) override;
    void mouseWheelMove(const juce::MouseEvent& event,
                        const juce::MouseWheelDetails& wheel) override;

private:
    void timerCallback() override;
    void newScene();
    void followMaterial();
    float aspect() const {
        return static_cast<float>(juce::jmax(1, getWidth())) /
               static_cast<float>(juce::jmax(1, getHeight()));
    }
    std::optional<ScenePick> pickAt(juce::Point<float> position) const;
    int noteFor(std::size_t object) const;
    bool isDrawing() const { return paths.isDrawing() || brush.isDrawing(); }
    void drawTo(const juce::MouseEvent& event);
    bool moves() const { return strikes.moves() || vibration.moves(); }
    void hover(std::optional<ScenePick> pick);
    void wake();
    void cameraMoved();
    SceneFrame frameNow();
    void redraw();

    ProcessorView& view;
    int shownInstrument = -1;
    std::string shownPreset; ///< its name
    ShownInstrument shown;
    std::vector<Appearance> appearances; ///< of each object, by the current material
    OrbitCamera camera;
    PathOverlay paths;
    HeldBrush brush;
    juce::OpenGLContext context;
    PictureRenderer renderer{context};
    int ticksWithoutContext = 0;
    StrikePicture strikes;
    VibrationPicture vibration;
    Layers layers;

    // Mouse input.
    ObjectHand hand;
    HoverOutline outline;
    std::optional<juce::Point<float>> turningFrom;
    juce::Point<float> cameFrom;
    juce::Time cameAt;
    double cameAtPixelsPerSecond = 0;
};

} // namespace idiophone
