// What every mode of an object sends to listeners far away, by boundary elements: exact for factory
// objects and whoever asks, or quick.
#pragma once

#include "Analysis/Radiation.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <array>
#include <complex>
#include <string>
#include <vector>

namespace idiophone {

/// How finely the surface pressure is resolved. Time grows with the square of the unknowns, then
/// with their cube.
struct RadiationEffort {
    /// A symmetry of G elements divides them between G systems, down to a quarter.
    int unknowns = 0;
    int maximumFaces = 0; ///< of a finer surface the triangles are made larger
    /// Modes whose frequencies differ by less than this share, 0 to 0.1, are solved at one.
    double sameFrequency = 0;
};
inline constexpr RadiationEffort exactRadiation{1800, 24000, 0.002};
inline constexpr RadiationEffort quickRadiation{500, 12000, 0.03};

/// D directions, K ratios, M modes.
struct SolvedRadiation {
    std::vector<std::array<float, 3>> directions; ///< [D] unit, object to listener
    std::vector<double> frequencyRatios;          ///< [K]
    std::vector<std::complex<float>> weights;     ///< [D,K,M] in Pa·m per unit modal velocity
    /// Frequencies up to here were solved; to those above the elements are too large, and they have
    /// the limit of short waves.
    double solvedHz = 0;
    std::string notes; ///< one sentence where modes lie above, or empty
};

/// For every direction d, ratio r and mode φ of unit velocity at ω = r √λ the far-field pressure is
/// w e^{−jkR}/R at the distance R from the centre of mass. Where ω/2π leaves the audible band it
/// stays at 20 Hz or 22 kHz.
///
/// At the ratio 1 each mode is solved at its own frequency. All modes are solved at 20 Hz and half
/// octaves from there on, and other ratios interpolated between: the logarithm of the magnitude and
/// the phase, the shorter way round, over the logarithm of frequency.
///
/// Closed components radiate from their outside; sheets from both faces and their rim. Above
/// `solvedHz` every visible face acts as a part of a large wall, w = jωρ/2π ∫ v_n e^{jk d·y} dS,
/// and faces that look away are not heard.
///
/// Runs on up to `threads` threads, 0: as many as the machine has; the result does not depend on
/// them. Errors: sizes that disagree, an open surface without thickness, those of remesh,
/// `cancelledMessage`.
Result<SolvedRadiation> solveRadiation(const RadiatingBody& body,
                                       const RadiationSettings& settings,
                                       const RadiationEffort& effort,
                                       const WorkControl& control = {},
                                       unsigned threads = 0);

} // namespace idiophone
