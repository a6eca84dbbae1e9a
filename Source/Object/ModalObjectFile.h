// SPDX-License-Identifier: Apache-2.0
// Reads and writes modal objects in the safetensors format with the extension .modal, as specified
// in docs/modal-format.md. The reader checks every length, index and value.
#pragma once

#include "Object/ModalObject.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace idiophone {

/// The reader refuses other versions.
inline constexpr int modalFormatVersion = 1;

/// Half precision is for shapes below 65 520 /√kg. Larger shapes are always written in single
/// precision.
enum class ShapePrecision { half, single };

/// Reads and validates an object. The error names the file and the fault. Not for the audio thread.
Result<ModalObject> readModalObject(const std::filesystem::path& file);

/// Reads an object from memory. `name` stands for the file in errors.
Result<ModalObject> readModalObject(std::span<const std::byte> bytes, std::string_view name);

/// Returns the file's bytes. The object must have passed `validated`, because the reader refuses
/// others. The same object always gives the same bytes.
std::vector<std::byte> encodeModalObject(const ModalObject& object,
                                         ShapePrecision precision = ShapePrecision::single);

/// Writes to a temporary file beside `file` and renames it, so that a crash leaves no partial file.
/// Refuses an object whose texts are too long to read back.
Result<void> writeModalObject(const ModalObject& object,
                              const std::filesystem::path& file,
                              ShapePrecision precision = ShapePrecision::single);

} // namespace idiophone
