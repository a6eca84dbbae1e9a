// A modal object with shapes at fewer vertices, so that it is light enough to travel in a project.
#pragma once

#include "Object/ModalObject.h"

#include <cstddef>

namespace idiophone {

/// The object with shapes at no more than `rows` ≥ 1 of its vertices, spread evenly over the
/// surface (each the farthest from those before), and rounded to half precision, in which files
/// then hold them without loss. The mesh stays. The same object gives the same.
ModalObject withFewerShapes(ModalObject object, std::size_t rows);

} // namespace idiophone
