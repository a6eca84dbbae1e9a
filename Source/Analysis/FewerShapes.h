// Reduces the shapes of a modal object to fewer vertices, so that a project file can hold it.
#pragma once

#include "Object/ModalObject.h"

#include <cstddef>

namespace idiophone {

/// Keeps shapes at no more than `rows` ≥ 1 vertices, spread evenly over the surface: each is the
/// farthest from the earlier ones. Rounds them to half precision, which files hold without loss.
/// The mesh is unchanged. The result is deterministic.
ModalObject withFewerShapes(ModalObject object, std::size_t rows);

} // namespace idiophone
