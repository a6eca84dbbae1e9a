// The pressure that each mode radiates into the far field, quickly: the surface's points as free
// sources, which neither load each other nor bend the sound around the object.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/RadiationTable.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

/// N vertices, M modes. Refers to what the caller keeps.
struct RadiatingBody {
    const Mesh& mesh;                   ///< as repairMesh leaves it; an open shell's middle surface
    const Eigen::MatrixXd& shapes;      ///< [3N×M] rows 3v … 3v+2 are vertex v's, in 1/√kg
    const Eigen::VectorXd& eigenvalues; ///< [M] λ = ω² in rad²/s², ascending, > 0
    double thicknessMetres = 0;         ///< of a shell; 0 for a solid
    Eigen::Vector3d centreMetres = Eigen::Vector3d::Zero(); ///< of mass
};

/// 25° to the left and to the right of +y, at 40° elevation: across the x axis, along which bars
/// lie, so that a blow on their axis is heard differently on both sides.
std::vector<Eigen::Vector3d> stereoDirections();

/// Those, then 26 all around: along the axes and halfway between two and three of them.
std::vector<Eigen::Vector3d> directionsAllAround();

/// 1/4 to 4 in steps of half an octave.
std::vector<double> halfOctaveRatios();

struct RadiationSettings {
    std::vector<Eigen::Vector3d> directions = stereoDirections(); ///< [D] of any length but 0
    std::vector<double> frequencyRatios = halfOctaveRatios();     ///< [K] > 0, ascending
};

/// For every direction d, ratio r and mode φ
///
///     w = jω ρ0/(4π) Σ_j A_j (n_j · φ_j) e^{jk d·x_j},   ω = r √λ, k = ω/c,
///
/// over the radiating surface, with x from the centre of mass: the surface velocity's half of the
/// Kirchhoff-Helmholtz integral, without the pressure on the surface. Components of the mesh that
/// are closed, and solids, radiate from their outside; sheets from both faces, which lie at
/// ± thickness/2 along the normal and push in opposite directions. The sum over equal poles of w
/// times the shape depends neither on the signs of shapes nor on their basis. Where ω leaves the
/// audible band, k stays at 20 Hz or 22 kHz.
///
/// Errors: sizes that disagree, a surface without area, `cancelledMessage`.
Result<RadiationTable> radiationOf(const RadiatingBody& body,
                                   const RadiationSettings& settings = {},
                                   const WorkControl& control = {});

} // namespace idiophone
