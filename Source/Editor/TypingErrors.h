// Counts typing errors between a typed word and another.
#pragma once

#include <juce_core/juce_core.h>
#include <string>

namespace idiophone {

using Letters = std::basic_string<juce::juce_wchar>;

/// Returns the minimum number of wrong, missing, additional or exchanged letters that turn `typed`
/// into the beginning of `word`. Words may still be incomplete while they are typed.
int typingErrors(const Letters& typed, const Letters& word);

/// Returns how many errors a typed word of that many letters may have: 1 from 4, 2 from 8.
int permittedErrors(int letters);

} // namespace idiophone
