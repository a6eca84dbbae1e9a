#include "Editor/PictureRenderer.h"

#include <cstddef>
#include <span>
#include <utility>

using namespace juce::gl;

namespace idiophone {
namespace {

constexpr const char* vertexShader = R"(
attribute vec3 place;
attribute vec3 normal;
attribute vec3 offset;
uniform mat4 viewProjection;
uniform mat4 pose;
uniform float offsetScale;
varying vec3 seenPlace;
varying vec3 seenNormal;
varying float outward;

void main()
{
    vec4 moved = pose * vec4(place + offsetScale * offset, 1.0);
    seenPlace = moved.xyz;
    seenNormal = (pose * vec4(normal, 0.0)).xyz;
    outward = dot(offset, normal);
    gl_Position = viewProjection * moved;
}
)";

// The shader has two lamps, a gloss and a rim, and lights both sides of a sheet. `glow` marks the
// struck place, and `light` shows the loudness of the object.
constexpr const char* fragmentShader = R"(
uniform vec3 colour;
uniform vec3 eye;
uniform vec3 glowPlace;
uniform vec3 accent;
uniform vec3 ink;
uniform float glow;
uniform float glowRadius;
uniform float light;
uniform float nodes;
varying vec3 seenPlace;
varying vec3 seenNormal;
varying float outward;

void main()
{
    vec3 view = normalize(eye - seenPlace);
    vec3 n = normalize(seenNormal);
    if (dot(n, view) < 0.0)
        n = -n;
    vec3 key = normalize(vec3(-0.4, -0.5, 0.8));
    vec3 fill = normalize(vec3(0.8, 0.3, 0.3));
    float diffuse = 0.28 + 0.62 * max(dot(n, key), 0.0) + 0.18 * max(dot(n, fill), 0.0);
    float gloss = pow(max(dot(n, normalize(key + view)), 0.0), 40.0);
    float rim = pow(1.0 - max(dot(n, view), 0.0), 3.0);
    vec3 off = (seenPlace - glowPlace) / glowRadius;

    float far = clamp(outward, -1.0, 1.0);
    vec3 swing = far > 0.0 ? vec3(0.90, 0.38, 0.25) : vec3(0.25, 0.52, 0.90);
    vec3 own = mix(colour, swing, nodes * 0.85 * sqrt(abs(far)));
    float width = 1.5 * fwidth(far);
    float node = nodes * (1.0 - smoothstep(0.5 * width, width + 1e-6, abs(far)));
    own = mix(own, ink, node);

    vec3 lit = own * diffuse + vec3(0.22 * gloss + 0.08 * rim);
    lit += accent * (0.35 * light + glow * exp(-dot(off, off)));
    gl_FragColor = vec4(lit, 1.0);
}
)";

constexpr std::array<float, 16> asLaidOut{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

} // namespace

void PictureRenderer::show(const SceneFrame& next) {
    const std::scoped_lock lock(frameMutex);
    frame = next;
}

void PictureRenderer::newOpenGLContextCreated() {
    auto made = std::make_unique<juce::OpenGLShaderProgram>(context);
    using juce::OpenGLHelpers;
    if (!made->addVertexShader(OpenGLHelpers::translateVertexShaderToV3(vertexShader)) ||
        !made->addFragmentShader(OpenGLHelpers::translateFragmentShaderToV3(fragmentShader)))
        return;
    // Attribute 0 must always be read from a buffer.
    glBindAttribLocation(made->getProgramID(), 0, "place");
    if (!made->link())
        return;
    program = std::move(made);
    glGenBuffers(1, &buffer);
    glGenBuffers(1, &offsetBuffer);
    ready = true;
}

void PictureRenderer::renderOpenGL() {
    SceneFrame shown;
    {
        const std::scoped_lock lock(frameMutex);
        shown = frame;
    }
    juce::OpenGLHelpers::clear(shown.background);
    glClear(GL_DEPTH_BUFFER_BIT);
    if (!ready || shown.scene == nullptr || shown.scene->empty())
        return;

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    if (uploaded != shown.scene) {
        const auto vertices = shown.scene->vertices();
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()),
                     vertices.data(), GL_STATIC_DRAW);
        uploaded = shown.scene;
    }
    if (shown.motion && shown.motion->offsets != uploadedOffsets)
        uploadOffsets(shown.motion->offsets);
    draw(shown);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDisable(GL_DEPTH_TEST);
}

void PictureRenderer::uploadOffsets(std::shared_ptr<const std::vector<ScenePlace>> offsets) {
    glBindBuffer(GL_ARRAY_BUFFER, offsetBuffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(std::span(*offsets).size_bytes()),
                 offsets->data(), GL_STREAM_DRAW);
    uploadedOffsets = std::move(offsets);
}

void PictureRenderer::draw(const SceneFrame& shown) {
    program->use();
    const auto set = [&](const char* name, const ScenePlace& value) {
        program->setUniform(name, value[0], value[1], value[2]);
    };
    const auto setColour = [&](const char* name, juce::Colour colour) {
        set(name, {colour.getFloatRed(), colour.getFloatGreen(), colour.getFloatBlue()});
    };
    program->setUniformMat4("viewProjection", shown.viewProjection.data(), 1, false);
    set("eye", shown.eye);
    set("glowPlace", shown.glowPlace);
    setColour("accent", shown.accent);
    setColour("ink", shown.background);
    program->setUniform("glow", shown.glow);
    program->setUniform("glowRadius", shown.glowMetres);

    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    readVertices(0);
    if (shown.bodies) {
        for (const auto& body : *shown.bodies)
            if (body.object < shown.scene->objects().size())
                drawObject(shown, body.object, body.pose);
    } else
        for (std::size_t i = 0; i < shown.scene->objects().size(); ++i)
            drawObject(shown, i, asLaidOut);
    glDisableVertexAttribArray(attribute("place"));
    glDisableVertexAttribArray(attribute("normal"));
}

GLuint PictureRenderer::attribute(const char* name) const {
    return static_cast<GLuint>(glGetAttribLocation(program->getProgramID(), name));
}

/// Binds the attributes to the vertices of the bound buffer, from vertex `first` on.
void PictureRenderer::readVertices(std::size_t first) const {
    for (const auto& [name, part] : {std::pair("place", offsetof(SceneVertex, place)),
                                     {"normal", offsetof(SceneVertex, normal)}}) {
        glEnableVertexAttribArray(attribute(name));
        glVertexAttribPointer(attribute(name), 3, GL_FLOAT, GL_FALSE, sizeof(SceneVertex),
                              reinterpret_cast<const void*>(first * sizeof(SceneVertex) + part));
    }
}

void PictureRenderer::drawObject(const SceneFrame& shown,
                                 std::size_t index,
                                 const std::array<float, 16>& pose) {
    const auto& object = shown.scene->objects()[index];
    const auto offset = attribute("offset");
    const bool moves = shown.motion && shown.motion->object == index &&
                       shown.motion->offsets->size() == object.vertexCount;
    program->setUniformMat4("pose", pose.data(), 1, false);
    program->setUniform("colour", object.colour[0], object.colour[1], object.colour[2]);
    program->setUniform("light", index < shown.lights.size() ? shown.lights[index] : 0.0f);
    program->setUniform("offsetScale", moves ? shown.motion->scale : 0.0f);
    program->setUniform("nodes", moves && shown.motion->showsNodes ? 1.0f : 0.0f);
    const auto count = static_cast<GLsizei>(object.vertexCount);
    if (!moves) {
        glVertexAttrib3f(offset, 0, 0, 0);
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(object.firstVertex), count);
        return;
    }
    // The offset buffer holds only this object's vertices, so read places and normals from its
    // first vertex too.
    glBindBuffer(GL_ARRAY_BUFFER, offsetBuffer);
    glEnableVertexAttribArray(offset);
    glVertexAttribPointer(offset, 3, GL_FLOAT, GL_FALSE, sizeof(ScenePlace), nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    readVertices(object.firstVertex);
    glDrawArrays(GL_TRIANGLES, 0, count);
    glDisableVertexAttribArray(offset);
    readVertices(0);
}

void PictureRenderer::openGLContextClosing() {
    ready = false;
    program.reset();
    glDeleteBuffers(1, &buffer);
    glDeleteBuffers(1, &offsetBuffer);
    buffer = offsetBuffer = 0;
    uploaded.reset();
    uploadedOffsets.reset();
}

} // namespace idiophone
