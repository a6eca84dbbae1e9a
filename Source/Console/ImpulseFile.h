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

/// What is wrong with lines of a file.
class BadLines {
public:
    /// Each line once, in any order.
    void add(int line, const std::string& sentence);
    bool empty() const { return count == 0; }
    /// One sentence with file and line for each of the first 20, and how many more there are.
    Error error(const std::filesystem::path& file) const;

private:
    std::map<int, std::string> first; ///< no more, as every line of a large file may be bad
    std::size_t count = 0;
};

/// The file's impulses in order of time, those of one time in the file's order. The error is one
/// sentence, or that of `BadLines`.
Result<std::vector<Impulse>> readImpulses(const std::filesystem::path& file);

} // namespace idiophone
