// Reads contacts as a game or physics engine reports them: JSON lines, specified in
// docs/impulses.md.
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
    std::string body;                    ///< distinguishes bodies of the same object
    std::optional<std::int64_t> vertex;  ///< of the object's mesh; else `pointMetres` applies
    std::array<double, 3> pointMetres{}; ///< in the object's coordinates
    std::array<double, 3> impulseNewtonSeconds{};
    double contactSeconds = 0; ///< 0: an ideal impulse
    double sizeRatio = 1;      ///< scale of the object; the point is on the unscaled object
};

class BadLines {
public:
    /// Adds an error. Each line is added once, in any order.
    void add(int line, const std::string& sentence);
    bool empty() const { return count == 0; }
    /// Returns one sentence with file and line for each of the first 20 errors, and the number of
    /// the others.
    Error error(const std::filesystem::path& file) const;

private:
    std::map<int, std::string> first; ///< limited, because every line of a large file may be bad
    std::size_t count = 0;
};

/// Returns the file's impulses in order of time; equal times keep the file's order. The error is
/// one sentence, or that of `BadLines`.
Result<std::vector<Impulse>> readImpulses(const std::filesystem::path& file);

} // namespace idiophone
