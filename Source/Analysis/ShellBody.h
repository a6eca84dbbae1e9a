// Builds a two-layer shell from a surface, with triangles as fine as the band needs within a
// budget.
#pragma once

#include "Analysis/BodyModel.h"

namespace idiophone {

inline constexpr int defaultShellVertices = 4000;

struct ShellBodySettings {
    Material material;
    double thicknessMetres = 0.005;
    double maxFrequencyHz = highestAnalysedHz;
    int vertexBudget =
        defaultShellVertices; ///< approximate; wider bands get coarser triangles than they need
    bool fitsMesh = true;     ///< false leaves the mesh and the band unchanged
};

/// Remeshes the surface if its triangles are much coarser or finer than the band needs. Edges over
/// 40° are kept. The band ends where four edges span the shortest wavelength. `surface` is as
/// repairMesh leaves it. Errors, each one sentence: those of remesh, `cancelledMessage`.
Result<BodyModel>
shellBody(const Mesh& surface, const ShellBodySettings& settings, const WorkControl& control = {});

} // namespace idiophone
