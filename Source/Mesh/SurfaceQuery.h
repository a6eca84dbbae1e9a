// SPDX-License-Identifier: Apache-2.0
// Finds where a ray or a point meets a surface: for picking, strikes and contact. Built once per
// mesh; queries are const and may run on several threads at once.
#pragma once

#include "Mesh/Mesh.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace idiophone {

struct SurfacePoint {
    int face = -1;
    Eigen::Vector3d barycentric; ///< weights of the face's three corners, ≥ 0, sum 1
    Eigen::Vector3d pointMetres;
    Eigen::Vector3d normal;    ///< unit normal of the face, by its orientation
    double distanceMetres = 0; ///< from the query point or the ray's origin
};

/// Nearest-point and ray queries on a mesh. On most surfaces a query visits about a hundred boxes;
/// where many faces overlap it could visit all. Each visited box is therefore deducted from
/// `boxBudget`, or from a fixed limit per query. When no box is left, the result is the best of the
/// visited faces.
class SurfaceQuery {
public:
    static constexpr std::int64_t boxesForPoint = 20'000, boxesForRay = 200'000;

    /// The mesh must have a face and valid indices (MeshReader and MeshRepair ensure this).
    explicit SurfaceQuery(Mesh mesh);
    ~SurfaceQuery();
    SurfaceQuery(SurfaceQuery&&) noexcept;
    SurfaceQuery& operator=(SurfaceQuery&&) noexcept;

    const Mesh& mesh() const { return mesh_; }

    /// Returns the nearest point of the surface. If the point is not finite, is too far away to
    /// measure, or no face was visited, returns some point of the surface at infinite distance.
    SurfacePoint nearestPoint(const Eigen::Vector3d& point) const;
    SurfacePoint nearestPoint(const Eigen::Vector3d& point, std::int64_t& boxBudget) const;

    /// Returns the first face along the ray, from either side; nothing if the ray misses. The
    /// direction must not be zero; any length is allowed.
    std::optional<SurfacePoint> firstHit(const Eigen::Vector3d& origin,
                                         const Eigen::Vector3d& direction) const;
    std::optional<SurfacePoint> firstHit(const Eigen::Vector3d& origin,
                                         const Eigen::Vector3d& direction,
                                         std::int64_t& boxBudget) const;

    /// Returns the distances at which the ray passes through faces, ascending, in lengths of the
    /// direction. A ray through an edge passes through both faces. Returns nothing if the boxes run
    /// out.
    std::optional<std::vector<double>> passages(const Eigen::Vector3d& origin,
                                                const Eigen::Vector3d& direction,
                                                std::int64_t& boxBudget) const;

private:
    struct Tree;

    /// Calls `visit(face, distance)` for faces that the ray meets, with distances in lengths of the
    /// direction. Skips boxes that the ray enters at `reach` or later; `visit` may reduce `reach`.
    /// Returns false if the boxes ran out.
    template <typename Visit>
    bool visitAlong(const Eigen::Vector3d& origin,
                    const Eigen::Vector3d& direction,
                    const double& reach,
                    std::int64_t& boxBudget,
                    const Visit& visit) const;

    Mesh mesh_;
    std::unique_ptr<Tree> tree_;
};

} // namespace idiophone
