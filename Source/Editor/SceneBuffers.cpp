#include "Editor/SceneBuffers.h"

#include "Editor/Shaders.h"

#include <utility>

using namespace juce::gl;

namespace idiophone {
namespace {

constexpr GLuint indexOf(Attribute attribute) {
    return static_cast<GLuint>(attribute);
}

template <class Value>
void fill(GLuint buffer, std::span<const Value> values, GLenum use) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), use);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

} // namespace

void SceneBuffers::create() {
    glGenVertexArrays(1, &layout);
    for (auto* buffer : {&vertexBuffer, &skyBuffer, &offsetBuffer})
        glGenBuffers(1, buffer);
}

void SceneBuffers::release() {
    glDeleteVertexArrays(1, &layout);
    for (auto* buffer : {&vertexBuffer, &skyBuffer, &offsetBuffer}) {
        glDeleteBuffers(1, buffer);
        *buffer = 0;
    }
    layout = 0;
    hasSky = false;
}

void SceneBuffers::upload(std::span<const SceneVertex> vertices) {
    fill(vertexBuffer, vertices, GL_STATIC_DRAW);
}

void SceneBuffers::uploadSky(std::span<const std::uint8_t> shares) {
    hasSky = !shares.empty();
    fill(skyBuffer, shares, GL_STATIC_DRAW);
}

void SceneBuffers::uploadOffsets(std::span<const ScenePlace> offsets) {
    fill(offsetBuffer, offsets, GL_STREAM_DRAW);
}

void SceneBuffers::bind() const {
    glBindVertexArray(layout);
    readFrom(0);
}

void SceneBuffers::unbind() const {
    for (const auto attribute : {Attribute::place, Attribute::normal, Attribute::sky})
        glDisableVertexAttribArray(indexOf(attribute));
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
}

/// Binds the attributes to the vertices from `first` on.
void SceneBuffers::readFrom(std::size_t first) const {
    glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer);
    for (const auto& [attribute, part] :
         {std::pair(Attribute::place, offsetof(SceneVertex, place)),
          std::pair(Attribute::normal, offsetof(SceneVertex, normal))}) {
        glEnableVertexAttribArray(indexOf(attribute));
        glVertexAttribPointer(indexOf(attribute), 3, GL_FLOAT, GL_FALSE, sizeof(SceneVertex),
                              reinterpret_cast<const void*>(first * sizeof(SceneVertex) + part));
    }
    glVertexAttrib1f(indexOf(Attribute::sky), 1);
    if (!hasSky)
        return;
    glBindBuffer(GL_ARRAY_BUFFER, skyBuffer);
    glEnableVertexAttribArray(indexOf(Attribute::sky));
    glVertexAttribPointer(indexOf(Attribute::sky), 1, GL_UNSIGNED_BYTE, GL_TRUE, 1,
                          reinterpret_cast<const void*>(first));
}

void SceneBuffers::draw(std::size_t first, std::size_t count) const {
    glVertexAttrib3f(indexOf(Attribute::offset), 0, 0, 0);
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first), static_cast<GLsizei>(count));
}

void SceneBuffers::drawMoved(std::size_t first, std::size_t count) const {
    readFrom(first);
    glBindBuffer(GL_ARRAY_BUFFER, offsetBuffer);
    glEnableVertexAttribArray(indexOf(Attribute::offset));
    glVertexAttribPointer(indexOf(Attribute::offset), 3, GL_FLOAT, GL_FALSE, sizeof(ScenePlace),
                          nullptr);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count));
    glDisableVertexAttribArray(indexOf(Attribute::offset));
    readFrom(0);
}

} // namespace idiophone
