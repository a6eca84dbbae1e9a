// Regions in which a body is held still.
#pragma once

#include "Object/Result.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace idiophone {

/// The side of a plane at right angles to an axis.
struct ClampSide {
    int axis = 0; ///< 0 to 2: x, y, z
    bool isBelow = true;
    double metres = 0;

    bool contains(const Eigen::Vector3d& pointMetres) const {
        return isBelow ? pointMetres(axis) <= metres : pointMetres(axis) >= metres;
    }
};

/// The part of space that lies on all of its sides, such as a box. It has at least one.
using ClampRegion = std::vector<ClampSide>;

/// A ball in which a body is held. It holds at least the vertex nearest to its centre.
struct ClampBall {
    Eigen::Vector3d centreMetres = Eigen::Vector3d::Zero();
    double radiusMetres = 0; ///< ≥ 0

    bool contains(const Eigen::Vector3d& pointMetres) const {
        return (pointMetres - centreMetres).norm() <= radiusMetres;
    }
};

/// The clamps of a body, and how much of its vibration they take. Without regions, balls, faces and
/// vertices the body is free.
struct Support {
    std::vector<ClampRegion> clamps = {}; ///< where the body does not move
    std::vector<ClampBall> balls = {};    ///< likewise
    /// Faces of the mesh that `analyse` gets, before its repair. They stay held where repair and
    /// remeshing change the mesh.
    std::vector<int> faces = {};
    std::vector<int> vertices = {}; ///< likewise, with the edges and faces that join them
    /// The resistance of all clamps together, in N s/m, > 0. The higher it is, the less a support
    /// takes that is much heavier than the body. Nothing: a rigid support, which takes nothing.
    std::optional<double> resistanceNsPerM = {};
    /// Instead of a resistance: the quality factor, > 0, that the support alone gives that of the
    /// four lowest modes from which it takes most.
    std::optional<double> quality = {};
    /// The mass of a large board in kg/m², > 0, that carries the clamps and lies at right angles to
    /// z. It radiates the sound of the force on the clamps. Nothing: the support is silent.
    std::optional<double> boardKgPerM2 = {};

    bool holds() const {
        return !clamps.empty() || !balls.empty() || !faces.empty() || !vertices.empty();
    }
};

/// Error, one sentence: a figure is not positive.
Result<void> validate(const Support& support);

/// Reads a region in metres: "x<0.02", or "x>0.1, z<0". The error is the end of a sentence that
/// begins with the text.
Result<ClampRegion> parseClamp(std::string_view text);

/// Returns whether a point lies in one of the regions.
bool isClamped(std::span<const ClampRegion> regions, const Eigen::Vector3d& pointMetres);

} // namespace idiophone
