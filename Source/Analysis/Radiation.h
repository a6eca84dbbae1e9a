// What of each mode is heard from afar: the far-field sum over the whole surface, tabulated over
// direction and frequency. The air neither loads the modes nor bends around the object.
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

/// 1/16 to 16 in steps of half an octave.
std::vector<double> halfOctaveRatios();

struct RadiationSettings {
    std::vector<Eigen::Vector3d> directions = stereoDirections(); ///< [D] of any length but 0
    std::vector<double> frequencyRatios = halfOctaveRatios();     ///< [K] > 0, ascending
};

/// For every direction d, ratio r and mode φ
///
///     w = (1/ΣA_j) Σ_j A_j (n_j · φ_j) e^{−ik d·x_j},   k = r √λ / c,   c = 343 m/s,
///
/// over the radiating surface, with x from the centre of mass: a mean of the normal shape, in 1/√kg
/// (the pressure at distance R is ρ_air/(4πR) ΣA_j times d/dt of Σ_i w_i q̇_i). Components of the
/// mesh that are closed, and solids, radiate from their outside; sheets from both faces, which lie
/// at ± thickness/2 along the normal and push in opposite directions. Where r √λ/2π leaves the
/// audible band, k stays at 20 Hz or 22 kHz.
///
/// The weights are real: the complex w of modes with one pole (λ within 1e-9 of the first) is
/// turned by e^{−iψ}, ψ = arg(Σ w_i²)/2, and its real part kept, so that Σ w_i g_i(v) depends
/// neither on the signs of shapes nor on the basis of equal poles. That fixes ψ up to π, hence one
/// sign for each pole, direction and ratio. At the ratio nearest 1 the first direction's axis
/// e^{iψ} is taken within 90° of e^{iπ/4} (symmetric objects have real or imaginary w: no near tie)
/// and the other directions' within 90° of it, which is the sign of Re Σ w_i conj(w_i'); from there
/// it follows the rotation that dψ/dk predicts. What is lost: each pole's absolute phase, and of
/// equal poles whose w is elliptic (Σ w_i² smaller than Σ |w_i|²) the minor axis.
///
/// Errors: sizes that disagree, a surface without area, `cancelledMessage`.
Result<RadiationTable> radiationOf(const RadiatingBody& body,
                                   const RadiationSettings& settings = {},
                                   const WorkControl& control = {});

} // namespace idiophone
