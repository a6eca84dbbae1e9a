#include "Analysis/SupernodalLdlt.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index panelColumns = 48; ///< eliminated before the rest of a front hears of it

/// Which blocks of a matrix of scalars have an entry.
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

/// C −= A Bᵀ in the lower triangle of C, strip by strip.
void subtractProduct(Eigen::Ref<MatrixXd> c,
                     const Eigen::Ref<const MatrixXd>& a,
                     const Eigen::Ref<const MatrixXd>& b) {
    constexpr Index strip = 96;
    for (Index j = 0; j < c.cols(); j += strip) {
        const Index width = std::min(strip, c.cols() - j), rest = c.rows() - j;
        c.block(j, j, rest, width).noalias() -=
            a.bottomRows(rest) * b.middleRows(j, width).transpose();
    }
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
        for (Index column = 0; column < wide; column += panelColumns) {
            if (stop())
                return LdltOutcome::stopped;
            const Index width = std::min(panelColumns, wide - column);
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

/// Eliminates the first `width` columns of what is left of a front, whose rows start at `first`.
bool SupernodalLdlt::eliminate(Index first, Eigen::Ref<MatrixXd> left, Index width) {
    const Index b = blockSize_, size = left.rows();
    MatrixXd unscaled(size, width); // L D, of which L is left in place
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
    const Eigen::SelfAdjointEigenSolver<Block> eigen(pivot); // of its lower triangle
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

void SupernodalLdlt::solveInPlace(Eigen::Ref<MatrixXd> right) const {
    Rows x = order_ * right;
    Rows below;
    const Index b = blockSize_;
    const auto turn = [&](Index first, Index rows, const auto& side) {
        for (Index row = first; row < first + rows; row += b)
            x.middleRows(row, b) =
                side(axes_.middleCols(row, b)).lazyProduct(x.middleRows(row, b)).eval();
    };
    for (std::size_t s = 0; s < tree_.supernodes.size(); ++s) {
        const auto& node = tree_.supernodes[s];
        const auto& l = columns_[s];
        auto own = x.middleRows(node.first * b, l.cols());
        turn(node.first * b, l.cols(), [](const auto& axes) { return axes.transpose(); });
        l.topRows(l.cols()).triangularView<Eigen::UnitLower>().solveInPlace(own);
        below.noalias() = l.bottomRows(l.rows() - l.cols()) * own;
        for (std::size_t i = 0; i < node.below.size(); ++i)
            x.middleRows(node.below[i] * b, b) -= below.middleRows(static_cast<Index>(i) * b, b);
    }
    x.array().colwise() /= pivots_.reshaped().array();
    for (std::size_t s = tree_.supernodes.size(); s-- > 0;) {
        const auto& node = tree_.supernodes[s];
        const auto& l = columns_[s];
        auto own = x.middleRows(node.first * b, l.cols());
        below.resize(l.rows() - l.cols(), x.cols());
        for (std::size_t i = 0; i < node.below.size(); ++i)
            below.middleRows(static_cast<Index>(i) * b, b) = x.middleRows(node.below[i] * b, b);
        own.noalias() -= l.bottomRows(l.rows() - l.cols()).transpose() * below;
        l.topRows(l.cols()).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(own);
        turn(node.first * b, l.cols(), [](const auto& axes) { return axes; });
    }
    right = order_.inverse() * x;
}

} // namespace idiophone
