// What the window remembers from one time to the next, for all instances of this user: its look and
// its size. Nothing that concerns the sound.
#pragma once

#include "Editor/Look.h"

#include <juce_data_structures/juce_data_structures.h>
#include <memory>

namespace idiophone {

/// For the message thread. Kept in `Window.settings` in the user's folder of Idiophone; where there
/// is none, or it cannot be written, the window begins as at first.
class Preferences {
public:
    Preferences();

    LookScheme look() const;
    void setLook(LookScheme scheme);

    /// Of the window as it was last; nothing at the first time.
    juce::Point<int> windowSize() const;
    void setWindowSize(juce::Point<int> size);

private:
    void readAnew();

    std::unique_ptr<juce::PropertiesFile> file; ///< writes itself when it goes
};

} // namespace idiophone
