// A closed surface as a body of quadratic tetrahedra, as fine as the band asks for and the budget
// allows.
#pragma once

#include "Analysis/BodyModel.h"
#include "Analysis/ElasticLaw.h"

namespace idiophone {

/// Wood grows along the longest side of what is made of it.
GrainAxes grainAlong(const Mesh& mesh);

struct SolidBodySettings {
    Material material;
    ElasticLaw law; ///< of that material in the body's axes
    double maxFrequencyHz = highestAnalysedHz;
    int elementBudget = 8000; ///< tetrahedra, about; where the band asks for more they are coarser
};

/// The surface is remeshed where its triangles are much coarser or finer than the elements should
/// be; edges over 40° stay; three elements serve the shortest wavelength. Precondition: `surface`
/// is as repairMesh leaves it and its MeshCheck says that it is solid. Errors, one sentence each:
/// those of remesh and tetrahedralise, `cancelledMessage`.
Result<BodyModel>
solidBody(const Mesh& surface, const SolidBodySettings& settings, const WorkControl& control = {});

} // namespace idiophone
