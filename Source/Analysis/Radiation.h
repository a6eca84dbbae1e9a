// The pressure that each mode of an object radiates to distant listeners, by boundary elements. The
// exact method is for factory objects and on request, the quick one for all others.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/RadiationTable.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace idiophone {

/// A body with N vertices, M ≥ 1 modes and an area. It holds references to the caller's data.
struct RadiatingBody {
    const Mesh& mesh; ///< as repairMesh leaves it; for an open shell, the middle surface
    const Eigen::MatrixXd& shapes;      ///< [3N×M] rows 3v … 3v+2 are vertex v's, in 1/√kg
    const Eigen::VectorXd& eigenvalues; ///< [M] λ = ω² in rad²/s², ascending, > 0
    double thicknessMetres = 0;         ///< 0 for a solid
    Eigen::Vector3d centreMetres = Eigen::Vector3d::Zero(); ///< of mass
};

/// Returns the directions of the left and right ears: 6° apart, 60° above the horizon. The player
/// stands at the end of a bar, a step to one side. A bar lies along x. Its bending modes radiate as
/// x² while they are small against the wavelength, so both ears have the same x. Neither x nor y is
/// 0 or mirrored. Otherwise modes odd in x or y would be silent, or cancel in the sum of both
/// channels.
std::vector<Eigen::Vector3d> stereoDirections();

/// Returns the stereo directions, then 26 all around: along the axes and the diagonals between two
/// or three of them.
std::vector<Eigen::Vector3d> directionsAllAround();

/// Returns 1/4 to 4 in steps of half an octave.
std::vector<double> halfOctaveRatios();

/// `preview` is a fifth as long as `quick`, within about 12 % of each mode's frequency.
enum class RadiationMethod { preview, quick, exact };

struct RadiationSettings {
    std::vector<Eigen::Vector3d> directions = stereoDirections(); ///< [D ≥ 1] of any length but 0
    std::vector<double> frequencyRatios = halfOctaveRatios();     ///< [K ≥ 1] > 0, ascending
    RadiationMethod method = RadiationMethod::quick;
    /// [P] points outside the body, in the mesh's coordinates, for pressures.
    std::vector<Eigen::Vector3d> nearPointsMetres = {};
    unsigned threads = 0; ///< maximum, with the same result for any; 0: all of the machine
};

struct Radiation {
    RadiationTable table;
    /// [P×M] in Pa at the near points, for a unit modal velocity at each mode's own frequency.
    Eigen::MatrixXcd nearPressures;
    /// The surface pressure is solved up to this frequency. Above, the elements are too large, and
    /// modes use the short-wave limit.
    double solvedHz = 0;
    std::string notes; ///< one sentence if modes of the exact method lie above, else empty
};

/// Computes the weight w of `RadiationTable` for every direction d, ratio r and mode φ of unit
/// velocity at ω = r √λ. Outside the audible band, ω/2π is clamped to 20 Hz or 22 kHz.
///
/// At the ratio 1, each mode is solved at its own frequency, with the quick method within 3 % of
/// it, with that of previews within 12 %. For other ratios, all modes are solved on half octaves
/// from 20 Hz. The log magnitude, and the phase along the shorter arc, are interpolated over log
/// frequency. The surface pressure has at most about 1800 unknowns, 700 with the quick method and
/// 350 with that of previews. Larger surfaces share unknowns between triangles.
///
/// Closed components radiate from their outside, sheets from both faces and their rim. Above
/// `solvedHz`, every visible face acts as part of a large wall, w = jωρ/2π ∫ v_n e^{jk d·y}, and
/// hidden faces are silent. The same holds if faces touch or cross and the equations have no
/// solution. The sum over equal poles of w times the shape depends neither on the signs of the
/// shapes nor on their basis.
///
/// Errors: an open surface without thickness, those of remesh, `cancelledMessage`.
Result<Radiation> radiationOf(const RadiatingBody& body,
                              const RadiationSettings& settings = {},
                              const WorkControl& control = {});

} // namespace idiophone
