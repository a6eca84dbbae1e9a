#include "Analysis/SupernodalLdlt.h"

#include "Analysis/DenseKernels.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index panelColumns = 48;    ///< eliminated before the rest of a front is updated
constexpr Index solvedTogether = 8;   ///< maximum number of right-hand sides
constexpr Index streamsTogether = 16; ///< columns of L read together, as prefetching allows

/// Returns a matrix with an entry for each block that has one.
Eigen::SparseMatrix<double> blockPlaces(const Eigen::SparseMatrix<double>& lower, int blockSize) {
    const Index count = lower.rows() / blockSize;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index c = 0; c < lower.outerSize(); ++c)
        for (Eigen::SparseMatrix<double>::InnerIterator e(lower, c); e; ++e)
            if (entries.empty() || entries.back().row() != e.row() / blockSize ||
                entries.back().col() != c / blockSize)
                entries.emplace_back(e.row() / blockSize, c / blockSize, 1);
    Eigen::SparseMatrix<double> places(count, count);
    places.setFromTriplets(entries.begin(), entries.end());
    return places;
}

/// C −= A Bᵀ in the lower triangle of C and a little above it.
void subtractProduct(Eigen::Ref<MatrixXd> c,
                     const Eigen::Ref<const MatrixXd>& a,
                     const Eigen::Ref<const MatrixXd>& b) {
    constexpr Index strip = 16;
    for (Index j = 0; j < c.cols(); j += strip)
        addProduct({std::min(strip, c.cols() - j), c.rows() - j, a.cols(), -1, b.data() + j, 1,
                    b.outerStride(), a.data() + j, a.outerStride(), &c(j, j), c.outerStride()});
}

} // namespace

SupernodalLdlt::SupernodalLdlt(const Eigen::SparseMatrix<double>& lower, int blockSize)
    : blockSize_(blockSize), tree_(eliminationTree(blockPlaces(lower, blockSize), blockSize)),
      order_(lower.rows()), columns_(tree_.supernodes.size()), updates_(tree_.supernodes.size()),
      placeInFront_(tree_.original.size(), -1), axes_(blockSize, lower.rows()),
      pivots_(blockSize, lower.rows() / blockSize) {
    for (Index row = 0; row < lower.rows(); ++row)
        order_.indices()(row) =
            tree_.place[row / blockSize] * blockSize + static_cast<int>(row % blockSize);
}

LdltOutcome SupernodalLdlt::factorise(const Eigen::SparseMatrix<double>& lower,
                                      const std::function<bool()>& stop) {
    negativePivots_ = 0;
    Eigen::SparseMatrix<double> permuted(lower.rows(), lower.cols());
    permuted.selfadjointView<Eigen::Lower>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
    std::ranges::fill(updates_, MatrixXd());
    MatrixXd front;
    for (std::size_t s = 0; s < tree_.supernodes.size(); ++s) {
        const auto& node = tree_.supernodes[s];
        const Index wide = Index{node.width} * blockSize_;
        const Index size = wide + static_cast<Index>(node.below.size()) * blockSize_;
        front.setZero(size, size);
        assemble(node, permuted, front);
        const Index panel = panelColumns / blockSize_ * blockSize_;
        for (Index column = 0; column < wide; column += panel) {
            if (stop())
                return LdltOutcome::stopped;
            const Index width = std::min(panel, wide - column);
            if (!eliminate(node.first * blockSize_ + column,
                           front.bottomRightCorner(size - column, size - column), width))
                return LdltOutcome::singular;
        }
        columns_[s] = front.leftCols(wide);
        for (Index row = 0; row < wide; row += blockSize_) {
            auto before = columns_[s].block(row, 0, blockSize_, row);
            before =
                (axes_.middleCols(node.first * blockSize_ + row, blockSize_).transpose() * before)
                    .eval();
        }
        updates_[s] = front.bottomRightCorner(size - wide, size - wide);
    }
    return LdltOutcome::done;
}

void SupernodalLdlt::assemble(const Supernode& node,
                              const Eigen::SparseMatrix<double>& permuted,
                              MatrixXd& front) {
    const int b = blockSize_;
    for (int i = 0; i < node.width; ++i)
        placeInFront_[node.first + i] = i * b;
    for (int i = 0; i < static_cast<int>(node.below.size()); ++i)
        placeInFront_[node.below[i]] = (node.width + i) * b;
    for (Index column = 0; column < Index{node.width} * b; ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator e(permuted, node.first * b + column); e;
             ++e)
            front(placeInFront_[e.row() / b] + e.row() % b, column) = e.value();
    for (const int child : node.children) {
        const auto& rows = tree_.supernodes[child].below;
        const auto blocks = static_cast<Index>(rows.size());
        for (Index j = 0; j < blocks; ++j)
            for (Index i = j; i < blocks; ++i)
                front.block(placeInFront_[rows[i]], placeInFront_[rows[j]], b, b) +=
                    updates_[child].block(i * b, j * b, b, b);
        updates_[child] = MatrixXd();
    }
}

/// Eliminates the first `width` columns of the rest of a front, whose rows start at `first`.
bool SupernodalLdlt::eliminate(Index first, Eigen::Ref<MatrixXd> left, Index width) {
    const Index b = blockSize_, size = left.rows();
    MatrixXd unscaled(size, width); // L D; L stays in `left`
    for (Index j = 0; j < width; j += b) {
        const Index rest = size - j - b;
        if (!diagonalisePivot(first + j, left.block(j, j, b, b)))
            return false;
        auto column = unscaled.block(j + b, j, rest, b);
        column.noalias() =
            left.block(j + b, j, rest, b).lazyProduct(axes_.middleCols(first + j, b));
        left.block(j + b, j, rest, b).noalias() =
            column * pivots_.col((first + j) / b).cwiseInverse().asDiagonal();
        left.block(j, j, b, b).setIdentity();
        if (const Index others = width - j - b; others > 0)
            left.block(j + b, j + b, rest, others).noalias() -=
                left.block(j + b, j, rest, b) * unscaled.block(j + b, j, others, b).transpose();
    }
    const Index rest = size - width;
    subtractProduct(left.bottomRightCorner(rest, rest), left.bottomLeftCorner(rest, width),
                    unscaled.bottomRows(rest));
    return true;
}

bool SupernodalLdlt::diagonalisePivot(Index first, const Block& pivot) {
    const Eigen::SelfAdjointEigenSolver<Block> eigen(pivot); // reads the lower triangle
    const auto& values = eigen.eigenvalues();
    if (!values.allFinite() || (values.array() == 0).any())
        return false;
    negativePivots_ += (values.array() < 0).count();
    axes_.middleCols(first, blockSize_) = eigen.eigenvectors();
    pivots_.col(first / blockSize_) = values;
    return true;
}

double SupernodalLdlt::products() const {
    double sum = 0;
    for (const auto& node : tree_.supernodes)
        for (int i = 0; i < node.width; ++i)
            sum += std::pow(
                static_cast<double>(node.width - i) + static_cast<double>(node.below.size()), 2);
    return sum * std::pow(blockSize_, 3) / 2;
}

double SupernodalLdlt::entries() const {
    double sum = 0;
    for (const auto& node : tree_.supernodes)
        sum += node.width * (node.width / 2.0 + static_cast<double>(node.below.size()));
    return sum * std::pow(blockSize_, 2);
}

void SupernodalLdlt::solve(Vectors& right) const {
    const Index together = right.cols() > 4 ? solvedTogether : 4;
    Vectors x(right.rows(), together);
    for (Index first = 0; first < right.cols(); first += together) {
        const Index count = std::min(together, right.cols() - first);
        if (count < together)
            x.setZero();
        for (Index row = 0; row < x.rows(); ++row)
            x.row(order_.indices()(row)).head(count) = right.row(row).segment(first, count);
        solvePermuted(x);
        for (Index row = 0; row < x.rows(); ++row)
            right.row(row).segment(first, count) = x.row(order_.indices()(row)).head(count);
    }
}

void SupernodalLdlt::solvePermuted(Vectors& x) const {
    std::size_t tallest = 0;
    for (const auto& node : tree_.supernodes)
        tallest = std::max(tallest, node.below.size());
    Vectors below(static_cast<Index>(tallest) * blockSize_, x.cols());
    for (std::size_t s = 0; s < tree_.supernodes.size(); ++s)
        eliminateFrom(x, below, s);
    x.array().colwise() /= pivots_.reshaped().array();
    for (std::size_t s = tree_.supernodes.size(); s-- > 0;)
        substituteInto(x, below, s);
}

/// Solves a supernode's rows with L and subtracts them from the rows below.
void SupernodalLdlt::eliminateFrom(Vectors& x, Vectors& below, std::size_t s) const {
    const auto& node = tree_.supernodes[s];
    const auto& l = columns_[s];
    const Index b = blockSize_, wide = l.cols(), under = l.rows() - wide, w = x.cols();
    double* own = x.data() + node.first * b * w;
    for (Index row = 0; row < wide; row += b) {
        turn(own + row * w, w, node.first * b + row, true);
        addProduct({b, w, row, -1, &l(row, 0), 1, l.rows(), own, w, own + row * w, w});
    }
    below.topRows(under).setZero();
    for (Index column = 0; column < wide; column += streamsTogether)
        addProduct({under, w, std::min(streamsTogether, wide - column), 1, &l(0, column) + wide, 1,
                    l.rows(), own + column * w, w, below.data(), w});
    for (std::size_t i = 0; i < node.below.size(); ++i)
        x.middleRows(node.below[i] * b, b) -= below.middleRows(static_cast<Index>(i) * b, b);
}

/// Solves a supernode's rows with Lᵀ; the rows below are known.
void SupernodalLdlt::substituteInto(Vectors& x, Vectors& below, std::size_t s) const {
    const auto& node = tree_.supernodes[s];
    const auto& l = columns_[s];
    const Index b = blockSize_, wide = l.cols(), under = l.rows() - wide, w = x.cols();
    double* own = x.data() + node.first * b * w;
    for (std::size_t i = 0; i < node.below.size(); ++i)
        below.middleRows(static_cast<Index>(i) * b, b) = x.middleRows(node.below[i] * b, b);
    addProduct({wide, w, under, -1, l.data() + wide, l.rows(), 1, below.data(), w, own, w});
    for (Index row = wide - b; row >= 0; row -= b) {
        const Index later = wide - row - b;
        addProduct({b, w, later, -1, &l(0, row) + row + b, l.rows(), 1, own + (row + b) * w, w,
                    own + row * w, w});
    }
    for (Index row = 0; row < wide; row += b)
        turn(own + row * w, w, node.first * b + row, false);
}

/// Turns rows into the axes of a pivot, or back.
void SupernodalLdlt::turn(double* rows, Index w, Index first, bool into) const {
    const Index b = blockSize_;
    std::array<double, 6 * solvedTogether> turned{};
    const double* axes = axes_.data() + first * b;
    addProduct({b, w, b, 1, axes, into ? b : 1, into ? 1 : b, rows, w, turned.data(), w});
    std::copy_n(turned.data(), b * w, rows);
}

} // namespace idiophone
