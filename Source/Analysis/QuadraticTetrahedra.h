// Finite elements for solids: 10-node tetrahedra. Their quadratic displacements bend without
// locking. Edges may be curved, and the elasticity is linear. Use TwoLayerShell for thin sheets.
#pragma once

#include "Analysis/ElasticLaw.h"
#include "Analysis/TetMesh.h"
#include "Analysis/VibrationModel.h"

namespace idiophone {

using ElementNodes = Eigen::Matrix<double, 10, 3>; ///< in TetMesh's order

ElementNodes nodesOf(const TetMesh& mesh, Eigen::Index tetrahedron);

struct ElementIntegrals {
    /// In N/m, with rows node by node in TetMesh's order.
    Eigen::Matrix<double, 30, 30> stiffness = Eigen::Matrix<double, 30, 30>::Zero();
    double volumeM3 = 0;
};

/// Integrates over an isoparametric element by the four points of Hammer, Marlowe & Stroud (1956).
/// It is exact if the edges are straight, because the integrand is quadratic then.
ElementIntegrals elementIntegrals(const ElementNodes& nodesMetres, const ElasticLaw& law);

/// Returns the minimum of dV over that of the element with straight edges, at the corners and at
/// the integration points. It is 1 if the edges are straight, and negative where the element is
/// turned inside out.
double leastVolumeShare(const ElementNodes& nodesMetres);

/// [10×10] ∫ N_i N_j dV over the element's volume, exact for straight edges: the consistent mass
/// per ρ V and direction.
Eigen::Matrix<double, 10, 10> elementMassShares();

/// Assembles the matrices of a free body. Row 3n + axis is the displacement of node n. The first
/// 3·surfaceVertexCount rows belong to the surface's vertices. The mass is consistent, so
/// frequencies of a closed polyhedral body fall to the true ones as elements shrink.
VibrationModel
quadraticTetrahedra(const TetMesh& mesh, const ElasticLaw& law, double densityKgPerM3);

} // namespace idiophone
