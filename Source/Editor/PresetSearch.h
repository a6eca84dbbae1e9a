// Searches presets, and lists their tags.
#pragma once

#include "Editor/PresetShelf.h"

#include <juce_core/juce_core.h>

namespace idiophone {

/// Whether each word occurs in the preset's name, author, description, folder or tags, ignoring
/// case. An empty search matches everything.
bool matchesSearch(const ShelvedPreset& preset, const juce::String& words);

/// All tags of the presets, ignoring case, without repeats; the most frequent first.
juce::StringArray tagsOf(const std::vector<ShelvedPreset>& presets);

/// "wood, bright, short".
juce::String tagLine(const std::vector<std::string>& tags);

} // namespace idiophone
