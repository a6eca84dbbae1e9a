// All modes of a vibration model within a band of frequencies: asked for by frequency, not by
// number, and proved complete by counting.
#pragma once

#include "Analysis/AnalysedBand.h"
#include "Analysis/VibrationModel.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

namespace idiophone {

struct FrequencyBand {
    double lowestHz = lowestAnalysedHz;
    double highestHz = highestAnalysedHz;
    Eigen::Index maximumModes = mostAnalysedModes; ///< more than this in the band is an error
};

/// M modes of n degrees of freedom.
struct Modes {
    Eigen::VectorXd eigenvalues; ///< [M] λ = ω² in rad²/s², ascending
    Eigen::MatrixXd shapes;      ///< [n×M] G in 1/√kg, with GᵀMG = I and GᵀKG = Λ
    /// Rigid and spurious modes: below a twentieth of the lowest Hz, or in a stiff model below what
    /// rounding leaves of zero, as far as that lies below the lowest Hz.
    Eigen::Index zeroModes = 0;
    Eigen::Index belowBand = 0; ///< modes between those and the band
};

/// Every mode of K x = λ M x with lowestHz ≤ √λ/2π ≤ highestHz (undamped frequency), none twice and
/// none missing: their number equals the difference of the inertias of K − λM at both ends, however
/// degenerate they are. The sign of a shape makes its largest component positive; the same model
/// gives the same bits on the same machine. Errors: cancelled, too many modes, a matrix that cannot
/// be factorised, no convergence.
Result<Modes>
solveModes(const VibrationModel& model, const FrequencyBand& band, const WorkControl& = {});

/// How many modes lie below a frequency, zero modes included.
Result<Eigen::Index> countModesBelow(const VibrationModel& model, double frequencyHz);

} // namespace idiophone
