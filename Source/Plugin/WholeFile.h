// Writes the user's files whole, or not at all.
#pragma once

#include "Object/Result.h"

#include <cstddef>
#include <juce_core/juce_core.h>
#include <span>

namespace idiophone {

/// Writes like `replaceFile` (Object/FileBeside.h), and makes the folder. On failure an existing
/// file is kept, and the error is a sentence that names the file and the fault. Not for the audio
/// thread.
Result<void> writeWhole(const juce::File& file, std::span<const std::byte> bytes);

} // namespace idiophone
