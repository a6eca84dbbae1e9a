// A body as stiffness and mass matrices, K x = λ M x: the interface between models and eigensolver.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace idiophone {

/// n degrees of freedom; each model defines the order of its rows.
struct VibrationModel {
    Eigen::SparseMatrix<double> stiffness; ///< [n×n] K: symmetric, lower triangle only, in N/m
    Eigen::SparseMatrix<double> mass; ///< [n×n] M: positive definite, lower triangle only, in kg
    int rowsPerVertex = 1;            ///< consecutive rows that belong to one vertex
};

/// The mass matrix of a lumped model: masses [n] in kg, > 0, on the diagonal.
inline Eigen::SparseMatrix<double> diagonalMass(const Eigen::VectorXd& masses) {
    Eigen::SparseMatrix<double> mass(masses.size(), masses.size());
    mass = masses.asDiagonal();
    return mass;
}

} // namespace idiophone
