// Searches presets, and lists their tags.
#pragma once

#include "Editor/PresetShelf.h"

#include <juce_core/juce_core.h>
#include <optional>

namespace idiophone {

/// Returns with how many typing errors every word occurs in the preset, ignoring case: 0 if each
/// occurs as typed in its name, author, description, folder or tags. Errors are forgiven in the
/// words of name, folder and tags. Nothing if a word does not occur. An empty search has 0.
std::optional<int> searchErrors(const ShelvedPreset& preset, const juce::String& words);

/// All tags of the presets, ignoring case, without repeats: first the words for sound, from dark to
/// bright, short to long, soft to hard, then the others, the most frequent first.
juce::StringArray tagsOf(const std::vector<ShelvedPreset>& presets);

/// "wood, bright, short".
juce::String tagLine(const std::vector<std::string>& tags);

} // namespace idiophone
