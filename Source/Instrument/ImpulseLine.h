// Writes a strike as a line of a list of impulses (docs/impulses.md).
#pragma once

#include "Instrument/PlacedImpact.h"

#include <filesystem>
#include <string>

namespace idiophone {

/// Returns the name by which a list at a place on disk refers to an object. A factory object keeps
/// its name. A file in the list's folder or below has a path relative to that folder, so that both
/// can move together. Any other file has its absolute path. Reads no file; not for the audio
/// thread.
std::string objectInList(const std::string& nameOrFile, const std::filesystem::path& list);

/// The error for impacts on objects that have no name, because they come with a glTF scene.
inline constexpr const char* namelessObjects =
    "a list of impulses names objects, and those inside a glTF scene have no files of their own";

/// Returns the line with its line break. `object` comes from `objectInList` and is struck at
/// `sizeRatio`. The slot identifies the body. Any thread; allocates.
std::string impulseLine(const std::string& object, double sizeRatio, const PlacedImpact& impact);

} // namespace idiophone
