// A modal object's mesh as a surface to be struck: from points in space to strike points.
#pragma once

#include "Geometry/SurfaceQuery.h"
#include "Object/ModalObject.h"
#include "Synth/Strike.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace idiophone {

/// Not for the audio thread.
class ObjectSurface {
public:
    /// `object` outlives the surface and carries shapes at a vertex.
    explicit ObjectSurface(const ModalObject& object);

    /// The nearest place to a point in metres at which shapes are known: barycentric within a face
    /// of the mesh between the vertices that carry them (Geometry/ShapeMesh.h), the normal between
    /// those of its corners.
    StrikePoint nearest(const std::array<double, 3>& pointMetres) const;

    /// Between the vertices that carry shapes; 0 where no two are joined.
    double meanEdgeMetres() const { return meanEdgeLengthMetres(query.mesh()); }

    /// At a vertex of the object's mesh; nothing where it does not exist or carries no shapes.
    std::optional<StrikePoint> atVertex(std::int64_t vertex) const;

private:
    std::array<float, 3> normalAt(std::int32_t row) const;

    const ModalObject& object;
    std::vector<float> normals;
    SurfaceQuery query; ///< its vertices are rows
};

} // namespace idiophone
