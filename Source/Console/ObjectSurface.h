// A modal object's mesh as a surface to be struck: from points in space to strike points.
#pragma once

#include "Geometry/SurfaceQuery.h"
#include "Object/ModalObject.h"
#include "Synth/Strike.h"

#include <array>
#include <cstdint>
#include <optional>

namespace idiophone {

class ObjectSurface {
public:
    /// `object` outlives the surface.
    explicit ObjectSurface(const ModalObject& object);

    /// The point of the surface nearest to a point in metres: within its face where all three
    /// corners carry shapes, or else at the nearest vertex that does.
    StrikePoint nearest(const std::array<double, 3>& pointMetres) const;

    /// At a vertex of the mesh; nothing where it does not exist or carries no shapes.
    std::optional<StrikePoint> atVertex(std::int64_t vertex) const;

private:
    StrikePoint atRow(std::size_t row) const;
    std::optional<std::int32_t> rowOf(std::int64_t vertex) const;

    const ModalObject& object;
    std::vector<float> normals;
    std::optional<SurfaceQuery> query; ///< nothing for an object without faces
};

} // namespace idiophone
