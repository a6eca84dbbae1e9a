// Stores the user's favourite presets in a small settings file, shared by all instances.
#pragma once

#include "Object/Result.h"

#include <juce_core/juce_core.h>
#include <set>
#include <string>

namespace idiophone {

/// Holds preset ids. For the message thread. Every change reads the file first, because another
/// instance may have changed it.
class Favourites {
public:
    /// An empty file means that this machine has no settings folder; then there are no favourites.
    explicit Favourites(juce::File settings) : file(std::move(settings)) {}

    const std::set<std::string>& read();
    bool contains(const std::string& id) const { return ids.contains(id); }

    Result<void> set(const std::string& id, bool favourite);
    /// Keeps a preset a favourite when its id changes.
    Result<void> rename(const std::string& from, const std::string& to);

private:
    Result<void> write();

    juce::File file;
    std::set<std::string> ids;
    bool isDamaged = false; ///< the file is unreadable; `write` renames it and starts a new one
};

} // namespace idiophone
