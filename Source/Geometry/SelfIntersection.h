// Whether a surface passes through or touches itself. It finds out, and repairs nothing.
#pragma once

#include "Geometry/Mesh.h"

#include <atomic>
#include <optional>

namespace idiophone {

/// True when two faces share a point that is not a vertex or an edge of both, or lie folded onto
/// each other; surfaces that merely touch count. Decided by exact predicates on the coordinates as
/// they are. Nothing where fifty million pairs of faces would have to be looked at (slivers
/// whose bounding boxes all overlap), so that the time stays bounded, or once cancelled: take
/// it for yes. Indices are valid, coordinates finite; a face without area counts as intersecting.
std::optional<bool> intersectsItself(const Mesh& mesh,
                                     const std::atomic<bool>* cancelled = nullptr);

} // namespace idiophone
