// The content of the benchmarks: the factory objects, and a song from a MIDI file on the rosewood
// xylophone.
#pragma once

#include "Benchmarks/Benchmarks.h"

#include <filesystem>

namespace idiophone {

/// The path is empty if there is no song. The error names the object or the song at fault.
Result<BenchContent> factoryBenchContent(const std::filesystem::path& song);

} // namespace idiophone
