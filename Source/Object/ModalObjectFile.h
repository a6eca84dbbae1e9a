// Modal objects as files: the safetensors container with the extension .modal, specified in
// docs/modal-format.md. Reading trusts nothing: every length, index and value is checked.
#pragma once

#include "Object/ModalObject.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace idiophone {

/// Half, for shapes below 65 520 /√kg; larger ones are written in single all the same.
enum class ShapePrecision { half, single };

/// Reads and validates; the error names the file and the fault. Not for the audio thread.
Result<ModalObject> readModalObject(const std::filesystem::path& file);

/// The same from memory; `name` stands for the file in errors.
Result<ModalObject> readModalObject(std::span<const std::byte> bytes, std::string_view name);

/// The file's bytes, of an object that passed `validated`: the reader refuses others. The same
/// object always gives the same bytes.
std::vector<std::byte> encodeModalObject(const ModalObject& object,
                                         ShapePrecision precision = ShapePrecision::single);

/// Writes to a temporary beside `file` and renames, so that a crash never leaves half an object.
/// Refuses one whose texts are too long to be read again.
Result<void> writeModalObject(const ModalObject& object,
                              const std::filesystem::path& file,
                              ShapePrecision precision = ShapePrecision::single);

} // namespace idiophone
