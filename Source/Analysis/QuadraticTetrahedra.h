// Finite elements for solids: 10-node tetrahedra. Their quadratic displacements bend without
// locking. Edges are straight and the elasticity is linear. Use TwoLayerShell for thin sheets.
#pragma once

#include "Analysis/ElasticLaw.h"
#include "Analysis/TetMesh.h"
#include "Analysis/VibrationModel.h"

namespace idiophone {

/// The stiffness of one element, [30×30] in N/m, with rows node by node in TetMesh's order. It is
/// exact: four points integrate the quadratic integrand (Hammer, Marlowe & Stroud 1956).
Eigen::Matrix<double, 30, 30> elementStiffness(const Eigen::Matrix<double, 4, 3>& cornersMetres,
                                               const ElasticLaw& law);

/// [10×10] ∫ N_i N_j dV over the element's volume, exact: the consistent mass per ρ V and
/// direction.
Eigen::Matrix<double, 10, 10> elementMassShares();

/// Assembles the matrices of a free body. Row 3n + axis is the displacement of node n. The first
/// 3·surfaceVertexCount rows belong to the surface's vertices. The mass is consistent, so
/// frequencies of a closed polyhedral body fall to the true ones as elements shrink.
VibrationModel
quadraticTetrahedra(const TetMesh& mesh, const ElasticLaw& law, double densityKgPerM3);

} // namespace idiophone
