#include "Editor/PictureRenderer.h"

#include "Editor/Shaders.h"

#include <Eigen/LU>
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

using namespace juce::gl;

namespace idiophone {
namespace {

constexpr GLint shadowUnit = 0, floorUnit = 1; // of textures

using Eigen::Vector3f;

Vector3f linear(const std::array<float, 3>& colour) {
    const auto channel = [](float value) { return value * value; }; // as `developed` in the shaders
    return {channel(colour[0]), channel(colour[1]), channel(colour[2])};
}

Vector3f linear(juce::Colour colour) {
    return linear(std::array{colour.getFloatRed(), colour.getFloatGreen(), colour.getFloatBlue()});
}

void set(juce::OpenGLShaderProgram& program, const char* name, const Vector3f& value) {
    program.setUniform(name, value.x(), value.y(), value.z());
}

void setMatrix(juce::OpenGLShaderProgram& program, const char* name, const Eigen::Matrix4f& value) {
    program.setUniformMat4(name, value.data(), 1, false);
}

Eigen::Matrix4f matrixOf(const std::array<float, 16>& columns) {
    return Eigen::Map<const Eigen::Matrix4f>(columns.data());
}

/// The radius of a box's edges in metres; 0 for other shapes.
float bevelOf(const SceneObject& shape) {
    constexpr float share = 0.2f, largest = 0.003f;
    return shape.form == Form::box ? std::min(share * std::ranges::min(shape.halfExtent), largest)
                                   : 0;
}

Vector3f longestAxis(const SceneObject& shape) {
    const auto longest = std::ranges::max_element(shape.halfExtent) - shape.halfExtent.begin();
    return Vector3f::Unit(longest);
}

} // namespace

void PictureRenderer::show(const SceneFrame& next) {
    const std::scoped_lock lock(frameMutex);
    frame = next;
}

void PictureRenderer::newOpenGLContextCreated() {
    for (std::size_t finish = 0; finish < finishCount; ++finish) {
        finishPrograms[finish] =
            linkedProgram(context, "scene.vert", "scene.frag", "FINISH " + std::to_string(finish));
        if (!finishPrograms[finish])
            return;
    }
    backdropProgram = linkedProgram(context, "backdrop.vert", "backdrop.frag");
    depthProgram = linkedProgram(context, "depth.vert", "depth.frag");
    if (!backdropProgram || !depthProgram)
        return;
    buffers.create();
    ready = true;
}

void PictureRenderer::renderOpenGL() {
    SceneFrame shown;
    {
        const std::scoped_lock lock(frameMutex);
        shown = frame;
    }
    juce::OpenGLHelpers::clear(shown.background);
    if (!ready || shown.scene == nullptr || shown.scene->empty())
        return;
    GLint view[4]; // x, y, width and height of the window in pixels
    glGetIntegerv(GL_VIEWPORT, view);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    if (uploaded != shown.scene)
        upload(shown);
    if (const auto* light = floorLight.takeUploaded(); light != nullptr && !shown.bodies)
        uploadSky(shown, light->sky);
    if (shown.motion && shown.motion->offsets != uploadedOffsets) {
        buffers.uploadOffsets(*shown.motion->offsets);
        uploadedOffsets = shown.motion->offsets;
    }
    const auto parts = partsOf(shown);
    buffers.bind();
    const bool movesCasters = shown.bodies || !shown.mallets.empty();
    if (auto casters = shadowCasters(parts); movesCasters || casters != mappedCasters) {
        drawShadows(parts, casters);
        mappedCasters = movesCasters ? std::vector<bool>() : std::move(casters);
    }
    glViewport(0, 0, view[2], view[3]);
    if (image.begin(view[2], view[3])) {
        glClear(GL_DEPTH_BUFFER_BIT);
        drawSolids(shown, parts);
        drawBackdrop(shown); // after the solids, whose pixels it need not compute
        drawGlass(shown, parts);
        image.finish();
    } else {
        ready = false; // the view paints its plain picture
    }
    buffers.unbind();
    glDisable(GL_DEPTH_TEST);
    glViewport(view[0], view[1], view[2], view[3]);
}

void PictureRenderer::upload(const SceneFrame& shown) {
    std::vector<SceneVertex> vertices(shown.scene->vertices().begin(),
                                      shown.scene->vertices().end());
    const auto& furniture = shown.furniture->vertices();
    vertices.insert(vertices.end(), furniture.begin(), furniture.end());
    buffers.upload(vertices);
    uploaded = shown.scene;
    mappedCasters.clear();
    buffers.uploadSky({});
    floorLight.begin(shown);
}

/// Takes the share of the sky at the vertices of objects and furniture at rest.
void PictureRenderer::uploadSky(const SceneFrame& shown, std::vector<std::uint8_t> sky) {
    sky.resize(shown.scene->vertices().size() + shown.furniture->vertices().size(), 255);
    buffers.uploadSky(sky);
}

/// Draws the depths seen from the lamp, in a cube around the scene.
void PictureRenderer::drawShadows(std::span<const PicturePart> parts,
                                  const std::vector<bool>& casters) {
    const Vector3f lamp = vectorOf(SceneLight::lamp).normalized();
    const Vector3f right = lamp.unitOrthogonal(), up = lamp.cross(right);
    const float reach = floorLight.reach();
    fromLamp.setIdentity();
    for (int row = 0; const Vector3f& axis : {right, up, Vector3f(-lamp)})
        fromLamp.row(row++) << axis.transpose() / reach, -axis.dot(floorLight.middle()) / reach;
    if (!shadows.begin())
        return;
    depthProgram->use();
    setMatrix(*depthProgram, "viewProjection", fromLamp);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!casters[i])
            continue;
        setMatrix(*depthProgram, "pose", parts[i].pose);
        buffers.draw(parts[i].shape.firstVertex, parts[i].shape.vertexCount);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    shadows.finish();
}

void PictureRenderer::setLook(juce::OpenGLShaderProgram& program, const SceneFrame& shown) const {
    program.use();
    program.setUniform("dark", shown.isDark ? 1.0f : 0.0f);
    set(program, "backdrop", linear(shown.background));
    set(program, "eye", vectorOf(shown.eye));
}

void PictureRenderer::drawBackdrop(const SceneFrame& shown) {
    auto& program = *backdropProgram;
    setLook(program, shown);
    const Eigen::Matrix4f toScene = matrixOf(shown.viewProjection).inverse();
    const auto rayThrough = [&](float x, float y) -> Vector3f {
        return (toScene * Eigen::Vector4f(x, y, 1, 1)).hnormalized() - vectorOf(shown.eye);
    };
    const Vector3f straight = rayThrough(0, 0);
    set(program, "rayMiddle", straight);
    set(program, "rayRight", rayThrough(1, 0) - straight);
    set(program, "rayUp", rayThrough(0, 1) - straight);
    const auto& area = floorLight.area();
    program.setUniform("floorHeight", area.height);
    set(program, "middle", floorLight.middle());
    program.setUniform("reach", floorLight.reach());
    program.setUniform("floorLight", floorUnit);
    program.setUniform("floorArea", area.left, area.front, area.width, area.depth);
    program.setUniform("usesMap", shown.bodies || !floorLight.isComplete() ? 1.0f : 0.0f);
    setShadows(program);
    glActiveTexture(GL_TEXTURE0 + floorUnit);
    floorLight.bindTexture();
    glActiveTexture(GL_TEXTURE0);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL); // at the far end of the depths
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
}

void PictureRenderer::setShadows(juce::OpenGLShaderProgram& program) const {
    program.setUniform("shadowMap", shadowUnit);
    setMatrix(program, "shadowFrom", fromLamp);
    program.setUniform("shadowTexel", 2 * floorLight.reach() / float(ShadowMap::size));
}

/// Sets what all parts of a finish share.
void PictureRenderer::prepare(juce::OpenGLShaderProgram& program, const SceneFrame& shown) const {
    setLook(program, shown);
    setMatrix(program, "viewProjection", matrixOf(shown.viewProjection));
    set(program, "accent", linear(shown.accent));
    set(program, "ink",
        vectorOf({shown.background.getFloatRed(), shown.background.getFloatGreen(),
                  shown.background.getFloatBlue()}));
    setShadows(program);
}

void PictureRenderer::drawSolids(const SceneFrame& shown, std::span<const PicturePart> parts) {
    shadows.bindTexture();
    for (std::size_t finish = 0; finish < finishCount; ++finish) {
        std::vector<PicturePart> own;
        std::ranges::copy_if(parts, std::back_inserter(own), [&](const PicturePart& part) {
            return static_cast<std::size_t>(part.look.finish) == finish;
        });
        if (own.empty() || finish == static_cast<std::size_t>(Finish::glass))
            continue;
        // Near parts first: hidden pixels are not computed.
        std::ranges::sort(own, {}, [eye = vectorOf(shown.eye)](const PicturePart& part) {
            const Eigen::Vector4f middle = vectorOf(part.shape.middle).homogeneous();
            return ((part.pose * middle).head<3>() - eye).squaredNorm();
        });
        prepare(*finishPrograms[finish], shown);
        for (const auto& part : own)
            drawPart(shown, part);
    }
}

/// Draws the far walls of glass, then the near ones.
void PictureRenderer::drawGlass(const SceneFrame& shown, std::span<const PicturePart> parts) {
    prepare(*finishPrograms[static_cast<std::size_t>(Finish::glass)], shown);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glEnable(GL_CULL_FACE);
    for (const auto hidden : {GL_FRONT, GL_BACK}) {
        glCullFace(hidden);
        for (const auto& part : parts)
            if (part.look.finish == Finish::glass)
                drawPart(shown, part);
    }
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void PictureRenderer::drawPart(const SceneFrame& shown, const PicturePart& part) {
    auto& program = *finishPrograms[static_cast<std::size_t>(part.look.finish)];
    const auto& shape = part.shape;
    const bool moves = part.object && shown.motion && shown.motion->object == *part.object &&
                       shown.motion->offsets->size() == shape.vertexCount;
    setMatrix(program, "pose", part.pose);
    set(program, "colour", linear(part.look.colour));
    set(program, "boxMiddle", vectorOf(shape.middle));
    set(program, "boxHalf", vectorOf(shape.halfExtent));
    program.setUniform("bevel", bevelOf(shape));
    set(program, "along", longestAxis(shape));
    program.setUniform("turned", shape.form == Form::turned ? 1.0f : 0.0f);
    program.setUniform("seed", float(part.number % 61) + 0.5f);
    const auto glow =
        part.object && *part.object < shown.glows.size() ? shown.glows[*part.object] : ObjectGlow{};
    set(program, "glowPlace", vectorOf(glow.place));
    program.setUniform("glow", glow.brightness);
    program.setUniform("glowRadius", glow.metres);
    program.setUniform("offsetScale", moves ? shown.motion->scale : 0.0f);
    program.setUniform("nodes", moves && shown.motion->showsNodes ? 1.0f : 0.0f);
    if (shape.isClosed)
        glEnable(GL_CULL_FACE); // its far side is hidden
    if (moves)
        buffers.drawMoved(shape.firstVertex, shape.vertexCount);
    else
        buffers.draw(shape.firstVertex, shape.vertexCount);
    if (part.look.finish != Finish::glass)
        glDisable(GL_CULL_FACE);
}

void PictureRenderer::openGLContextClosing() {
    ready = false;
    for (auto& program : finishPrograms)
        program.reset();
    backdropProgram.reset();
    depthProgram.reset();
    buffers.release();
    image.release();
    shadows.release();
    floorLight.release();
    uploaded.reset();
    uploadedOffsets.reset();
}

} // namespace idiophone
