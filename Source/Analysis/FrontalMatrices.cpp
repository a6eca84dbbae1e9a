#include "Analysis/FrontalMatrices.h"

#include "Analysis/DenseKernels.h"
#include "Object/WorkTeam.h"

#include <algorithm>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index clearedAbove = 64;        ///< rows above the diagonal that elimination overwrites
constexpr Index rowsOfTile = 256;         ///< a panel's rows stay in the cache
constexpr double productsPerThread = 2e6; ///< a thread takes as long to start

} // namespace

FrontalMatrices::FrontalMatrices(const EliminationTree& tree,
                                 int blockSize,
                                 const Eigen::SparseMatrix<double>& permuted)
    : tree_(tree), blockSize_(blockSize), permuted_(permuted), kept_(tree.supernodes.size()) {}

FrontalMatrices::Front FrontalMatrices::assemble(std::size_t s, Workspace& work) {
    const auto& node = tree_.supernodes[s];
    const int b = blockSize_;
    const Index size = (node.width + std::ssize(node.below)) * b;
    if (std::ssize(work.front) < size * size)
        work.front = std::vector<double>(static_cast<std::size_t>(size * size));
    Front front(work.front.data(), size, size);
    for (Index column = 0; column < size; ++column) {
        const Index from = std::max<Index>(0, column - clearedAbove);
        front.col(column).tail(size - from).setZero();
    }
    work.place.resize(tree_.original.size());
    for (int i = 0; i < node.width; ++i)
        work.place[node.first + i] = i * b;
    for (int i = 0; i < static_cast<int>(node.below.size()); ++i)
        work.place[node.below[i]] = (node.width + i) * b;
    for (Index column = 0; column < Index{node.width} * b; ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator e(permuted_, node.first * b + column); e;
             ++e)
            front(work.place[e.row() / b] + e.row() % b, column) = e.value();
    // Updates that are not kept lie on top of the stack.
    std::size_t stacked = 0;
    for (const int child : node.children)
        stacked += kept_[child].empty() ? updateEntries(child) : 0;
    const double* next = work.updates.data() + work.updates.size() - stacked;
    for (const int child : node.children) {
        if (kept_[child].empty()) {
            add(child, next, front, work);
            next += updateEntries(child);
        } else {
            add(child, kept_[child].data(), front, work);
            kept_[child] = {};
        }
    }
    work.updates.resize(work.updates.size() - stacked);
    return front;
}

/// Adds an update matrix, packed by columns of its lower triangle of blocks.
void FrontalMatrices::add(std::size_t child,
                          const double* update,
                          Front& front,
                          const Workspace& work) const {
    const auto& rows = tree_.supernodes[child].below;
    for (std::size_t j = 0; j < rows.size(); ++j)
        for (int column = 0; column < blockSize_; ++column) {
            double* to = &front(0, work.place[rows[j]] + column);
            for (std::size_t i = j; i < rows.size(); ++i) {
                double* block = to + work.place[rows[i]];
                for (int row = 0; row < blockSize_; ++row)
                    block[row] += *update++;
            }
        }
}

/// Appends the rest of an eliminated front, packed as `add` takes it.
void FrontalMatrices::append(std::size_t s,
                             const Front& front,
                             std::vector<double>& updates) const {
    const Index wide = Index{tree_.supernodes[s].width} * blockSize_;
    if (updates.empty())
        updates.reserve(updateEntries(s));
    for (Index column = wide; column < front.cols(); ++column) {
        const Index top = column - column % blockSize_;
        updates.insert(updates.end(), &front(top, column),
                       &front(top, column) + front.rows() - top);
    }
}

void FrontalMatrices::keepRoot(std::size_t root, Workspace& work) {
    kept_[root].assign(work.updates.begin(), work.updates.end());
    work.updates.clear();
}

std::size_t FrontalMatrices::updateEntries(std::size_t s) const {
    const std::size_t blocks = tree_.supernodes[s].below.size();
    return blocks * (blocks + 1) / 2 * static_cast<std::size_t>(blockSize_ * blockSize_);
}

void subtractProduct(Eigen::Ref<MatrixXd> c,
                     const Eigen::Ref<const MatrixXd>& a,
                     const Eigen::Ref<const MatrixXd>& b,
                     WorkTeam* team) {
    constexpr Index strip = 16;
    const Index size = c.rows(), tiles = (size + rowsOfTile - 1) / rowsOfTile;
    const double products =
        static_cast<double>(size) * static_cast<double>(size) / 2 * static_cast<double>(a.cols());
    // The lowest tiles are the longest, so they come first.
    shareItems(products < productsPerThread ? nullptr : team, static_cast<std::size_t>(tiles),
               [&](std::size_t task, std::size_t) {
                   const Index top = (tiles - 1 - static_cast<Index>(task)) * rowsOfTile;
                   const Index end = std::min(size, top + rowsOfTile);
                   for (Index j = 0; j < end; j += strip) {
                       const Index row = std::max(top, j);
                       addProduct({std::min(strip, size - j), end - row, a.cols(), -1, b.data() + j,
                                   1, b.outerStride(), a.data() + row, a.outerStride(), &c(row, j),
                                   c.outerStride()});
                   }
               });
}

} // namespace idiophone
