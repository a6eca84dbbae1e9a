#include "Editor/SceneRenderer.h"

#include <cstddef>

using namespace juce::gl;

namespace idiophone {
namespace {

constexpr const char* vertexShader = R"(
attribute vec3 place;
attribute vec3 normal;
uniform mat4 viewProjection;
varying vec3 seenPlace;
varying vec3 seenNormal;

void main()
{
    seenPlace = place;
    seenNormal = normal;
    gl_Position = viewProjection * vec4(place, 1.0);
}
)";

// Two lamps, a gloss and a rim; both sides of a sheet are lit. The glow is where a blow fell.
constexpr const char* fragmentShader = R"(
uniform vec3 colour;
uniform vec3 eye;
uniform vec3 glowPlace;
uniform vec3 glowColour;
uniform float glow;
uniform float glowRadius;
varying vec3 seenPlace;
varying vec3 seenNormal;

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
    vec3 lit = colour * diffuse + vec3(0.22 * gloss + 0.08 * rim);
    gl_FragColor = vec4(lit + glow * glowColour * exp(-dot(off, off)), 1.0);
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
        !made->addFragmentShader(translated(fragmentShader, false)) || !made->link())
        return;
    program = std::move(made);
    glGenBuffers(1, &buffer);
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
    program->use();
    const auto set = [&](const char* name, const ScenePlace& value) {
        program->setUniform(name, value[0], value[1], value[2]);
    };
    program->setUniformMat4("viewProjection", shown.viewProjection.data(), 1, false);
    set("eye", shown.eye);
    set("glowPlace", shown.glowPlace);
    set("glowColour", {shown.glowColour.getFloatRed(), shown.glowColour.getFloatGreen(),
                       shown.glowColour.getFloatBlue()});
    program->setUniform("glow", shown.glow);
    program->setUniform("glowRadius", 0.02f * shown.scene->radius());

    const auto attribute = [&](const char* name, std::size_t offset) {
        const auto index = static_cast<GLuint>(glGetAttribLocation(program->getProgramID(), name));
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, sizeof(SceneVertex),
                              reinterpret_cast<const void*>(offset));
        return index;
    };
    const std::array used{attribute("place", offsetof(SceneVertex, place)),
                          attribute("normal", offsetof(SceneVertex, normal))};
    for (const auto& object : shown.scene->objects()) {
        set("colour", object.colour);
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(object.firstVertex),
                     static_cast<GLsizei>(object.vertexCount));
    }
    for (const auto index : used)
        glDisableVertexAttribArray(index);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDisable(GL_DEPTH_TEST);
}

void SceneRenderer::openGLContextClosing() {
    ready = false;
    program.reset();
    glDeleteBuffers(1, &buffer);
    buffer = 0;
    uploaded.reset();
}

} // namespace idiophone
