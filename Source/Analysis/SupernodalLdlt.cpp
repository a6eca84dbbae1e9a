#include "Analysis/SupernodalLdlt.h"

#include "Analysis/DenseKernels.h"
#include "Object/WorkTeam.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index panelColumns = 48;       ///< eliminated before the rest of a front is updated
constexpr Index solvedTogether = 8;      ///< maximum number of right-hand sides
constexpr Index streamsTogether = 16;    ///< columns of L read together, as prefetching allows
constexpr double entriesPerThread = 3e5; ///< of L; a thread takes as long to start as to read them

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

/// Returns the team if that many entries of L are worth it.
WorkTeam* teamFor(Index entries, WorkTeam* team) {
    return static_cast<double>(entries) < 2 * entriesPerThread ? nullptr : team;
}

} // namespace

struct SupernodalLdlt::Progress {
    FrontalMatrices fronts;
    std::atomic<Index> negativePivots = 0;
    std::atomic<LdltOutcome> outcome = LdltOutcome::done;
};

SupernodalLdlt::SupernodalLdlt(const Eigen::SparseMatrix<double>& lower,
                               int blockSize,
                               WorkTeam* team)
    : blockSize_(blockSize), team_(team),
      tree_(eliminationTree(blockPlaces(lower, blockSize), blockSize)),
      parts_(treeParts(tree_, blockSize)), order_(lower.rows()), columns_(tree_.supernodes.size()),
      axes_(blockSize, lower.rows()), pivots_(blockSize, lower.rows() / blockSize) {
    for (Index row = 0; row < lower.rows(); ++row)
        order_.indices()(row) =
            tree_.place[row / blockSize] * blockSize + static_cast<int>(row % blockSize);
}

LdltOutcome SupernodalLdlt::factorise(const Eigen::SparseMatrix<double>& lower,
                                      const std::function<bool()>& stop) {
    Eigen::SparseMatrix<double> permuted(lower.rows(), lower.cols());
    permuted.selfadjointView<Eigen::Lower>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
    Progress progress{.fronts = {tree_, blockSize_, permuted}};
    const std::function<bool()> never = [] { return false; };
    {
        std::vector<FrontalMatrices::Workspace> workspaces(threadsOf(team_));
        shareItems(team_, parts_.parts.size(), [&](std::size_t part, std::size_t worker) {
            auto& work = workspaces[worker];
            const auto [first, root] = parts_.parts[part];
            for (std::size_t s = first; s <= root; ++s) {
                auto front = progress.fronts.assemble(s, work);
                if (!eliminateFront(s, front, nullptr, progress, worker == 0 ? stop : never))
                    return;
                progress.fronts.push(s, front, work);
            }
            progress.fronts.keepRoot(root, work);
        });
    }
    FrontalMatrices::Workspace work;
    for (const std::size_t s : parts_.above) {
        if (progress.outcome != LdltOutcome::done)
            break;
        auto front = progress.fronts.assemble(s, work);
        if (eliminateFront(s, front, team_, progress, stop))
            progress.fronts.keep(s, front);
    }
    negativePivots_ = progress.negativePivots;
    return progress.outcome;
}

/// Eliminates a supernode's columns and keeps them. Returns false if the factorisation has ended.
bool SupernodalLdlt::eliminateFront(std::size_t s,
                                    FrontalMatrices::Front& front,
                                    WorkTeam* team,
                                    Progress& progress,
                                    const std::function<bool()>& stop) {
    const auto& node = tree_.supernodes[s];
    const Index wide = Index{node.width} * blockSize_, size = front.rows();
    const Index panel = panelColumns / blockSize_ * blockSize_;
    for (Index column = 0; column < wide; column += panel) {
        if (stop())
            progress.outcome = LdltOutcome::stopped;
        if (progress.outcome != LdltOutcome::done)
            return false;
        const Index width = std::min(panel, wide - column);
        if (!eliminate(node.first * blockSize_ + column,
                       front.bottomRightCorner(size - column, size - column), width, team,
                       progress)) {
            progress.outcome = LdltOutcome::singular;
            return false;
        }
    }
    columns_[s] = front.leftCols(wide);
    for (Index row = 0; row < wide; row += blockSize_) {
        auto before = columns_[s].block(row, 0, blockSize_, row);
        before = (axes_.middleCols(node.first * blockSize_ + row, blockSize_).transpose() * before)
                     .eval();
    }
    return true;
}

/// Eliminates the first `width` columns of the rest of a front, whose rows start at `first`.
bool SupernodalLdlt::eliminate(
    Index first, Eigen::Ref<MatrixXd> left, Index width, WorkTeam* team, Progress& progress) {
    const Index b = blockSize_, size = left.rows();
    MatrixXd unscaled(size, width); // L D; L stays in `left`
    for (Index j = 0; j < width; j += b) {
        const Index rest = size - j - b;
        if (!diagonalisePivot(first + j, left.block(j, j, b, b), progress))
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
                    unscaled.bottomRows(rest), team);
    return true;
}

bool SupernodalLdlt::diagonalisePivot(Index first, const Block& pivot, Progress& progress) {
    const Eigen::SelfAdjointEigenSolver<Block> eigen(pivot); // reads the lower triangle
    const auto& values = eigen.eigenvalues();
    if (!values.allFinite() || (values.array() == 0).any())
        return false;
    progress.negativePivots += (values.array() < 0).count();
    axes_.middleCols(first, blockSize_) = eigen.eigenvectors();
    pivots_.col(first / blockSize_) = values;
    return true;
}

double SupernodalLdlt::products() const {
    double sum = 0;
    for (const auto& node : tree_.supernodes)
        sum += productsOf(node);
    return sum * std::pow(blockSize_, 3);
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
    const Index b = blockSize_, w = x.cols();
    Index tallest = 0;
    for (const auto& node : tree_.supernodes)
        tallest = std::max(tallest, std::ssize(node.below));
    std::vector<Vectors> below(threadsOf(team_)), outside(parts_.parts.size());
    const auto belowOf = [&](std::size_t worker) -> Vectors& {
        if (below[worker].size() == 0)
            below[worker].resize(tallest * b, w);
        return below[worker];
    };
    // Each part sums what it subtracts from the rows above it.
    shareItems(team_, parts_.parts.size(), [&](std::size_t part, std::size_t worker) {
        const auto [first, root] = parts_.parts[part];
        const auto& top = tree_.supernodes[root];
        const int end = top.first + top.width;
        outside[part].setZero(std::ssize(top.below) * b, w);
        for (std::size_t s = first; s <= root; ++s) {
            const auto& rows = tree_.supernodes[s].below;
            Vectors& products = belowOf(worker);
            eliminateFrom(x, products, s, nullptr);
            auto place = top.below.begin();
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const auto own = products.middleRows(static_cast<Index>(i) * b, b);
                if (rows[i] < end) {
                    x.middleRows(rows[i] * b, b) -= own;
                } else {
                    place = std::lower_bound(place, top.below.end(), rows[i]);
                    outside[part].middleRows((place - top.below.begin()) * b, b) += own;
                }
            }
        }
    });
    const auto subtract = [&](const std::vector<int>& rows, const Vectors& products) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            x.middleRows(rows[i] * b, b) -= products.middleRows(static_cast<Index>(i) * b, b);
    };
    for (std::size_t part = 0; part < parts_.parts.size(); ++part)
        subtract(tree_.supernodes[parts_.parts[part].root].below, outside[part]);
    for (const std::size_t s : parts_.above) {
        eliminateFrom(x, belowOf(0), s, team_);
        subtract(tree_.supernodes[s].below, below[0]);
    }
    x.array().colwise() /= pivots_.reshaped().array();
    for (auto s = parts_.above.rbegin(); s != parts_.above.rend(); ++s)
        substituteInto(x, belowOf(0), *s, team_);
    shareItems(team_, parts_.parts.size(), [&](std::size_t part, std::size_t worker) {
        for (std::size_t s = parts_.parts[part].root + 1; s-- > parts_.parts[part].first;)
            substituteInto(x, belowOf(worker), s, nullptr);
    });
}

/// Solves a supernode's rows with L and sets `below` to their products with the rows below.
void SupernodalLdlt::eliminateFrom(Vectors& x,
                                   Vectors& below,
                                   std::size_t s,
                                   WorkTeam* team) const {
    const auto& node = tree_.supernodes[s];
    const auto& l = columns_[s];
    const Index b = blockSize_, wide = l.cols(), under = l.rows() - wide, w = x.cols();
    double* own = x.data() + node.first * b * w;
    for (Index row = 0; row < wide; row += b) {
        turn(own + row * w, w, node.first * b + row, true);
        addProduct({b, w, row, -1, &l(row, 0), 1, l.rows(), own, w, own + row * w, w});
    }
    below.topRows(under).setZero();
    shareRows(teamFor(under * wide, team), under, [&](Index first, Index rows) {
        for (Index column = 0; column < wide; column += streamsTogether)
            addProduct({rows, w, std::min(streamsTogether, wide - column), 1,
                        l.data() + column * l.rows() + wide + first, 1, l.rows(), own + column * w,
                        w, below.data() + first * w, w});
    });
}

/// Solves a supernode's rows with Lᵀ; the rows below are known.
void SupernodalLdlt::substituteInto(Vectors& x,
                                    Vectors& below,
                                    std::size_t s,
                                    WorkTeam* team) const {
    const auto& node = tree_.supernodes[s];
    const auto& l = columns_[s];
    const Index b = blockSize_, wide = l.cols(), under = l.rows() - wide, w = x.cols();
    double* own = x.data() + node.first * b * w;
    for (std::size_t i = 0; i < node.below.size(); ++i)
        below.middleRows(static_cast<Index>(i) * b, b) = x.middleRows(node.below[i] * b, b);
    shareRows(teamFor(under * wide, team), wide, [&](Index first, Index rows) {
        addProduct({rows, w, under, -1, l.data() + first * l.rows() + wide, l.rows(), 1,
                    below.data(), w, own + first * w, w});
    });
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
