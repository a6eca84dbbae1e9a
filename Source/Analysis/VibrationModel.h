// A mesh as masses and springs in matrices: K x = λ M x, the meeting point of models and
// eigensolver.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace idiophone {

/// n degrees of freedom; the order of its rows is the model's own.
struct VibrationModel {
    Eigen::SparseMatrix<double> stiffness; ///< [n×n] symmetric, lower triangle only, in N/m
    Eigen::VectorXd mass;                  ///< [n] the diagonal of M in kg, > 0
    int rowsPerVertex = 1;                 ///< consecutive rows that belong to one vertex
};

} // namespace idiophone
