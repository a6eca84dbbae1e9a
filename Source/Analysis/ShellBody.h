// A surface as a two-layer shell, with triangles as fine as the band asks for and the budget
// allows.
#pragma once

#include "Analysis/BodyModel.h"

namespace idiophone {

struct ShellBodySettings {
    Material material;
    double thicknessMetres = 0.005;
    double maxFrequencyHz = highestAnalysedHz;
    int vertexBudget = 4000; ///< about; where the band asks for more they are coarser
    bool fitsMesh = true;    ///< false leaves the mesh and the band as they are
};

/// The surface is remeshed where its triangles are much coarser or finer than they should be; edges
/// over 40° stay; four serve the shortest wavelength. `surface` is as repairMesh leaves it. Errors,
/// one sentence each: those of remesh, `cancelledMessage`.
Result<BodyModel>
shellBody(const Mesh& surface, const ShellBodySettings& settings, const WorkControl& control = {});

} // namespace idiophone
