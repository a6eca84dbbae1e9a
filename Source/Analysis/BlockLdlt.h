// L D Lᵀ of a sparse symmetric, possibly indefinite matrix made of B × B blocks, one for each pair
// of neighbouring vertices. Internal to Analysis. Eigen's SimplicialLDLT works entry by entry,
// several times slower, and cannot be stopped; CHOLMOD's fast factorisation does not take
// indefinite ones.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace idiophone {

enum class LdltOutcome { done, singular, stopped };

/// Up-looking factorisation after T. Davis, "Algorithm 849: LDL" (2005), on blocks. Each block of
/// unknowns is turned to the axes in which its pivot is diagonal: pivots are then as large as they
/// can be without exchanging blocks, and no block is inverted, which would cost digits.
template <int B>
class BlockLdlt {
public:
    /// Orders and analyses the lower triangle [n×n], n a multiple of B; keeps a copy of its values.
    explicit BlockLdlt(const Eigen::SparseMatrix<double>& lower)
        : count_(static_cast<int>(lower.rows() / B)) {
        order(lower);
        gather(lower);
        analyse();
    }

    /// Factorises A − shift·I. `stop` is asked now and then.
    template <class Stop>
    LdltOutcome factorise(double shift, const Stop& stop) {
        negativePivots_ = 0;
        std::vector<int> filled(starts_.begin(), starts_.end() - 1), flag(count_, -1), pattern;
        Blocks work(count_, Block::Zero());
        for (int k = 0; k < count_; ++k) {
            if (k % 32 == 0 && stop())
                return LdltOutcome::stopped;
            Block pivot = diagonal_[k] - shift * Block::Identity();
            pattern.clear();
            flag[k] = k;
            for (int p = columns_[k]; p < columns_[k + 1]; ++p) {
                work[rows_[p]] = values_[p];
                for (int i = rows_[p]; flag[i] != k; i = parent_[i]) {
                    pattern.push_back(i);
                    flag[i] = k;
                }
            }
            // Ascending order is descendants before ancestors, as a parent has the higher number.
            std::ranges::sort(pattern);
            for (const int i : pattern) {
                const Block y = rotation_[i].transpose() * work[i];
                work[i].setZero();
                for (int p = starts_[i]; p < filled[i]; ++p)
                    work[lowerRows_[p]].noalias() -= lower_[p] * y;
                Block& entry = lower_[filled[i]];
                entry = y.transpose() * pivots_[i].cwiseInverse().asDiagonal();
                pivot.noalias() -= entry * y;
                lowerRows_[filled[i]++] = k;
            }
            if (!diagonalisePivot(pivot, k))
                return LdltOutcome::singular;
        }
        return LdltOutcome::done;
    }

    Eigen::Index negativePivots() const { return negativePivots_; }

    /// Replaces a right-hand side [n] by the solution.
    void solveInPlace(Eigen::Ref<Eigen::VectorXd> x) const {
        Eigen::VectorXd permuted(x.size());
        for (int i = 0; i < count_; ++i)
            at(permuted, i) = at(x, original_[i]);
        for (int j = 0; j < count_; ++j) {
            const Column value = rotation_[j].transpose() * at(permuted, j);
            for (int p = starts_[j]; p < starts_[j + 1]; ++p)
                at(permuted, lowerRows_[p]).noalias() -= lower_[p] * value;
            at(permuted, j) = value.cwiseQuotient(pivots_[j]);
        }
        for (int j = count_ - 1; j >= 0; --j) {
            Column value = at(permuted, j);
            for (int p = starts_[j]; p < starts_[j + 1]; ++p)
                value.noalias() -= lower_[p].transpose() * at(permuted, lowerRows_[p]);
            at(permuted, j).noalias() = rotation_[j] * value;
        }
        for (int i = 0; i < count_; ++i)
            at(x, original_[i]) = at(permuted, i);
    }

private:
    using Block = Eigen::Matrix<double, B, B>;
    using Column = Eigen::Matrix<double, B, 1>;
    using Blocks = std::vector<Block, Eigen::aligned_allocator<Block>>;
    using Columns = std::vector<Column, Eigen::aligned_allocator<Column>>;

    template <class Vector>
    static auto at(Vector& vector, int block) {
        return vector.template segment<B>(Eigen::Index{block} * B);
    }

    void order(const Eigen::SparseMatrix<double>& lower) {
        std::vector<Eigen::Triplet<double>> entries;
        forEachBlock(lower, [&](int row, int column) {
            entries.emplace_back(row, column, 1);
            entries.emplace_back(column, row, 1);
        });
        Eigen::SparseMatrix<double> pattern(count_, count_);
        pattern.setFromTriplets(entries.begin(), entries.end());
        Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
        Eigen::AMDOrdering<int>()(pattern, permutation);
        original_.assign(permutation.indices().begin(), permutation.indices().end());
        place_.resize(count_);
        for (int i = 0; i < count_; ++i)
            place_[original_[i]] = i;
    }

    /// Calls with each block of the lower triangle once, its first column's entries in order.
    template <class Visit>
    void forEachBlock(const Eigen::SparseMatrix<double>& lower, const Visit& visit) const {
        for (int column = 0; column < count_; ++column) {
            std::vector<int> blockRows;
            for (int c = 0; c < B; ++c)
                for (Eigen::SparseMatrix<double>::InnerIterator e(lower, column * B + c); e; ++e)
                    blockRows.push_back(static_cast<int>(e.row()) / B);
            std::ranges::sort(blockRows);
            const auto repeated = std::ranges::unique(blockRows);
            blockRows.erase(repeated.begin(), repeated.end());
            for (const int row : blockRows)
                visit(row, column);
        }
    }

    /// The upper triangle of the permuted matrix by columns, and its diagonal.
    void gather(const Eigen::SparseMatrix<double>& lower) {
        std::vector<std::pair<int, int>> places; // column, row in the new order
        forEachBlock(lower, [&](int row, int column) {
            if (row != column)
                places.push_back(std::minmax(place_[row], place_[column], std::greater{}));
        });
        std::ranges::sort(places);
        columns_.assign(count_ + 1, 0);
        for (const auto& [column, row] : places) {
            ++columns_[column + 1];
            rows_.push_back(row);
        }
        for (int k = 0; k < count_; ++k)
            columns_[k + 1] += columns_[k];
        values_.assign(places.size(), Block::Zero());
        diagonal_.assign(count_, Block::Zero());
        for (Eigen::Index c = 0; c < lower.outerSize(); ++c)
            for (Eigen::SparseMatrix<double>::InnerIterator e(lower, c); e; ++e) {
                const int r = static_cast<int>(e.row()) % B, s = static_cast<int>(e.col()) % B;
                const int i = place_[e.row() / B], k = place_[e.col() / B];
                if (i == k) {
                    diagonal_[i](r, s) = e.value();
                    diagonal_[i](s, r) = e.value();
                    continue;
                }
                const int column = std::max(i, k), row = std::min(i, k);
                const auto found = std::lower_bound(rows_.begin() + columns_[column],
                                                    rows_.begin() + columns_[column + 1], row);
                Block& block = values_[static_cast<std::size_t>(found - rows_.begin())];
                (i < k ? block(r, s) : block(s, r)) = e.value();
            }
    }

    /// The elimination tree and the size of each column of L.
    void analyse() {
        parent_.assign(count_, -1);
        std::vector<int> flag(count_, -1), sizes(count_, 0);
        for (int k = 0; k < count_; ++k) {
            flag[k] = k;
            for (int p = columns_[k]; p < columns_[k + 1]; ++p)
                for (int i = rows_[p]; flag[i] != k; i = parent_[i]) {
                    if (parent_[i] < 0)
                        parent_[i] = k;
                    ++sizes[i];
                    flag[i] = k;
                }
        }
        starts_.assign(count_ + 1, 0);
        for (int k = 0; k < count_; ++k)
            starts_[k + 1] = starts_[k] + sizes[k];
        lowerRows_.resize(starts_[count_]);
        lower_.resize(starts_[count_]);
        rotation_.resize(count_);
        pivots_.resize(count_);
    }

    bool diagonalisePivot(const Block& pivot, int k) {
        const Eigen::SelfAdjointEigenSolver<Block> eigen(pivot);
        const auto& values = eigen.eigenvalues();
        if (!values.allFinite() || (values.array() == 0).any())
            return false;
        negativePivots_ += (values.array() < 0).count();
        rotation_[k] = eigen.eigenvectors();
        pivots_[k] = values;
        return true;
    }

    int count_; ///< blocks on the diagonal
    std::vector<int> original_, place_;
    std::vector<int> columns_, rows_; ///< permuted matrix above its diagonal
    Blocks values_, diagonal_;
    std::vector<int> parent_, starts_, lowerRows_;
    Blocks lower_, rotation_; ///< L takes each column's unknowns turned to its pivot's axes
    Columns pivots_;
    Eigen::Index negativePivots_ = 0;
};

} // namespace idiophone
