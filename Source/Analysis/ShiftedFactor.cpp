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

ShiftedFactor::ShiftedFactor(const Eigen::SparseMatrix<double>& lower,
                             int blockSize,
                             const AnalysisControl& control)
    : lower_(lower), control_(control), norm_(oneNorm(lower)) {
    if (blockSize == 6)
        factor_ = std::make_unique<Factor>(std::in_place_type<BlockLdlt<6>>, lower);
    else if (blockSize == 3)
        factor_ = std::make_unique<Factor>(std::in_place_type<BlockLdlt<3>>, lower);
    else
        factor_ = std::make_unique<Factor>(std::in_place_type<BlockLdlt<1>>, lower);
}

ShiftedFactor::Outcome ShiftedFactor::factorise(double shift) {
    double nudge = 0;
    for (int attempt = 0; attempt < 8; ++attempt) {
        shift_ = shift * (1 + nudge);
        const auto pivots = std::visit(
            [&](auto& f) { return f.factorise(shift_, [&] { return control_.isCancelled(); }); },
            *factor_);
        if (pivots == LdltOutcome::stopped)
            return Outcome::cancelled;
        if (pivots == LdltOutcome::done && isAccurate())
            return Outcome::done;
        nudge = nudge == 0 ? 1e-4 : 2 * nudge;
    }
    return Outcome::failed;
}

Eigen::Index ShiftedFactor::eigenvaluesBelow() const {
    return std::visit([](const auto& factor) { return factor.negativePivots(); }, *factor_);
}

Eigen::MatrixXd ShiftedFactor::solve(Eigen::MatrixXd right) const {
    for (auto column : right.colwise())
        std::visit([&](const auto& factor) { factor.solveInPlace(column); }, *factor_);
    return right;
}

bool ShiftedFactor::isAccurate() const {
    // Pivots are not exchanged between blocks, so an indefinite matrix may lose digits: the
    // backward error of one solve tells.
    Eigen::VectorXd right(lower_.rows());
    for (Eigen::Index i = 0; i < right.size(); ++i)
        right(i) = std::cos(1.7 * static_cast<double>(i) + 0.3);
    const Eigen::VectorXd x = solve(right);
    if (!x.allFinite())
        return false;
    const Eigen::VectorXd residual =
        lower_.selfadjointView<Eigen::Lower>() * x - shift_ * x - right;
    return residual.norm() <= 1e-11 * (norm_ + std::abs(shift_)) * x.norm() + 1e-11 * right.norm();
}

} // namespace idiophone
