#include "Analysis/BlockLanczos.h"

#include "Analysis/KrylovBasis.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>
#include <vector>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double tolerance = 1e-9; ///< of a residual, relative to its eigenvalue 1/(λ − σ)

/// Narrow blocks converge with fewer vectors. Wide blocks read the factor less often, which pays if
/// the factor is larger than the cache.
Index blockColumns(Index wanted, double factorEntries) {
    return wanted >= 24 && factorEntries > 1.5e6 ? 8 : 4;
}

class BlockLanczos {
public:
    BlockLanczos(const ShiftedFactor& factor,
                 const MassSpace& space,
                 const Vectors& found,
                 const LanczosTask& task)
        : factor_(factor), space_(space), found_(found), task_(task),
          width_(
              std::min(blockColumns(task.wanted, factor.entries()), space.rows() - found.cols())),
          capacity_(std::min(largestBasis(task.wanted), space.rows() - found.cols())),
          basis_(factor.team()), projected_(MatrixXd::Zero(capacity_, capacity_)) {}

    EigenBlock run();

private:
    Vectors start() const;
    bool extend();
    void projectOut(Vectors& block) const;
    void solveProjected();
    bool isInside(Index i) const;
    bool hasConverged(Index i) const;
    Index vectorsToGo() const;
    EigenBlock ritzPairs() const;

    const ShiftedFactor& factor_;
    const MassSpace& space_;
    const Vectors& found_;
    const LanczosTask& task_;
    Index width_, capacity_;
    KrylovBasis basis_;
    MatrixXd projected_;       ///< the operator within the basis, block tridiagonal
    Vectors next_, nextImage_; ///< the next block, and M times it
    MatrixXd link_;            ///< the coupling of the next block to the last one
    VectorXd theta_, lambda_, residuals_;
    MatrixXd ritz_; ///< eigenvectors within the basis
};

Vectors BlockLanczos::start() const {
    // One solve reduces the stiff modes, which contribute nothing useful.
    Vectors block =
        factor_.solve(space_.times(fixedRandomBlock(space_.rows(), width_, task_.seed)));
    for (int pass = 0; pass < 2; ++pass)
        space_.projectOut(found_, block);
    return block;
}

/// Makes a block M-orthogonal to `found_` and to the basis.
void BlockLanczos::projectOut(Vectors& block) const {
    const Vectors image = space_.times(block);
    if (found_.cols() > 0)
        addCombinations(block, -1, found_, innerProducts(found_, image));
    basis_.projectOut(image, block);
}

/// Appends `next_` to the basis and makes the next block. Returns false if no block is left.
bool BlockLanczos::extend() {
    const Index size = basis_.size();
    Vectors image = factor_.solve(nextImage_);
    if (size > 0) {
        projected_.block(size, size - width_, width_, width_) = link_;
        projected_.block(size - width_, size, width_, width_) = link_.transpose();
        addCombinations(image, -1, basis_.last(), link_.transpose());
    }
    const Vectors diagonal = innerProducts(nextImage_, image);
    addCombinations(image, -1, next_, diagonal);
    projected_.block(size, size, width_, width_) = (diagonal + diagonal.transpose()) / 2;
    basis_.append(std::move(next_));
    projectOut(image);
    link_ = space_.orthonormalise(image, nextImage_);
    if (link_.size() == 0)
        return false;
    // If a column lost most of its length, rounding errors are a large part of the rest.
    if (const VectorXd left = link_.diagonal().cwiseAbs();
        left.minCoeff() < 0.03 * left.maxCoeff()) {
        projectOut(image);
        const MatrixXd again = space_.orthonormalise(image, nextImage_);
        if (again.size() == 0) {
            link_.resize(0, 0);
            return false;
        }
        link_ = (again * link_).eval();
    }
    next_ = std::move(image);
    return true;
}

void BlockLanczos::solveProjected() {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> small(
        projected_.topLeftCorner(basis_.size(), basis_.size()));
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

/// Returns the number of vectors to add before the next check. Returns 0 if all wanted modes have
/// converged, or if the missing modes cannot converge. They cannot if modes outside have converged
/// and none inside is converging, as with surplus copies of a degenerate mode.
Index BlockLanczos::vectorsToGo() const {
    Index inside = 0, underWay = 0, outside = 0;
    for (Index i = 0; i < theta_.size(); ++i) {
        (isInside(i) ? (hasConverged(i) ? inside : underWay) : outside) +=
            isInside(i) || hasConverged(i) ? 1 : 0;
    }
    if (inside >= task_.wanted || (underWay == 0 && outside >= width_))
        return 0;
    return std::max({width_, basis_.size() / 16, 3 * (task_.wanted - inside) / 2});
}

EigenBlock BlockLanczos::ritzPairs() const {
    std::vector<Index> chosen;
    for (Index i = 0; i < theta_.size(); ++i)
        if (isInside(i) && hasConverged(i))
            chosen.push_back(i);
    std::ranges::sort(chosen, {}, [&](Index i) { return lambda_(i); });
    const Vectors within = ritz_(Eigen::all, chosen);
    EigenBlock pairs{lambda_(chosen), basis_.combinations(within)};
    // Add the operator's image of each Ritz vector. This costs no solve and equals one more step of
    // inverse iteration.
    if (next_.cols() == width_)
        addCombinations(pairs.vectors, 1, next_,
                        link_ * within.bottomRows(width_) *
                            theta_(chosen).cwiseInverse().asDiagonal());
    return pairs;
}

EigenBlock BlockLanczos::run() {
    next_ = start();
    if (space_.orthonormalise(next_, nextImage_).size() == 0)
        return {};
    Index check = 2 * task_.wanted + 3 * width_;
    for (bool goesOn = true; goesOn;) {
        goesOn = extend() && basis_.size() + width_ <= capacity_;
        task_.step();
        if (goesOn && basis_.size() < check)
            continue;
        if (link_.size() == 0)
            link_ = MatrixXd::Zero(width_, width_);
        solveProjected();
        const Index more = vectorsToGo();
        if (more == 0)
            break;
        check = basis_.size() + more;
    }
    return ritzPairs();
}

} // namespace

Index largestBasis(Index wanted) {
    return 3 * wanted + 160;
}

Vectors fixedRandomBlock(Index rows, Index columns, unsigned seed) {
    std::mt19937 generator(seed);
    Vectors block(rows, columns);
    for (double& value : block.reshaped())
        value = static_cast<double>(generator()) / 4294967296.0 - 0.5;
    return block;
}

EigenBlock nearestModes(const ShiftedFactor& factor,
                        const MassSpace& space,
                        const Vectors& found,
                        const LanczosTask& task) {
    return BlockLanczos(factor, space, found, task).run();
}

} // namespace idiophone
