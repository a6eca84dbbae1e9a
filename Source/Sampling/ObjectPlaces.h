// Spreads places evenly over an object's surface.
#pragma once

#include "Object/ModalObject.h"
#include "Object/Result.h"

#include <array>
#include <cstddef>
#include <vector>

namespace idiophone {

/// Returns the place of a row of `shapeVertices`, in metres.
std::array<double, 3> vertexOfRow(const ModalObject& object, std::size_t row);

/// Returns rows of `shapeVertices`, each as far as possible from those before it, and the first one
/// from the centre of mass. So a smaller count gives the first ones of a larger. The error is the
/// end of a sentence that begins with the object: it has fewer places.
Result<std::vector<std::size_t>> spreadPlaces(const ModalObject& object, std::size_t count);

} // namespace idiophone
