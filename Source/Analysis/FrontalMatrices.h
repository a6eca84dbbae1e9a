// The dense matrices of a multifrontal factorisation. Internal to Analysis.
#pragma once

#include "Analysis/EliminationTree.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace idiophone {

class WorkTeam;

/// Makes the front of each supernode from the entries of a matrix and from the updates that its
/// children left. Updates wait on a stack within a part of the tree, and by themselves above it.
class FrontalMatrices {
public:
    /// The memory of one thread.
    struct Workspace {
        std::vector<double> front;   ///< grows to the largest one
        std::vector<double> updates; ///< the stack of the part in work
        std::vector<int> place;      ///< [blocks] first row in the front
    };
    using Front = Eigen::Map<Eigen::MatrixXd>;

    /// Keeps references to the tree and to the matrix, whose lower triangle is in its order.
    FrontalMatrices(const EliminationTree& tree,
                    int blockSize,
                    const Eigen::SparseMatrix<double>& permuted);

    /// Returns a supernode's front, in `work`; its lower triangle is valid. The children's updates
    /// are used up. Several threads may work on different parts at once.
    Front assemble(std::size_t s, Workspace& work);

    /// Puts the rest of an eliminated front on the stack for the parent.
    void push(std::size_t s, const Front& front, Workspace& work) const {
        append(s, front, work.updates);
    }

    /// Takes the only update left on the stack, that of the part's root.
    void keepRoot(std::size_t root, Workspace& work);

    /// Keeps the rest of the front of a supernode above all parts.
    void keep(std::size_t s, const Front& front) { append(s, front, kept_[s]); }

private:
    void append(std::size_t s, const Front& front, std::vector<double>& updates) const;
    void add(std::size_t child, const double* update, Front& front, const Workspace& work) const;
    std::size_t updateEntries(std::size_t s) const;

    const EliminationTree& tree_;
    int blockSize_;
    const Eigen::SparseMatrix<double>& permuted_;
    std::vector<std::vector<double>> kept_; ///< [supernodes]
};

/// C −= A Bᵀ in the lower triangle of C and a little above it, on the team if C is large.
void subtractProduct(Eigen::Ref<Eigen::MatrixXd> c,
                     const Eigen::Ref<const Eigen::MatrixXd>& a,
                     const Eigen::Ref<const Eigen::MatrixXd>& b,
                     WorkTeam* team);

} // namespace idiophone
