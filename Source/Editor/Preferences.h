// The window's look and size, saved for all instances of this user. Contains nothing about the
// sound.
#pragma once

#include "Editor/Look.h"

#include <juce_data_structures/juce_data_structures.h>
#include <memory>

namespace idiophone {

/// For the message thread. Stored in `Window.settings` in the user's Idiophone folder. If the file
/// cannot be read or written, the defaults apply.
class Preferences {
public:
    Preferences();

    LookScheme look() const;
    void setLook(LookScheme scheme);

    /// The last size of the window; (0, 0) the first time.
    juce::Point<int> windowSize() const;
    void setWindowSize(juce::Point<int> size);

private:
    void readAnew();

    std::unique_ptr<juce::PropertiesFile> file; ///< its destructor saves it
};

} // namespace idiophone
