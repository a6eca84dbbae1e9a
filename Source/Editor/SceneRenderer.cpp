#include "Editor/SceneRenderer.h"

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
uniform float offsetScale;
varying vec3 seenPlace;
varying vec3 seenNormal;
varying float outward;

void main()
{
    vec3 moved = place + offsetScale * offset;
    seenPlace = moved;
    seenNormal = normal;
    outward = dot(offset, normal);
    gl_Position = viewProjection * vec4(moved, 1.0);
}
)";

// Two lamps, a gloss and a rim; both sides of a sheet are lit. The glow is where a blow fell, the
// light how loud the object is.
constexpr const char* fragmentShader = R"(
uniform vec3 colour;
uniform vec3 eye;
uniform vec3 glowPlace;
uniform vec3 accent;
uniform vec3 ink;
uniform float glow;
uniform float glowRadius;
uniform float light;
uniform float largestOffset;
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

    float far = clamp(outward / largestOffset, -1.0, 1.0);
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

juce::String translated(const char* shader, bool isVertexShader) {
    return isVertexShader ? juce::OpenGLHelpers::translateVertexShaderToV3(shader)
                          : juce::OpenGLHelpers::translateFragmentShaderToV3(shader);
}

void clear(juce::Colour colour) {
    juce::OpenGLHelpers::clear(colour);
    glClear(GL_DEPTH_BUFFER_BIT);
}

} // namespace

void SceneRenderer::show(const SceneFrame& next) {
    const std::scoped_lock lock(frameMutex);
    frame = next;
}

void SceneRenderer::newOpenGLContextCreated() {
    auto made = std::make_unique<juce::OpenGLShaderProgram>(context);
    if (!made->addVertexShader(translated(vertexShader, true)) ||
        !made->addFragmentShader(translated(fragmentShader, false)))
        return;
    // The first attribute must be one that is always read from a buffer.
    glBindAttribLocation(made->getProgramID(), 0, "place");
    if (!made->link())
        return;
    program = std::move(made);
    glGenBuffers(1, &buffer);
    glGenBuffers(1, &offsetBuffer);
    ready = true;
}

void SceneRenderer::upload(const ObjectScene& scene) {
    const auto vertices = scene.vertices();
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(),
                 GL_STATIC_DRAW);
}

void SceneRenderer::renderOpenGL() {
    SceneFrame shown;
    {
        const std::scoped_lock lock(frameMutex);
        shown = frame;
    }
    clear(shown.background);
    if (!ready || shown.scene == nullptr || shown.scene->empty())
        return;

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    if (uploaded != shown.scene) {
        upload(*shown.scene);
        uploaded = shown.scene;
    }
    if (shown.motion && shown.motion->offsets != uploadedOffsets)
        uploadOffsets(shown.motion->offsets);
    draw(shown);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDisable(GL_DEPTH_TEST);
}

void SceneRenderer::uploadOffsets(std::shared_ptr<const std::vector<ScenePlace>> offsets) {
    glBindBuffer(GL_ARRAY_BUFFER, offsetBuffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(std::span(*offsets).size_bytes()),
                 offsets->data(), GL_STREAM_DRAW);
    uploadedOffsets = std::move(offsets);
}

void SceneRenderer::draw(const SceneFrame& shown) {
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
    program->setUniform("glowRadius", 0.02f * shown.scene->radius());

    const auto attributeIndex = [&](const char* name) {
        return static_cast<GLuint>(glGetAttribLocation(program->getProgramID(), name));
    };
    const auto vertexPart = [&](const char* name, std::size_t offset) {
        const auto index = attributeIndex(name);
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, sizeof(SceneVertex),
                              reinterpret_cast<const void*>(offset));
        return index;
    };
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    const std::array used{vertexPart("place", offsetof(SceneVertex, place)),
                          vertexPart("normal", offsetof(SceneVertex, normal))};
    const auto offset = attributeIndex("offset");
    const auto& objects = shown.scene->objects();
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto& object = objects[i];
        const bool moves = shown.motion && shown.motion->object == i &&
                           shown.motion->offsets->size() == object.vertexCount;
        set("colour", object.colour);
        program->setUniform("light", i < shown.lights.size() ? shown.lights[i] : 0.0f);
        program->setUniform("offsetScale", moves ? shown.motion->scale : 0.0f);
        program->setUniform("largestOffset", moves ? shown.motion->largestOffset : 1.0f);
        program->setUniform("nodes", moves && shown.motion->showsNodes ? 1.0f : 0.0f);
        if (moves) {
            // The offsets are of this object's vertices alone, so its own are read from there too.
            glBindBuffer(GL_ARRAY_BUFFER, offsetBuffer);
            glEnableVertexAttribArray(offset);
            glVertexAttribPointer(offset, 3, GL_FLOAT, GL_FALSE, sizeof(ScenePlace), nullptr);
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            const auto from = object.firstVertex * sizeof(SceneVertex);
            vertexPart("place", from + offsetof(SceneVertex, place));
            vertexPart("normal", from + offsetof(SceneVertex, normal));
            glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(object.vertexCount));
            glDisableVertexAttribArray(offset);
            vertexPart("place", offsetof(SceneVertex, place));
            vertexPart("normal", offsetof(SceneVertex, normal));
            continue;
        }
        glVertexAttrib3f(offset, 0, 0, 0);
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(object.firstVertex),
                     static_cast<GLsizei>(object.vertexCount));
    }
    for (const auto index : used)
        glDisableVertexAttribArray(index);
}

void SceneRenderer::openGLContextClosing() {
    ready = false;
    program.reset();
    glDeleteBuffers(1, &buffer);
    glDeleteBuffers(1, &offsetBuffer);
    buffer = offsetBuffer = 0;
    uploaded.reset();
    uploadedOffsets.reset();
}

} // namespace idiophone
