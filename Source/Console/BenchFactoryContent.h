// What the program brings to its benchmarks: the factory objects, and a song from a MIDI file
// played on the rosewood xylophone.
#pragma once

#include "Console/Benchmarks.h"

#include <filesystem>

namespace idiophone {

/// The error names the object or the song at fault. Without a song the path is empty.
Result<BenchContent> factoryBenchContent(const std::filesystem::path& song);

} // namespace idiophone
