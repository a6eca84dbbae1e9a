// L D Lᵀ of a sparse symmetric, possibly indefinite matrix of B × B blocks, one for each pair of
// neighbouring vertices. Internal to Analysis. CHOLMOD's supernodal code needs definite matrices
// and cannot be stopped; Eigen's works on single entries.
#pragma once

#include "Analysis/FrontalMatrices.h"
#include "Analysis/MassSpace.h"
#include "Analysis/TreeParts.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <vector>

namespace idiophone {

class WorkTeam;

enum class LdltOutcome { done, singular, stopped };

/// The multifrontal method (Duff & Reid 1983). A supernode is a set of columns with like structure,
/// eliminated together in a dense matrix. So nearly all work is products of dense matrices. Pivots
/// are the B × B blocks, applied through their eigenvectors. They are as large as possible without
/// exchanging blocks. No pivot is inverted, because an inverse loses digits.
///
/// Independent subtrees ("parts") go to several threads, then the supernodes above them one by one,
/// each divided among the threads. The order of additions does not depend on their number.
class SupernodalLdlt {
public:
    /// Orders and analyses the pattern of a lower triangle [n×n]. n is a multiple of the block
    /// size, 1 … 6.
    /// The team outlives it. It may be null, with the same result.
    SupernodalLdlt(const Eigen::SparseMatrix<double>& lower,
                   int blockSize,
                   WorkTeam* team = nullptr);

    /// Factorises a matrix with this pattern or part of it. Calls `stop` regularly, from
    /// the caller's thread.
    LdltOutcome factorise(const Eigen::SparseMatrix<double>& lower,
                          const std::function<bool()>& stop);

    Eigen::Index negativePivots() const { return negativePivots_; }

    /// The number of multiplications of one factorisation.
    double products() const;

    /// The number of entries of L.
    double entries() const;

    /// Replaces right-hand sides [n×m] by the solutions. It solves four or eight together, which is
    /// several times faster than one by one.
    void solve(Vectors& right) const;

private:
    using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
    /// The state of one factorisation, which all threads share.
    struct Progress;

    bool eliminateFront(std::size_t s,
                        FrontalMatrices::Front& front,
                        WorkTeam* team,
                        Progress& progress,
                        const std::function<bool()>& stop);
    bool eliminate(Eigen::Index first,
                   Eigen::Ref<Eigen::MatrixXd> left,
                   Eigen::Index width,
                   WorkTeam* team,
                   Progress& progress);
    bool diagonalisePivot(Eigen::Index first, const Block& pivot, Progress& progress);

    void solvePermuted(Vectors& x) const;
    void eliminateFrom(Vectors& x, Vectors& below, std::size_t s, WorkTeam* team) const;
    void substituteInto(Vectors& x, Vectors& below, std::size_t s, WorkTeam* team) const;
    void turn(double* rows, Eigen::Index w, Eigen::Index first, bool into) const;

    int blockSize_;
    WorkTeam* team_;
    EliminationTree tree_;
    TreeParts parts_;
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order_;
    std::vector<Eigen::MatrixXd>
        columns_; ///< each supernode's part of L; its top is a unit lower triangle
    Eigen::MatrixXd axes_, pivots_; ///< of each pivot: [B × n] and [B × blocks]
    Eigen::Index negativePivots_ = 0;
};

} // namespace idiophone
