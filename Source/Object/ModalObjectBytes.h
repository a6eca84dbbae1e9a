// SPDX-License-Identifier: Apache-2.0
// Modal objects to and from bytes in the safetensors format, as specified in docs/modal-format.md.
// The reader checks every length, index and value. Needs no file system.
#pragma once

#include "Object/ModalObject.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace idiophone {

/// The reader refuses other versions.
inline constexpr int modalFormatVersion = 1;

/// Half precision is for shapes below 65 520 /√kg. Larger shapes are always written in single
/// precision.
enum class ShapePrecision { half, single };

/// Reads and validates an object. `name` stands for the file in the error, which is one sentence.
/// Not for the audio thread.
Result<ModalObject> readModalObject(std::span<const std::byte> bytes, std::string_view name);

/// Returns the file's bytes. The object must have passed `validated`, because the reader refuses
/// others. The same object always gives the same bytes.
std::vector<std::byte> encodeModalObject(const ModalObject& object,
                                         ShapePrecision precision = ShapePrecision::single);

} // namespace idiophone
