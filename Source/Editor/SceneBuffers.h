// The vertices of the picture in the memory of the graphics driver.
#pragma once

#include "Editor/SceneVertex.h"

#include <cstddef>
#include <cstdint>
#include <juce_opengl/juce_opengl.h>
#include <span>
#include <vector>

namespace idiophone {

/// OpenGL thread. Indices are of vertices in the order of `upload`.
class SceneBuffers {
public:
    void create();
    void release();

    void upload(std::span<const SceneVertex> vertices);
    /// The visible share of the sky at each vertex, 255 for all; if empty, every vertex sees all.
    void uploadSky(std::span<const std::uint8_t> shares);
    void uploadOffsets(std::span<const ScenePlace> offsets);

    void bind() const;
    void unbind() const;
    /// Draws bound vertices at rest.
    void draw(std::size_t first, std::size_t count) const;
    /// Draws bound vertices moved by the uploaded offsets, which are only theirs.
    void drawMoved(std::size_t first, std::size_t count) const;

private:
    void readFrom(std::size_t first) const;

    juce::uint32 layout = 0, vertexBuffer = 0, skyBuffer = 0, offsetBuffer = 0;
    bool hasSky = false;
};

} // namespace idiophone
