// Draws a scene with OpenGL, on JUCE's OpenGL thread.
#pragma once

#include "Editor/FloorLight.h"
#include "Editor/PictureParts.h"
#include "Editor/PictureTargets.h"
#include "Editor/SceneBuffers.h"
#include "Editor/SceneFrame.h"

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <juce_opengl/juce_opengl.h>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace idiophone {

/// The message thread sets frames and the OpenGL thread draws the last one. A mutex is held only
/// while a frame is copied; the copies share large data. JUCE may hold the message lock during
/// `renderOpenGL`, so the light is computed elsewhere: the first pictures of a scene lack it.
class PictureRenderer final : public juce::OpenGLRenderer, private juce::AsyncUpdater {
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
    void handleAsyncUpdate() override { context.triggerRepaint(); }
    void upload(const SceneFrame& shown);
    void uploadSky(const SceneFrame& shown, std::vector<std::uint8_t> sky);
    void drawShadows(std::span<const PicturePart> parts, const std::vector<bool>& casters);
    void drawBackdrop(const SceneFrame& shown);
    void drawSolids(const SceneFrame& shown, std::span<const PicturePart> parts);
    void prepare(juce::OpenGLShaderProgram& program, const SceneFrame& shown) const;
    void drawGlass(const SceneFrame& shown, std::span<const PicturePart> parts);
    void drawPart(const SceneFrame& shown, const PicturePart& part);
    void setLook(juce::OpenGLShaderProgram& program, const SceneFrame& shown) const;
    void setShadows(juce::OpenGLShaderProgram& program) const;

    juce::OpenGLContext& context;
    std::mutex frameMutex;
    SceneFrame frame;
    std::atomic<bool> ready{false};

    // Used by the OpenGL thread only.
    /// One for each finish, because software renderers compute all branches of a shader.
    std::array<std::unique_ptr<juce::OpenGLShaderProgram>, finishCount> finishPrograms;
    std::unique_ptr<juce::OpenGLShaderProgram> backdropProgram, depthProgram;
    SceneBuffers buffers;
    MultisampledImage image;
    ShadowMap shadows;
    FloorLight floorLight{[this] { triggerAsyncUpdate(); }};
    Eigen::Matrix4f fromLamp = Eigen::Matrix4f::Identity(); ///< scene to shadow map
    std::vector<bool> mappedCasters; ///< parts in the shadow map; empty: draw it anew
    std::shared_ptr<const ObjectScene> uploaded;
    std::shared_ptr<const std::vector<ScenePlace>> uploadedOffsets;
};

} // namespace idiophone
