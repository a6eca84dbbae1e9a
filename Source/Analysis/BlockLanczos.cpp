#include "Analysis/BlockLanczos.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>
#include <vector>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double tolerance = 1e-9; ///< of a residual relative to its eigenvalue 1/(λ − σ)

/// Wide blocks make products of matrices quick, narrow ones converge in fewer vectors.
Index blockColumns(Index wanted) {
    return std::clamp<Index>(wanted / 8, 4, 6);
}

class BlockLanczos {
public:
    BlockLanczos(const ShiftedFactor& factor,
                 const MassSpace& space,
                 const MatrixXd& found,
                 const LanczosTask& task)
        : factor_(factor), space_(space), found_(found), task_(task),
          width_(std::min(blockColumns(task.wanted), space.rows() - found.cols())),
          capacity_(std::min(largestBasis(task.wanted), space.rows() - found.cols())),
          basis_(space.rows(), capacity_), projected_(MatrixXd::Zero(capacity_, capacity_)) {}

    EigenBlock run();

private:
    MatrixXd start() const;
    bool extend();
    void solveProjected();
    bool isInside(Index i) const;
    bool hasConverged(Index i) const;
    bool isComplete() const;
    EigenBlock ritzPairs() const;

    const ShiftedFactor& factor_;
    const MassSpace& space_;
    const MatrixXd& found_;
    const LanczosTask& task_;
    Index width_, capacity_, size_ = 0;
    MatrixXd basis_;       ///< untouched columns take no memory yet
    MatrixXd projected_;   ///< the operator within the basis: block tridiagonal
    MatrixXd next_, link_; ///< the block to come, and what ties it to the last one
    VectorXd theta_, lambda_, residuals_;
    MatrixXd ritz_; ///< eigenvectors within the basis
};

MatrixXd BlockLanczos::start() const {
    // One solve leaves little of the stiff modes, which would take part to no use.
    MatrixXd block =
        factor_.solve(space_.times(fixedRandomBlock(space_.rows(), width_, task_.seed)));
    for (int pass = 0; pass < 2; ++pass)
        space_.projectOut(found_, block);
    return block;
}

/// Takes `next_` into the basis and makes the block after it; false where there is none.
bool BlockLanczos::extend() {
    auto own = basis_.middleCols(size_, width_);
    own = next_;
    if (size_ > 0) {
        projected_.block(size_, size_ - width_, width_, width_) = link_;
        projected_.block(size_ - width_, size_, width_, width_) = link_.transpose();
    }
    MatrixXd image = factor_.solve(space_.times(own));
    if (size_ > 0)
        image.noalias() -= basis_.middleCols(size_ - width_, width_) * link_.transpose();
    MatrixXd diagonal = own.transpose() * space_.times(image);
    image.noalias() -= own * diagonal;
    projected_.block(size_, size_, width_, width_) = (diagonal + diagonal.transpose()) / 2;
    size_ += width_;
    space_.projectOut(found_, image);
    space_.projectOut(basis_.leftCols(size_), image);
    link_ = space_.orthonormalise(image);
    if (link_.size() == 0)
        return false;
    // Where little was left of a column, rounding is a large part of it.
    if (const VectorXd left = link_.diagonal().cwiseAbs();
        left.minCoeff() < 0.03 * left.maxCoeff()) {
        space_.projectOut(found_, image);
        space_.projectOut(basis_.leftCols(size_), image);
        const MatrixXd again = space_.orthonormalise(image);
        if (again.size() == 0)
            return false;
        link_ = (again * link_).eval();
    }
    next_ = image;
    return true;
}

void BlockLanczos::solveProjected() {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> small(projected_.topLeftCorner(size_, size_));
    theta_ = small.eigenvalues();
    ritz_ = small.eigenvectors();
    lambda_ = factor_.shift() + theta_.cwiseInverse().array();
    residuals_ = (link_ * ritz_.bottomRows(width_)).colwise().norm();
}

bool BlockLanczos::isInside(Index i) const {
    return lambda_(i) > task_.low * (1 - 1e-9) && lambda_(i) < task_.high * (1 + 1e-9);
}

bool BlockLanczos::hasConverged(Index i) const {
    return residuals_(i) <= tolerance * std::abs(theta_(i));
}

/// Whether all are there, or those that are missing will not come: modes outside have converged,
/// and none inside is on its way. Copies of a mode beyond a block's columns are missing like that.
bool BlockLanczos::isComplete() const {
    Index inside = 0, underWay = 0, outside = 0;
    for (Index i = 0; i < theta_.size(); ++i) {
        (isInside(i) ? (hasConverged(i) ? inside : underWay) : outside) +=
            isInside(i) || hasConverged(i) ? 1 : 0;
    }
    return inside >= task_.wanted || (underWay == 0 && outside >= width_);
}

EigenBlock BlockLanczos::ritzPairs() const {
    std::vector<Index> chosen;
    for (Index i = 0; i < theta_.size(); ++i)
        if (isInside(i) && hasConverged(i))
            chosen.push_back(i);
    std::ranges::sort(chosen, {}, [&](Index i) { return lambda_(i); });
    const MatrixXd within = ritz_(Eigen::all, chosen);
    EigenBlock pairs{lambda_(chosen), basis_.leftCols(size_) * within};
    // The operator's image of a Ritz vector, for nothing: one more step of inverse iteration.
    if (next_.cols() == width_ && link_.size() > 0)
        pairs.vectors.noalias() += next_ * (link_ * within.bottomRows(width_) *
                                            theta_(chosen).cwiseInverse().asDiagonal());
    return pairs;
}

EigenBlock BlockLanczos::run() {
    next_ = start();
    if (space_.orthonormalise(next_).size() == 0)
        return {};
    Index check = task_.wanted + std::max(task_.wanted / 2, 3 * width_);
    for (bool goesOn = true; goesOn;) {
        goesOn = extend() && size_ + width_ <= capacity_;
        task_.step();
        if (goesOn && size_ < check)
            continue;
        if (link_.size() == 0)
            link_ = MatrixXd::Zero(width_, width_);
        solveProjected();
        if (isComplete())
            break;
        check = size_ + std::max(width_, size_ / 8);
    }
    return ritzPairs();
}

} // namespace

Index largestBasis(Index wanted) {
    return 3 * wanted + 160;
}

MatrixXd fixedRandomBlock(Index rows, Index columns, unsigned seed) {
    std::mt19937 generator(seed);
    MatrixXd block(rows, columns);
    for (double& value : block.reshaped())
        value = static_cast<double>(generator()) / 4294967296.0 - 0.5;
    return block;
}

EigenBlock nearestModes(const ShiftedFactor& factor,
                        const MassSpace& space,
                        const MatrixXd& found,
                        const LanczosTask& task) {
    return BlockLanczos(factor, space, found, task).run();
}

} // namespace idiophone
