// Draws a scene with OpenGL, on the thread that OpenGL has for it.
#pragma once

#include "Editor/ObjectScene.h"

#include <array>
#include <atomic>
#include <juce_opengl/juce_opengl.h>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace idiophone {

/// How one object of the scene is moved out of its rest.
struct SceneMotion {
    std::size_t object = 0;
    /// A place of the scene for each of the object's vertices, to be added to its own. A new one is
    /// a new pointer.
    std::shared_ptr<const std::vector<ScenePlace>> offsets;
    float scale = 1;
    /// Where the offsets, 1 being the largest, go out and in are coloured apart, with lines where
    /// they do neither.
    bool showsNodes = false;
};

/// An object where its body is on a stage; as often as there are bodies.
struct SceneBody {
    std::size_t object = 0;
    std::array<float, 16> pose{}; ///< column-major
};

/// What one picture shows.
struct SceneFrame {
    std::shared_ptr<const ObjectScene> scene;
    std::array<float, 16> viewProjection{}; ///< column-major
    ScenePlace eye{};
    juce::Colour background, accent;
    ScenePlace glowPlace{};
    float glow = 0;            ///< of the place struck, 0 to 1
    float glowMetres = 0.01f;  ///< how far it reaches
    std::vector<float> lights; ///< of each object, how loud it is, 0 to 1; or empty
    std::optional<SceneMotion> motion;
    std::optional<std::vector<SceneBody>> bodies; ///< instead of every object once, as laid out
};

/// The message thread shows frames, the OpenGL thread draws the last one; a mutex is held while a
/// frame is copied, whose large parts are shared.
class PictureRenderer final : public juce::OpenGLRenderer {
public:
    explicit PictureRenderer(juce::OpenGLContext& drawsInto) : context(drawsInto) {}

    /// [message thread] To be drawn at the context's next repaint.
    void show(const SceneFrame& next);

    /// [any thread] Whether there is OpenGL that can draw.
    bool works() const { return ready; }

    void newOpenGLContextCreated() override;
    void renderOpenGL() override;
    void openGLContextClosing() override;

private:
    void upload(const ObjectScene& scene);
    void uploadOffsets(std::shared_ptr<const std::vector<ScenePlace>> offsets);
    void draw(const SceneFrame& shown);
    GLuint attribute(const char* name) const;
    void readVertices(std::size_t first) const;
    void drawObject(const SceneFrame& shown, std::size_t object, const std::array<float, 16>& pose);

    juce::OpenGLContext& context;
    std::mutex frameMutex;
    SceneFrame frame;
    std::atomic<bool> ready{false};

    // The OpenGL thread's.
    std::unique_ptr<juce::OpenGLShaderProgram> program;
    GLuint buffer = 0, offsetBuffer = 0;
    std::shared_ptr<const ObjectScene> uploaded;
    std::shared_ptr<const std::vector<ScenePlace>> uploadedOffsets;
};

} // namespace idiophone
