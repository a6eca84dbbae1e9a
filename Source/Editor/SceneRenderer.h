// Draws a scene with OpenGL, on the thread that OpenGL has for it.
#pragma once

#include "Editor/ObjectScene.h"

#include <array>
#include <atomic>
#include <juce_opengl/juce_opengl.h>
#include <memory>
#include <mutex>

namespace idiophone {

/// What one picture shows.
struct SceneFrame {
    std::shared_ptr<const ObjectScene> scene;
    std::array<float, 16> viewProjection{}; ///< column-major
    ScenePlace eye{};
    juce::Colour background, glowColour;
    ScenePlace glowPlace{};
    float glow = 0; ///< 0 to 1
};

/// The message thread shows frames, the OpenGL thread draws the last one; a mutex is held while the
/// frame, a few words, is copied.
class SceneRenderer final : public juce::OpenGLRenderer {
public:
    explicit SceneRenderer(juce::OpenGLContext& drawsInto) : context(drawsInto) {}

    /// [message thread] To be drawn at the context's next repaint.
    void show(const SceneFrame& next);

    /// [any thread] Whether there is OpenGL that can draw.
    bool works() const { return ready; }

    void newOpenGLContextCreated() override;
    void renderOpenGL() override;
    void openGLContextClosing() override;

private:
    void upload(const ObjectScene& scene);

    juce::OpenGLContext& context;
    std::mutex frameMutex;
    SceneFrame frame;
    std::atomic<bool> ready{false};

    // The OpenGL thread's.
    std::unique_ptr<juce::OpenGLShaderProgram> program;
    GLuint buffer = 0;
    std::shared_ptr<const ObjectScene> uploaded;
};

} // namespace idiophone
