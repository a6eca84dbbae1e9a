// The spring-mass model of Raghuvanshi & Lin 2006, section 3: masses at the vertices, springs along
// the edges. Flat parts have no bending stiffness, because their vertices move freely along the
// normal. So instruments use TwoLayerShell.
#pragma once

#include "Analysis/VibrationModel.h"
#include "Mesh/Mesh.h"
#include "Object/Material.h"

namespace idiophone {

enum class SpringStiffness {
    literal,  ///< k = Y t (eq. 1): a membrane of E t = 2k/√3 on equilateral triangles
    vanGelder ///< k = Y t (A1 + A2)/L² (van Gelder 1998): E t = Y t on any mesh size
};

/// Rows 3v, 3v+1, 3v+2 are the displacement of vertex v; m_v = ρ t a_v (eq. 1). Every edge has a
/// length and every vertex a face, as repairMesh ensures.
VibrationModel springMassModel(const Mesh& mesh,
                               const Material& material,
                               double thicknessMetres,
                               SpringStiffness stiffness);

} // namespace idiophone
