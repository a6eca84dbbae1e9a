// The pressure that each mode of an object sends to listeners far away, by boundary elements:
// exactly for factory objects and whoever asks, or quickly.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/RadiationTable.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <Eigen/Core>
#include <string>
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

/// Left and right, 6° apart and 60° above the horizon, as the player hears a bar who stands at its
/// end, a step to one side. A bar lies along x. Its bending modes radiate as x² while they are
/// small against the wavelength, so x is the same on both sides. Neither x nor y is 0 or mirrored:
/// modes that are odd in it would be silent, or cancel in the sum of both channels.
std::vector<Eigen::Vector3d> stereoDirections();

/// Those, then 26 all around: along the axes and halfway between two and three of them.
std::vector<Eigen::Vector3d> directionsAllAround();

/// 1/4 to 4 in steps of half an octave.
std::vector<double> halfOctaveRatios();

enum class RadiationMethod { quick, exact };

struct RadiationSettings {
    std::vector<Eigen::Vector3d> directions = stereoDirections(); ///< [D] of any length but 0
    std::vector<double> frequencyRatios = halfOctaveRatios();     ///< [K] > 0, ascending
    RadiationMethod method = RadiationMethod::quick;
    /// [P] outside the body, in the mesh's coordinates: where pressures are wanted too.
    std::vector<Eigen::Vector3d> nearPointsMetres = {};
    unsigned threads = 0; ///< at most; 0: as many as the machine has. The result is always the same
};

struct Radiation {
    RadiationTable table;
    /// [P×M] in Pa at the near points, for a unit modal velocity at each mode's own frequency.
    Eigen::MatrixXcd nearPressures;
    /// Up to here the pressure on the surface was solved. Above, where the elements are too large,
    /// modes have the limit of short waves.
    double solvedHz = 0;
    std::string notes; ///< one sentence where exact modes lie above, or empty
};

/// For every direction d, ratio r and mode φ of unit velocity at ω = r √λ the weight w of
/// `RadiationTable`. Where ω/2π leaves the audible band it stays at 20 Hz or 22 kHz.
///
/// At the ratio 1 each mode is solved at its own frequency; quickly, within 3 % of it. All modes
/// are solved on half octaves from 20 Hz on, and other ratios interpolated between: the logarithm
/// of the size and the phase, the short way round, over the logarithm of frequency. The surface
/// pressure has at most some 1800 unknowns, or 700, which triangles share where there are more.
///
/// Closed components radiate from their outside; sheets from both faces and their rim. Above
/// `solvedHz` every visible face acts as a part of a large wall, w = jωρ/2π ∫ v_n e^{jk d·y},
/// and faces that look away are not heard. So it does where faces touch or cross and the equations
/// have no solution. The sum over equal poles of w times the shape depends
/// neither on the signs of shapes nor on their basis.
///
/// Errors: sizes that disagree, a surface without area, an open one without thickness, those of
/// remesh, `cancelledMessage`.
Result<Radiation> radiationOf(const RadiatingBody& body,
                              const RadiationSettings& settings = {},
                              const WorkControl& control = {});

} // namespace idiophone
