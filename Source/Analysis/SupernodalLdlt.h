// L D Lᵀ of a sparse symmetric, possibly indefinite matrix made of B × B blocks, one for each pair
// of neighbouring vertices. Internal to Analysis. CHOLMOD's supernodal code takes definite matrices
// only and cannot be stopped; Eigen's works entry by entry.
#pragma once

#include "Analysis/EliminationTree.h"
#include "Analysis/MassSpace.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

namespace idiophone {

enum class LdltOutcome { done, singular, stopped };

/// The multifrontal method (Duff & Reid 1983): columns of like structure, a supernode, are
/// eliminated together in a dense matrix, so that nearly all work is products of dense matrices.
/// Pivots are the B × B blocks, applied through their eigenvectors: as large as they can be without
/// exchanging blocks, and none is inverted, which would cost digits.
class SupernodalLdlt {
public:
    /// Orders and analyses a lower triangle [n×n], n a multiple of the block size 1 … 6, for the
    /// places of its entries.
    SupernodalLdlt(const Eigen::SparseMatrix<double>& lower, int blockSize);

    /// Factorises a matrix of the same places, or some of them. `stop` is asked now and then.
    LdltOutcome factorise(const Eigen::SparseMatrix<double>& lower,
                          const std::function<bool()>& stop);

    Eigen::Index negativePivots() const { return negativePivots_; }

    /// How many multiplications a factorisation takes.
    double products() const;

    /// How many entries L has.
    double entries() const;

    /// Replaces right-hand sides [n×m] by the solutions. They are taken four or eight at a time,
    /// which is several times quicker than one by one.
    void solve(Vectors& right) const;

private:
    using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

    void assemble(const Supernode& node,
                  const Eigen::SparseMatrix<double>& permuted,
                  Eigen::MatrixXd& front);
    bool eliminate(Eigen::Index first, Eigen::Ref<Eigen::MatrixXd> left, Eigen::Index width);
    bool diagonalisePivot(Eigen::Index first, const Block& pivot);
    void solvePermuted(Vectors& x) const;
    void eliminateFrom(Vectors& x, Vectors& below, std::size_t s) const;
    void substituteInto(Vectors& x, Vectors& below, std::size_t s) const;
    void turn(double* rows, Eigen::Index w, Eigen::Index first, bool into) const;

    int blockSize_;
    EliminationTree tree_;
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order_;
    std::vector<Eigen::MatrixXd>
        columns_; ///< each supernode's part of L, unit lower triangle on top
    std::vector<Eigen::MatrixXd> updates_; ///< what a supernode leaves for its parent
    std::vector<int> placeInFront_;        ///< of each block of unknowns, its first row
    Eigen::MatrixXd axes_, pivots_;        ///< of each pivot: [B × n] and [B × blocks]
    Eigen::Index negativePivots_ = 0;
};

} // namespace idiophone
