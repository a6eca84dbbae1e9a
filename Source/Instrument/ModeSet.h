// A set of modes of several objects, such as the muted modes. It identifies objects by name
// (SilencedModes.h) and modes by number. Plain data.
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
    /// Maximum of modes of all objects together.
    static constexpr std::size_t capacity = 16384;
    /// Modes of an object are numbered from 0 to maximumModes − 1.
    static constexpr std::int32_t maximumModes = 1 << 20;

    /// Adds or removes a mode. Returns false if the set is full or the number is out of range.
    bool set(const std::string& object, std::int32_t mode, bool isIn);
    bool contains(const std::string& object, std::int32_t mode) const;
    void clear(const std::string& object);

    bool empty() const { return modes.empty(); }
    std::size_t size() const { return count; }
    /// Returns the object's modes in ascending order; empty if there are none.
    const std::set<std::int32_t>& of(const std::string& object) const;
    const std::map<std::string, std::set<std::int32_t>>& objects() const { return modes; }

    bool operator==(const ModeSet&) const = default;

private:
    std::map<std::string, std::set<std::int32_t>> modes; ///< objects without modes have no entry
    std::size_t count = 0;
};

} // namespace idiophone
