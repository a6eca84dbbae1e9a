// A blow as a line of a list of impulses (docs/impulses.md).
#pragma once

#include "Instrument/PlacedBlow.h"

#include <filesystem>
#include <string>

namespace idiophone {

/// How a list at a place on disk names an object: a factory object by its name, a file in the
/// list's folder or below by its path from there, so that they can be moved together, and any other
/// file by its whole path. Reads no file; not for the audio thread.
std::string objectInList(const std::string& nameOrFile, const std::filesystem::path& list);

/// With its line break. `object` is as of `objectInList`, and struck in that size. Bodies are told
/// apart by their slots. For any thread; allocates.
std::string impulseLine(const std::string& object, double sizeRatio, const PlacedBlow& blow);

} // namespace idiophone
