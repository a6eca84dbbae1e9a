// The factorisation A − σI = L D Lᵀ of a sparse symmetric matrix: solves for the Lanczos process,
// and counts eigenvalues below σ. Internal to Analysis.
#pragma once

#include "Analysis/AnalysisControl.h"
#include "Analysis/BlockLdlt.h"

#include <memory>
#include <variant>

namespace idiophone {

class ShiftedFactor {
public:
    /// Keeps references to the lower triangle [n×n] and the control. `blockSize` (1, 3 or 6; others
    /// count as 1) is how many rows belong to one vertex. Orders the matrix once for all shifts.
    ShiftedFactor(const Eigen::SparseMatrix<double>& lower,
                  int blockSize,
                  const AnalysisControl& control);

    enum class Outcome { done, failed, cancelled };

    /// Factorises at σ, or at a shift within 1 % of it (away from zero) where the pivots at σ
    /// itself are too small to be trusted. Not thread-safe.
    Outcome factorise(double shift);

    double shift() const { return shift_; }
    double norm() const { return norm_; } ///< ‖A‖₁

    /// The number of eigenvalues below the shift: negative pivots, by Sylvester's law of inertia.
    Eigen::Index eigenvaluesBelow() const;

    /// (A − σI)⁻¹ b for each column [n×m].
    Eigen::MatrixXd solve(Eigen::MatrixXd right) const;

private:
    bool isAccurate() const;

    using Factor = std::variant<BlockLdlt<1>, BlockLdlt<3>, BlockLdlt<6>>;

    const Eigen::SparseMatrix<double>& lower_;
    const AnalysisControl& control_;
    std::unique_ptr<Factor> factor_;
    double shift_ = 0;
    double norm_ = 0;
};

} // namespace idiophone
