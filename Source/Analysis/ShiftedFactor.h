// The factorisation K − σM = L D Lᵀ of a model's matrices. It solves for the Lanczos process and
// counts eigenvalues below σ. Internal to Analysis.
#pragma once

#include "Analysis/MassSpace.h"
#include "Analysis/SupernodalLdlt.h"
#include "Analysis/VibrationModel.h"
#include "Object/WorkControl.h"

#include <Eigen/SparseCore>

namespace idiophone {

class ShiftedFactor {
public:
    /// Keeps references to the model and to the control. Orders the matrices once for all shifts.
    /// The team outlives it. It may be null, with the same result.
    ShiftedFactor(const VibrationModel& model,
                  const WorkControl& control,
                  WorkTeam* team = nullptr);

    /// Factorises at σ. If the pivots there are too small for accuracy, moves the shift away from
    /// zero, by at most about 1 %. Does nothing if σ is unchanged. Returns false if that fails or
    /// if cancelled. Not thread-safe.
    bool factorise(double shift);

    WorkTeam* team() const { return team_; }
    double shift() const { return shift_; }
    /// An upper bound on the order of magnitude of the stiffest eigenvalue: ‖K‖₁ over the minimum
    /// diagonal mass.
    double norm() const { return norm_; }

    /// The number of eigenvalues below the shift: negative pivots, by Sylvester's law of inertia.
    Eigen::Index eigenvaluesBelow() const;

    /// The number of multiplications of one factorisation.
    double products() const { return factor_.products(); }

    /// The number of entries of L. A solve reads each of them twice.
    double entries() const { return factor_.entries(); }

    /// Returns (K − σM)⁻¹ b for each column [n×m].
    Vectors solve(Vectors right) const;

private:
    bool isAccurate(const Eigen::SparseMatrix<double>& shifted) const;

    const VibrationModel& model_;
    const WorkControl& control_;
    WorkTeam* team_;
    SupernodalLdlt factor_;
    double shift_ = 0, asked_ = 0;
    bool isDone_ = false;
    double norm_ = 0;
};

} // namespace idiophone
