// All modes of a vibration model within a frequency band. A count of eigenvalues proves that none
// is missing.
#pragma once

#include "Analysis/AnalysedBand.h"
#include "Analysis/VibrationModel.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

namespace idiophone {

struct FrequencyBand {
    double lowestHz = lowestAnalysedHz;
    double highestHz = highestAnalysedHz;
    Eigen::Index maximumModes = maximumAnalysedModes; ///< more than this in the band is an error
    unsigned threads = 0; ///< maximum, with the same result for any; 0: the machine's, up to 8
};

/// M modes of n degrees of freedom.
struct Modes {
    Eigen::VectorXd eigenvalues; ///< [M] λ = ω² in rad²/s², ascending
    Eigen::MatrixXd shapes;      ///< [n×M] G in 1/√kg, with GᵀMG = I and GᵀKG = Λ
    /// Number of rigid and spurious modes, those below a twentieth of the lowest frequency. In a
    /// stiff model the limit rises to the rounding error of zero, at most to the lowest frequency.
    Eigen::Index zeroModes = 0;
    Eigen::Index belowBand = 0; ///< modes between the zero modes and the band
};

/// Returns every mode of K x = λ M x with lowestHz ≤ √λ/2π ≤ highestHz (undamped frequency), each
/// once. Their number equals the difference of the inertias of K − λM at both ends, also for
/// degenerate modes. The largest component of a shape is positive. The same model gives the same
/// bits on the same machine. Errors: cancelled, too many modes, a matrix that cannot be factorised,
/// no convergence.
Result<Modes>
solveModes(const VibrationModel& model, const FrequencyBand& band, const WorkControl& = {});

/// Counts the modes below a frequency, including zero modes.
Result<Eigen::Index> countModesBelow(const VibrationModel& model, double frequencyHz);

} // namespace idiophone
