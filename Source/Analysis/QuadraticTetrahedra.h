// Finite elements for solids: 10-node tetrahedra, whose quadratic displacements bend without
// locking. Straight edges; linear elasticity; not for sheets so thin that TwoLayerShell serves.
#pragma once

#include "Analysis/ElasticLaw.h"
#include "Analysis/TetMesh.h"
#include "Analysis/VibrationModel.h"

namespace idiophone {

/// The stiffness of one element, [30×30] in N/m with rows node by node in TetMesh's order, exact:
/// its integrand is quadratic, which four points integrate (Hammer, Marlowe & Stroud 1956).
Eigen::Matrix<double, 30, 30> elementStiffness(const Eigen::Matrix<double, 4, 3>& cornersMetres,
                                               const ElasticLaw& law);

/// ∫ N_i N_j dV over the element's volume, [10×10], exact: the consistent mass per ρ V and
/// direction.
Eigen::Matrix<double, 10, 10> elementMassShares();

/// The body free in space. Row 3n + axis is the displacement of node n; the first
/// 3·surfaceVertexCount rows are those of the vertices of the surface that was meshed. The mass is
/// the consistent one: with it frequencies come down to the true ones as elements shrink, within a
/// closed, polyhedral body.
VibrationModel
quadraticTetrahedra(const TetMesh& mesh, const ElasticLaw& law, double densityKgPerM3);

} // namespace idiophone
