// In which order a sparse symmetric matrix is eliminated, and which unknowns together. Internal to
// Analysis: the part of a factorisation that its values have no influence on.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace idiophone {

/// Consecutive unknowns of the elimination order that have nearly the same neighbours to come.
struct Supernode {
    int first = 0, width = 0;
    int parent = -1;           ///< the supernode that what this one leaves is added to
    std::vector<int> below;    ///< unknowns after them that meet them, ascending
    std::vector<int> children; ///< supernodes
};

struct EliminationTree {
    std::vector<int> original;         ///< [n] which unknown comes when
    std::vector<int> place;            ///< [n] its inverse
    std::vector<Supernode> supernodes; ///< children before parents
};

/// For a symmetric matrix with entries in these places [n×n] (either triangle will do; the diagonal
/// is among them), in an approximate minimum-degree order. `blockSize` is how many rows of the true
/// matrix an unknown stands for; wide ones are joined less willingly.
EliminationTree eliminationTree(const Eigen::SparseMatrix<double>& places, int blockSize);

} // namespace idiophone
