// SPDX-License-Identifier: Apache-2.0
// A modal object's mesh as a surface to strike: converts points in space to strike points.
#pragma once

#include "Mesh/SurfaceQuery.h"
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
    /// `object` must outlive the surface and have shapes at one vertex or more.
    explicit ObjectSurface(const ModalObject& object);

    /// Returns the place with shapes that is nearest to a point in metres. The place is barycentric
    /// within a face of the mesh between the vertices with shapes (Mesh/ShapeMesh.h). Its
    /// normal is interpolated between those of the corners.
    StrikePoint nearest(const std::array<double, 3>& pointMetres) const;

    /// Returns the mean edge between vertices with shapes; 0 if no two are joined.
    double meanEdgeMetres() const { return meanEdgeLengthMetres(query.mesh()); }

    /// Returns the place at a vertex of the object's mesh, or nothing if it does not exist or has
    /// no shapes.
    std::optional<StrikePoint> atVertex(std::int64_t vertex) const;

private:
    std::array<float, 3> normalAt(std::int32_t row) const;

    const ModalObject& object;
    std::vector<float> normals;
    SurfaceQuery query; ///< its vertices are shape rows
};

} // namespace idiophone
