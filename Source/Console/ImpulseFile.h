// Contacts as a game or physics engine reports them: JSON lines, specified in docs/impulses.md.
#pragma once

#include "Object/Result.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

struct Impulse {
    int line = 0; ///< of the file, counted from 1
    double seconds = 0;
    std::string object;                  ///< a factory object's name or a modal object file
    std::string body;                    ///< tells several bodies of the same object apart
    std::optional<std::int64_t> vertex;  ///< of the object's mesh, or else:
    std::array<double, 3> pointMetres{}; ///< in the object's coordinates
    std::array<double, 3> impulseNewtonSeconds{};
    double contactSeconds = 0; ///< 0: an ideal impulse
    double sizeRatio = 1;      ///< the object scaled; the point is on it as it is
};

/// The error of some bad lines, by their numbers: one sentence with file and line for each (for the
/// first 20).
Error badLines(const std::filesystem::path& file, const std::map<int, std::string>& faults);

/// The file's impulses in order of time, those of one time in the file's order. The error is one
/// sentence, or `badLines`.
Result<std::vector<Impulse>> readImpulses(const std::filesystem::path& file);

} // namespace idiophone
