// Recognises shortcuts with the command key: Ctrl, or Cmd on macOS.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// `letter` is lower case.
inline bool isCommand(const juce::KeyPress& key, char letter, bool shift = false) {
    const auto mods = key.getModifiers();
    return mods.isCommandDown() && !mods.isAltDown() && mods.isShiftDown() == shift &&
           juce::CharacterFunctions::toLowerCase(static_cast<juce::juce_wchar>(key.getKeyCode())) ==
               static_cast<juce::juce_wchar>(letter);
}

} // namespace idiophone
