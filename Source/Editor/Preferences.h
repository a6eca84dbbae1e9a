// The window's look and size, saved for all instances of this user. Contains nothing about the
// sound.
#pragma once

#include "Editor/Look.h"
#include "Editor/SettingsFolder.h"

#include <juce_data_structures/juce_data_structures.h>

namespace idiophone {

/// For the message thread. Stored in `Window.settings` in the user's Idiophone folder. If the file
/// cannot be read or written, or there is no such folder, the defaults apply.
class Preferences {
public:
    LookScheme look() const {
        return file.getValue(lookKey) == "light" ? LookScheme::light : LookScheme::dark;
    }
    void setLook(LookScheme scheme) {
        readAnew();
        file.setValue(lookKey, scheme == LookScheme::light ? "light" : "dark");
    }

    /// Whether figures of physics have units, and not values from 0 to 100.
    bool showsUnits() const { return file.getBoolValue(unitsKey); }
    void setShowsUnits(bool shows) {
        readAnew();
        file.setValue(unitsKey, shows);
    }

    /// The last size of the window; (0, 0) the first time.
    juce::Point<int> windowSize() const {
        return {file.getIntValue(widthKey), file.getIntValue(heightKey)};
    }
    void setWindowSize(juce::Point<int> size) {
        readAnew();
        file.setValue(widthKey, size.x);
        file.setValue(heightKey, size.y);
    }

private:
    static constexpr const char *lookKey = "look", *widthKey = "width", *heightKey = "height",
                                *unitsKey = "units";

    static juce::File place() {
        const auto folder = userSettingsFolder();
        return folder == juce::File() ? folder : folder.getChildFile("Window.settings");
    }
    static juce::PropertiesFile::Options options() {
        juce::PropertiesFile::Options result;
        result.millisecondsBeforeSaving = 2000;
        result.storageFormat = juce::PropertiesFile::storeAsXML;
        return result;
    }

    /// Reads other windows' changes first, because saving writes the whole file.
    void readAnew() {
        if (!file.needsToBeSaved())
            file.reload();
    }

    juce::PropertiesFile file{place(), options()}; ///< its destructor saves it
};

} // namespace idiophone
