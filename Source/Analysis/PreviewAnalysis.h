// Analyses a mesh into a first object within a second or two: few elements, a low band. It plays
// until ModalAnalysis is done. Its pitches are some per cent off.
#pragma once

#include "Analysis/ModalAnalysis.h"

namespace idiophone {

/// Analyses like `analyse`, but decimates the mesh to `previewVertices` and uses few elements.
/// Meshes of 20,000 triangles take less than 2 s (docs/decisions/0023). Shells always use the
/// two-layer method. The band ends where the elements no longer resolve it. Every vertex carries
/// shapes.
///
/// Reads name, source, material, method, thickness, `weldTolerance`, `largestComponentOnly` and the
/// band from the settings. Errors: those of `analyse`, and a mesh that cannot be decimated. Any
/// thread except the audio thread may call this function.
Result<ModalObject>
analysePreview(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control = {});

inline constexpr int previewVertices = 400;

} // namespace idiophone
