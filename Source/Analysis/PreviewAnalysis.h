// A first object from a mesh, within a second or two: few elements, a low band, to be played until
// the analysis proper (ModalAnalysis) has its own. Its pitches are some per cent off.
#pragma once

#include "Analysis/ModalAnalysis.h"

namespace idiophone {

/// As `analyse`, of a mesh brought down to `previewVertices` and filled or covered with so few
/// elements that meshes of 20,000 triangles take less than 2 s (docs/decisions/0023): shells by the
/// two layers whichever springs were asked for, the band as far as the elements serve it, every
/// vertex with its shapes. Of the settings it takes name, source, material, method, thickness,
/// `weldTolerance`, `largestComponentOnly` and the band.
/// Errors are those of `analyse`, and a mesh that cannot be brought down. Any thread; not for the
/// audio thread.
Result<ModalObject>
analysePreview(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control = {});

inline constexpr int previewVertices = 400;

} // namespace idiophone
