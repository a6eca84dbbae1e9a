// SPDX-License-Identifier: Apache-2.0
// Sets of modes, as runs of consecutive numbers or as shares. Numbers of modes and blocks are
// stored in 32 bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Converts a number of a mode or block (≥ 0) to an array index.
constexpr std::size_t index(std::int32_t number) noexcept {
    return static_cast<std::size_t>(number);
}

/// Modes first to first + count − 1.
struct ModeRun {
    std::int32_t first = 0;
    std::int32_t count = 0;
};

/// A share of a mode's sound.
struct ModePart {
    std::int32_t mode = 0;
    float share = 1;
};

/// The share of one mode's state that another mode takes over.
struct ModeShare {
    std::int32_t from = 0;
    std::int32_t to = 0;
    double share = 0;
};

/// Replaces `runs` by the runs of consecutive numbers in ascending `modes`.
inline void findRuns(std::span<const std::int32_t> modes, std::vector<ModeRun>& runs) noexcept {
    runs.clear();
    for (const std::int32_t mode : modes)
        if (!runs.empty() && runs.back().first + runs.back().count == mode)
            ++runs.back().count;
        else
            runs.push_back({mode, 1});
}

} // namespace idiophone
