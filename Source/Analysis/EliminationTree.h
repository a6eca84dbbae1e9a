// The elimination order of a sparse symmetric matrix and its groups of unknowns. Internal to
// Analysis: the symbolic part of a factorisation, which does not depend on the values.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace idiophone {

/// Consecutive unknowns of the elimination order with nearly the same later neighbours.
struct Supernode {
    int first = 0, width = 0;
    int parent = -1;           ///< the supernode that receives the update matrix
    std::vector<int> below;    ///< later unknowns coupled to the supernode's, ascending
    std::vector<int> children; ///< supernodes
};

struct EliminationTree {
    std::vector<int> original;         ///< [n] the unknown at each place in the order
    std::vector<int> place;            ///< [n] the inverse of `original`
    std::vector<Supernode> supernodes; ///< children before parents
};

/// Orders a symmetric matrix by approximate minimum degree, a large one by nested dissection.
/// `places` [n×n] has an entry wherever the matrix has one, in either triangle and on the diagonal.
/// `blockSize` is the number of matrix rows per unknown. Supernodes of wide unknowns merge less
/// readily.
EliminationTree eliminationTree(const Eigen::SparseMatrix<double>& places, int blockSize);

} // namespace idiophone
