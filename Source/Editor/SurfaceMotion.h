// How an object's surface moves in its modes, at every vertex of the mesh that is drawn.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Immutable once built, which takes a while for large meshes. Vertices without shapes of their
/// own, as the underside of a bar, move as the nearest place that has them; of a surface heaped so
/// much on itself that these would take minutes to find, the last ones stand still.
class SurfaceMotion {
public:
    /// The object carries shapes at a vertex.
    explicit SurfaceMotion(std::shared_ptr<const ModalObject> object);

    std::size_t modeCount() const { return object->modeCount(); }

    /// How far the mode moves the surface where it moves it most; > 0 where it moves it at all.
    float largest(std::size_t mode) const;

    /// Adds a mode to displacements [N,3], `weight` at the place it moves most, in the directions
    /// of the object's own mesh.
    void add(std::size_t mode, float weight, std::span<float> displacements) const;

private:
    /// Shapes are linear between three rows.
    struct Place {
        std::array<std::int32_t, 3> rows{};
        std::array<float, 3> weights{};
    };

    std::shared_ptr<const ModalObject> object;
    std::vector<Place> places; ///< [N]
};

} // namespace idiophone
