// SPDX-License-Identifier: Apache-2.0
// Reads and writes modal objects on disk, with the extension .modal.
#pragma once

#include "Object/ModalObjectBytes.h"

#include <filesystem>

namespace idiophone {

/// Reads and validates an object. The error names the file and the fault. Not for the audio thread.
Result<ModalObject> readModalObject(const std::filesystem::path& file);

/// Writes to a temporary file beside `file` and renames it, so that a crash leaves no partial file.
/// Refuses an object whose texts are too long to read back.
Result<void> writeModalObject(const ModalObject& object,
                              const std::filesystem::path& file,
                              ShapePrecision precision = ShapePrecision::single);

} // namespace idiophone
