// The light on the floor as a texture, and the extent of the scene that it was computed for.
#pragma once

#include "Editor/SceneLight.h"

#include <Eigen/Core>
#include <juce_opengl/juce_opengl.h>
#include <vector>

namespace idiophone {

/// OpenGL thread.
class FloorLight {
public:
    /// Computes the light around these triangles on a floor of that height, and uploads the
    /// floor's. Returns the visible share of the sky at each vertex. Takes some tenths of a second.
    std::vector<std::uint8_t> compute(std::span<const SceneVertex> vertices, float floorHeight);
    void bindTexture() const;
    void release();

    const FloorArea& area() const { return floor; }
    const Eigen::Vector3f& middle() const { return centre; } ///< of the triangles
    float reach() const { return radius; }                   ///< their radius in metres

private:
    juce::uint32 texture = 0;
    FloorArea floor;
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    float radius = 1;
};

} // namespace idiophone
