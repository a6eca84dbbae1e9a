// Which presets a search finds.
#pragma once

#include "Editor/PresetShelf.h"

#include <juce_core/juce_core.h>

namespace idiophone {

/// Whether every word occurs in the preset's name, author, description, folder or tags, in whatever
/// case. No words find everything.
bool matchesSearch(const ShelvedPreset& preset, const juce::String& words);

/// All tags of some presets, each once, whatever its case, the most frequent first.
juce::StringArray tagsOf(const std::vector<ShelvedPreset>& presets);

} // namespace idiophone
