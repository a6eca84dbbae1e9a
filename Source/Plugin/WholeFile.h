// How the user's files are written: whole, or not at all.
#pragma once

#include "Object/Result.h"

#include <cstddef>
#include <juce_core/juce_core.h>
#include <span>

namespace idiophone {

/// As `replaceFile` does (Object/FileBeside.h), and makes the folder. Where it fails, what was
/// there stays, and the error is a sentence that names the file and the fault. Not for the audio
/// thread.
Result<void> writeWhole(const juce::File& file, std::span<const std::byte> bytes);

} // namespace idiophone
