// The inner product xᵀMy, in which modes are orthogonal, and products of tall matrices with columns
// in that space. Internal to Analysis.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace idiophone {

/// Vectors in columns [n×m], stored by rows, because operations apply to all of them.
using Vectors = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns AᵀB for A [n×m] and B [n×w].
Vectors innerProducts(const Vectors& a, const Vectors& b);

/// C += factor · A B for A [n×m] and the small B [m×w].
void addCombinations(Vectors& c, double factor, const Vectors& a, const Vectors& b);

/// Returns S X for a symmetric S [n×n], given by its lower triangle.
Vectors symmetricTimes(const Eigen::SparseMatrix<double>& lower, const Vectors& x);

class MassSpace {
public:
    /// Keeps a reference to the lower triangle of M [n×n].
    explicit MassSpace(const Eigen::SparseMatrix<double>& lower) : mass_(lower) {}

    Eigen::Index rows() const { return mass_.rows(); }

    Vectors times(const Vectors& block) const { return symmetricTimes(mass_, block); }

    /// Subtracts from each column its part in the span of the M-orthonormal basis, once. Only
    /// rounding errors of that part remain.
    void projectOut(const Vectors& basis, Vectors& block) const;

    /// Makes the columns M-orthonormal and sets `image` to M times them. Returns the upper triangle
    /// R that turns the new columns back into the old ones. R is empty if the columns are linearly
    /// dependent; they are then useless.
    Eigen::MatrixXd orthonormalise(Vectors& block, Vectors& image) const;

private:
    const Eigen::SparseMatrix<double>& mass_;
};

} // namespace idiophone
