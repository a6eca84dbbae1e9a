// Draws a scene with OpenGL, on JUCE's OpenGL thread.
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

/// The displacement of one object of the scene.
struct SceneMotion {
    std::size_t object = 0;
    /// Offset of each scene vertex of the object. New offsets need a new pointer.
    std::shared_ptr<const std::vector<ScenePlace>> offsets;
    float scale = 1;
    /// Colours outward and inward motion differently, and draws nodal lines between them. The
    /// offsets must then have a maximum of 1.
    bool showsNodes = false;
};

/// One body on a stage: an object and its pose. Several bodies may share an object.
struct SceneBody {
    std::size_t object = 0;
    std::array<float, 16> pose{}; ///< column-major
};

struct SceneFrame {
    std::shared_ptr<const ObjectScene> scene;
    std::array<float, 16> viewProjection{}; ///< column-major
    ScenePlace eye{};
    juce::Colour background, accent;
    ScenePlace glowPlace{};
    float glow = 0;            ///< brightness of the struck place, 0 to 1
    float glowMetres = 0.01f;  ///< radius of the glow
    std::vector<float> lights; ///< loudness of each object, 0 to 1; or empty
    std::optional<SceneMotion> motion;
    std::optional<std::vector<SceneBody>> bodies; ///< if set, drawn instead of the objects
};

/// The message thread sets frames and the OpenGL thread draws the last one. A mutex is held only
/// while a frame is copied; the copies share large data.
class PictureRenderer final : public juce::OpenGLRenderer {
public:
    explicit PictureRenderer(juce::OpenGLContext& drawsInto) : context(drawsInto) {}

    /// [message thread] Sets the frame for the context's next repaint.
    void show(const SceneFrame& next);

    /// [any thread] Whether OpenGL works.
    bool works() const { return ready; }

    void newOpenGLContextCreated() override;
    void renderOpenGL() override;
    void openGLContextClosing() override;

private:
    void uploadOffsets(std::shared_ptr<const std::vector<ScenePlace>> offsets);
    void draw(const SceneFrame& shown);
    GLuint attribute(const char* name) const;
    void readVertices(std::size_t first) const;
    void drawObject(const SceneFrame& shown, std::size_t object, const std::array<float, 16>& pose);

    juce::OpenGLContext& context;
    std::mutex frameMutex;
    SceneFrame frame;
    std::atomic<bool> ready{false};

    // Used by the OpenGL thread only.
    std::unique_ptr<juce::OpenGLShaderProgram> program;
    GLuint buffer = 0, offsetBuffer = 0;
    std::shared_ptr<const ObjectScene> uploaded;
    std::shared_ptr<const std::vector<ScenePlace>> uploadedOffsets;
};

} // namespace idiophone
