// Detects whether a surface passes through or touches itself. It repairs nothing.
#pragma once

#include "Mesh/Mesh.h"

#include <atomic>
#include <optional>

namespace idiophone {

/// Returns true if two faces share a point that is not a common vertex or edge, or if one is folded
/// onto the other. Touching surfaces and faces without area count. Uses exact predicates on the
/// coordinates.
///
/// Returns nothing if cancelled or after fifty million pairs of faces (slivers whose bounding boxes
/// all overlap), so that the time is bounded. Treat this result as an intersection. Indices must be
/// valid, coordinates finite.
std::optional<bool> intersectsItself(const Mesh& mesh,
                                     const std::atomic<bool>* cancelled = nullptr);

} // namespace idiophone
