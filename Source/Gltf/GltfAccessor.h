// SPDX-License-Identifier: Apache-2.0
// Reads the accessors of a glTF file: its arrays of numbers.
#pragma once

#include "Gltf/GltfDocument.h"

namespace idiophone {

/// Returns the elements of an accessor as rows of `columns` numbers. Whole numbers that are marked
/// as normalised become fractions. The error is the end of a sentence that begins with the file's
/// name: no such accessor, another type, or outside its buffer. Any thread except the audio thread.
Result<Eigen::MatrixXd> numbersOf(const GltfDocument& document, int accessor, int columns);

} // namespace idiophone
