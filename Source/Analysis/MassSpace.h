// The inner product xᵀMy, in which modes are orthogonal. Internal to Analysis.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace idiophone {

class MassSpace {
public:
    /// Keeps a reference to the lower triangle of M [n×n].
    explicit MassSpace(const Eigen::SparseMatrix<double>& lower) : mass_(lower) {}

    Eigen::Index rows() const { return mass_.rows(); }

    /// M times each column.
    Eigen::MatrixXd times(const Eigen::Ref<const Eigen::MatrixXd>& block) const;

    /// Subtracts from each column its part within the span of the M-orthonormal basis, once: what
    /// is left of it is rounding of what was there.
    void projectOut(const Eigen::Ref<const Eigen::MatrixXd>& basis,
                    Eigen::Ref<Eigen::MatrixXd> block) const;

    /// Makes the columns M-orthonormal and returns the upper triangle R that takes them back to
    /// what they were; it is empty, and the columns are of no use, if they depend on one another.
    Eigen::MatrixXd orthonormalise(Eigen::MatrixXd& block) const;

private:
    Eigen::SparseSelfAdjointView<const Eigen::SparseMatrix<double>, Eigen::Lower> mass_;
};

} // namespace idiophone
