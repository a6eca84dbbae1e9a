// Builds a body of quadratic tetrahedra from a closed surface, as fine as the band needs within a
// budget.
#pragma once

#include "Analysis/BodyModel.h"
#include "Analysis/ElasticLaw.h"

namespace idiophone {

/// Returns the grain along the longest side of the body.
GrainAxes grainAlong(const Mesh& mesh);

struct SolidBodySettings {
    Material material;
    ElasticLaw law; ///< of the material, in the body's axes
    double maxFrequencyHz = highestAnalysedHz;
    int elementBudget = 8000; ///< approximate; large bodies get coarser tetrahedra
};

/// The elements suit the default band at least, within the budget, so that the ten lowest modes of
/// bars, rings, plates and walls are within 0.5 % of converged ones in any band. Long rods exceed
/// the budget. Remeshes the surface if its triangles are much coarser or finer than the elements
/// need, and curves the elements along it then. Edges over 40° are kept. The band ends where three
/// elements span the shortest wavelength. Precondition: `surface` is as repairMesh leaves it, and
/// its MeshCheck says that it is solid. Errors, each one sentence: those of remesh and
/// tetrahedralise, `cancelledMessage`.
Result<BodyModel>
solidBody(const Mesh& surface, const SolidBodySettings& settings, const WorkControl& control = {});

} // namespace idiophone
