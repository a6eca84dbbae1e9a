// The instrument in three dimensions: what is seen can be struck. Clicks strike, dragging beside
// the objects or with the right button turns the view, the wheel zooms.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"
#include "Editor/ProcessorView.h"
#include "Editor/SceneRenderer.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <juce_opengl/juce_opengl.h>
#include <memory>
#include <optional>

namespace idiophone {

/// Draws only what changed, and nothing while nothing moves. Where there is no OpenGL it says so.
class ObjectView final : public juce::Component, private juce::Timer {
public:
    explicit ObjectView(ProcessorView& view);
    ~ObjectView() override;

    /// Follows the instrument that plays. For the window's timer.
    void refresh();

    /// Strikes what is seen at a place of the component, or nothing where only the background is.
    /// The lower on the object as seen from the player, the harder.
    std::optional<ScenePick> strikeAt(juce::Point<float> position);
    /// Lifts the hand from what was struck last.
    void lift();

    void paint(juce::Graphics& g) override;
    void resized() override;
    void lookAndFeelChanged() override;
    void mouseDown(const juce::MouseEvent& event) override;
    void mouseDrag(const juce::MouseEvent& event) override;
    void mouseUp(const juce::MouseEvent& event) override;
    void mouseDoubleClick(const juce::MouseEvent& event) override;
    void mouseWheelMove(const juce::MouseEvent& event,
                        const juce::MouseWheelDetails& wheel) override;

private:
    void timerCallback() override;
    float aspect() const;
    std::optional<ScenePick> pickAt(juce::Point<float> position) const;
    void redraw();

    ProcessorView& view;
    int shownInstrument = -1;
    std::shared_ptr<const ObjectScene> scene;
    OrbitCamera camera;
    juce::OpenGLContext context;
    SceneRenderer renderer{context};
    std::optional<ScenePick> struck; ///< and held
    std::optional<juce::Point<float>> turningFrom;
    float glow = 0; ///< of the struck place, 1 at the blow
    ScenePlace glowPlace{};
    int ticksWithoutContext = 0;
};

} // namespace idiophone
