// From places of the scene to pixels of its picture.
#pragma once

#include <Eigen/Core>
#include <array>
#include <juce_graphics/juce_graphics.h>
#include <optional>

namespace idiophone {

class PixelProjection {
public:
    /// For a camera's matrix (`OrbitCamera::viewProjection`) whose picture covers an area.
    PixelProjection(const std::array<float, 16>& viewProjection, juce::Rectangle<float> covered)
        : toClip(Eigen::Map<const Eigen::Matrix4f>(viewProjection.data())), area(covered) {}

    /// Returns nothing for a place nearer than what the camera shows, or behind it.
    std::optional<juce::Point<float>> pixelOf(const Eigen::Vector3f& place) const {
        const Eigen::Vector4f clip = toClip * place.homogeneous();
        if (clip.z() < -clip.w())
            return std::nullopt;
        return area.getRelativePoint((1 + clip.x() / clip.w()) / 2, (1 - clip.y() / clip.w()) / 2);
    }

private:
    Eigen::Matrix4f toClip;
    juce::Rectangle<float> area;
};

} // namespace idiophone
