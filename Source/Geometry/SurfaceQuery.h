// Where a ray or a point meets a surface: picking, strikes at a place, contact. Built once for a
// mesh; every query is const and may run on several threads at once.
#pragma once

#include "Geometry/Mesh.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace idiophone {

struct SurfacePoint {
    int face = -1;
    Eigen::Vector3d barycentric; ///< weights of the face's three corners, ≥ 0, their sum 1
    Eigen::Vector3d pointMetres;
    Eigen::Vector3d normal;    ///< the face's unit normal, by its orientation
    double distanceMetres = 0; ///< from the query's point or the ray's origin
};

/// A question looks at boxes round ever fewer faces. Of most surfaces some hundred will do; where
/// faces are heaped on each other all of them might have to be looked at. So each one is taken from
/// `boxesLeft`, or from a number of its own for each question; once there are none left, the answer
/// is the best of the faces looked at: for a point, of none, some point infinitely far away.
class SurfaceQuery {
public:
    static constexpr std::int64_t boxesForPoint = 20'000, boxesForRay = 200'000;

    /// The mesh has a face, and its indices are valid (as MeshReader and MeshRepair see to).
    explicit SurfaceQuery(Mesh mesh);
    ~SurfaceQuery();
    SurfaceQuery(SurfaceQuery&&) noexcept;
    SurfaceQuery& operator=(SurfaceQuery&&) noexcept;

    const Mesh& mesh() const { return mesh_; }

    /// Of a point that is not finite, or too far away to measure from, some point of the surface,
    /// infinitely far away.
    SurfacePoint nearestPoint(const Eigen::Vector3d& point) const;
    SurfacePoint nearestPoint(const Eigen::Vector3d& point, std::int64_t& boxesLeft) const;

    /// The first face along the ray, from either side; nothing when it misses. The direction need
    /// not have unit length, only not be zero.
    std::optional<SurfacePoint> firstHit(const Eigen::Vector3d& origin,
                                         const Eigen::Vector3d& direction) const;
    std::optional<SurfacePoint> firstHit(const Eigen::Vector3d& origin,
                                         const Eigen::Vector3d& direction,
                                         std::int64_t& boxesLeft) const;

    /// How far along the ray it passes through faces, in lengths of the direction and ascending;
    /// along an edge through those on both sides. Nothing where the boxes do not suffice.
    std::optional<std::vector<double>> passages(const Eigen::Vector3d& origin,
                                                const Eigen::Vector3d& direction,
                                                std::int64_t& boxesLeft) const;

    /// Linear in the number of vertices.
    int nearestVertex(const Eigen::Vector3d& point) const;

private:
    struct Tree;

    /// Calls `visit(face, distance)` for faces that the ray meets, distances in lengths of the
    /// direction, but for those in boxes that it enters no sooner than at `reach`, which may change
    /// meanwhile. Whether the boxes sufficed.
    template <typename Visit>
    bool visitAlong(const Eigen::Vector3d& origin,
                    const Eigen::Vector3d& direction,
                    const double& reach,
                    std::int64_t& boxesLeft,
                    const Visit& visit) const;

    Mesh mesh_;
    std::unique_ptr<Tree> tree_;
};

} // namespace idiophone
