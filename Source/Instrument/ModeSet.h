// Some modes of some objects, by names for the objects (SilencedModes.h) and the modes' numbers:
// those that are muted, or heard alone. Plain data, a little of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace idiophone {

/// Not for the audio thread.
class ModeSet {
public:
    /// Modes of all objects together; no more are taken in.
    static constexpr std::size_t capacity = 16384;
    /// Modes of an object are numbered from 0 to below this.
    static constexpr std::int32_t mostModes = 1 << 20;

    /// False where the mode was to be added and there is no room, or its number is out of range.
    bool set(const std::string& object, std::int32_t mode, bool isIn);
    bool contains(const std::string& object, std::int32_t mode) const;
    void clear(const std::string& object);

    bool empty() const { return modes.empty(); }
    std::size_t size() const { return count; }
    /// Ascending; empty where there is none.
    const std::set<std::int32_t>& of(const std::string& object) const;
    const std::map<std::string, std::set<std::int32_t>>& objects() const { return modes; }

    bool operator==(const ModeSet&) const = default;

private:
    std::map<std::string, std::set<std::int32_t>> modes; ///< no object without a mode
    std::size_t count = 0;
};

} // namespace idiophone
