// The inner product xᵀMy, in which modes are orthogonal, and products of the tall matrices whose
// columns are vectors of that space. Internal to Analysis.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace idiophone {

/// Vectors in columns [n×m], stored row by row: what is done to one is done to all of them.
using Vectors = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// C += factor · AᵀB for A [n×m] and B [n×w].
void addInnerProducts(Vectors& c, double factor, const Vectors& a, const Vectors& b);

/// C += factor · A B for A [n×m] and the small B [m×w].
void addCombinations(Vectors& c, double factor, const Vectors& a, const Vectors& b);

/// S X for a symmetric S given by its lower triangle [n×n].
Vectors symmetricTimes(const Eigen::SparseMatrix<double>& lower, const Vectors& x);

class MassSpace {
public:
    /// Keeps a reference to the lower triangle of M [n×n].
    explicit MassSpace(const Eigen::SparseMatrix<double>& lower) : mass_(lower) {}

    Eigen::Index rows() const { return mass_.rows(); }

    /// M times each column.
    Vectors times(const Vectors& block) const { return symmetricTimes(mass_, block); }

    /// Subtracts from each column its part within the span of the M-orthonormal basis, once: what
    /// is left of it is rounding of what was there.
    void projectOut(const Vectors& basis, Vectors& block) const;

    /// Makes the columns M-orthonormal, with their `image` M times them on return, and returns the
    /// upper triangle R that takes them back to what they were; it is empty, and the columns are of
    /// no use, if they depend on one another.
    Eigen::MatrixXd orthonormalise(Vectors& block, Vectors& image) const;

private:
    const Eigen::SparseMatrix<double>& mass_;
};

} // namespace idiophone
