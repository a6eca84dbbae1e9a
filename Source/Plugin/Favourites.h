// Which presets a person likes: a small file of the user's settings, shared by all instances.
#pragma once

#include "Object/Result.h"

#include <juce_core/juce_core.h>
#include <set>
#include <string>

namespace idiophone {

/// Ids of presets. For the message thread; every change reads the file first, as another instance
/// may have changed it.
class Favourites {
public:
    /// An empty file is settings that this machine has no place for: then there are none.
    explicit Favourites(juce::File settings) : file(std::move(settings)) {}

    const std::set<std::string>& read();
    bool contains(const std::string& id) const { return ids.contains(id); }

    Result<void> set(const std::string& id, bool favourite);
    /// The preset has another id now.
    Result<void> rename(const std::string& from, const std::string& to);

private:
    Result<void> write();

    juce::File file;
    std::set<std::string> ids;
    bool isDamaged = false; ///< the file, which is then kept aside
};

} // namespace idiophone
