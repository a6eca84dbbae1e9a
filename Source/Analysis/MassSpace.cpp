#include "Analysis/MassSpace.h"

#include <Eigen/Cholesky>

namespace idiophone {

using Eigen::MatrixXd;

MatrixXd MassSpace::times(const Eigen::Ref<const MatrixXd>& block) const {
    return mass_ * block;
}

void MassSpace::projectOut(const Eigen::Ref<const MatrixXd>& basis,
                           Eigen::Ref<MatrixXd> block) const {
    if (basis.cols() == 0)
        return;
    const MatrixXd shares = basis.transpose() * times(block);
    block.noalias() -= basis * shares;
}

MatrixXd MassSpace::orthonormalise(MatrixXd& block) const {
    // Cholesky's factor of the products loses digits where columns are nearly dependent, so twice.
    MatrixXd back = MatrixXd::Identity(block.cols(), block.cols());
    for (int pass = 0; pass < 2; ++pass) {
        const Eigen::VectorXd lengths = block.colwise().norm();
        if (!(lengths.minCoeff() > 0))
            return {};
        block = (block * lengths.cwiseInverse().asDiagonal()).eval();
        const Eigen::LLT<MatrixXd> cholesky(block.transpose() * times(block));
        if (cholesky.info() != Eigen::Success)
            return {};
        cholesky.matrixU().solveInPlace<Eigen::OnTheRight>(block);
        back = (cholesky.matrixU() * (lengths.asDiagonal() * back)).eval();
    }
    return back;
}

} // namespace idiophone
