#include "Analysis/ShiftedFactor.h"

#include <cmath>

namespace idiophone {
namespace {

double oneNorm(const Eigen::SparseMatrix<double>& lower) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(lower.cols());
    for (Eigen::Index column = 0; column < lower.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
            sums(entry.col()) += std::abs(entry.value());
            if (entry.row() != entry.col())
                sums(entry.row()) += std::abs(entry.value());
        }
    return sums.size() == 0 ? 0 : sums.maxCoeff();
}

} // namespace

ShiftedFactor::ShiftedFactor(const VibrationModel& model,
                             const WorkControl& control,
                             WorkTeam* team)
    : model_(model), control_(control), team_(team),
      factor_(model.stiffness.cwiseAbs() + model.mass.cwiseAbs(), model.rowsPerVertex, team),
      norm_(oneNorm(model.stiffness) / model.mass.diagonal().minCoeff()) {}

bool ShiftedFactor::factorise(double shift) {
    if (isDone_ && shift == asked_)
        return true;
    isDone_ = false;
    asked_ = shift;
    double nudge = 0;
    for (int attempt = 0; attempt < 8; ++attempt) {
        shift_ = shift * (1 + nudge);
        const Eigen::SparseMatrix<double> shifted = model_.stiffness - shift_ * model_.mass;
        const auto pivots = factor_.factorise(shifted, [&] { return control_.isCancelled(); });
        if (pivots == LdltOutcome::stopped)
            return false;
        if (pivots == LdltOutcome::done && isAccurate(shifted)) {
            isDone_ = true;
            return true;
        }
        nudge = nudge == 0 ? 1e-4 : 2 * nudge;
    }
    return false;
}

Eigen::Index ShiftedFactor::eigenvaluesBelow() const {
    return factor_.negativePivots();
}

Vectors ShiftedFactor::solve(Vectors right) const {
    factor_.solve(right);
    return right;
}

bool ShiftedFactor::isAccurate(const Eigen::SparseMatrix<double>& shifted) const {
    // Pivots are not exchanged between blocks, so an indefinite matrix may lose digits. Check the
    // backward error of one solve.
    Eigen::VectorXd right(shifted.rows());
    for (Eigen::Index i = 0; i < right.size(); ++i)
        right(i) = std::cos(1.7 * static_cast<double>(i) + 0.3);
    const Eigen::VectorXd x = solve(right);
    if (!x.allFinite())
        return false;
    const Eigen::VectorXd residual = shifted.selfadjointView<Eigen::Lower>() * x - right;
    return residual.norm() <= 1e-11 * oneNorm(shifted) * x.norm() + 1e-11 * right.norm();
}

} // namespace idiophone
