// The motion of an object's surface in its modes, at every vertex of the drawn mesh.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Immutable. Construction takes a while for large meshes. Vertices without shapes, such as the
/// underside of a bar, move like the nearest place with shapes. The search is limited: on a heavily
/// folded surface the last vertices do not move.
class SurfaceMotion {
public:
    /// The object must have shapes at one vertex or more.
    explicit SurfaceMotion(std::shared_ptr<const ModalObject> object);

    std::size_t modeCount() const { return object->modeCount(); }

    /// The mode's largest displacement over the surface; 0 if the mode does not move the surface.
    float largest(std::size_t mode) const;

    /// Adds a mode to displacements [N,3], in the directions of the object's mesh. `weight` is the
    /// displacement at the place that moves most.
    void add(std::size_t mode, float weight, std::span<float> displacements) const;

private:
    /// A point where the shape is interpolated linearly between three rows.
    struct Place {
        std::array<std::int32_t, 3> rows{};
        std::array<float, 3> weights{};
    };

    std::shared_ptr<const ModalObject> object;
    std::vector<Place> places; ///< [N]
};

} // namespace idiophone
