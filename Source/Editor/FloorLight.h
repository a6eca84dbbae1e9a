// The light on the floor as a texture, the light of the vertices, and the extent of the scene that
// they are of.
#pragma once

#include "Editor/LightWorker.h"
#include "Editor/SceneFrame.h"

#include <Eigen/Core>
#include <functional>
#include <juce_opengl/juce_opengl.h>
#include <memory>

namespace idiophone {

/// OpenGL thread. Construct and destroy it while there is no context.
class FloorLight {
public:
    /// `arrived` is called on a thread of its own whenever `takeUploaded` should be called.
    explicit FloorLight(std::function<void()> arrived) : worker(std::move(arrived)) {}

    /// Lights the floor fully. Measures the frame's scene and begins to compute its light, unless
    /// it is the scene of the last call, in whatever context.
    void begin(const SceneFrame& shown);
    /// Uploads the floor's light once it is computed. Returns the light then, at other times
    /// nullptr.
    const SceneLight* takeUploaded();
    void bindTexture() const;
    void release();

    bool isComplete() const { return isUploaded; } ///< whether the floor has the scene's light
    const FloorArea& area() const { return floor; }
    const Eigen::Vector3f& middle() const { return centre; } ///< of the scene
    float reach() const { return radius; }                   ///< its radius in metres

private:
    void measure(std::span<const SceneVertex> vertices, float floorHeight);
    void upload(int columns, int rows, const std::uint8_t* shares);

    LightWorker worker;
    std::shared_ptr<const ObjectScene> scene; ///< of the worker's request
    FloorArea floor;
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    float radius = 1;
    juce::uint32 texture = 0;
    bool isUploaded = false;
};

} // namespace idiophone
