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

    /// The window's scale in per cent, 75 to 200.
    int scalePercent() const { return juce::jlimit(75, 200, file.getIntValue(scaleKey, 100)); }
    void setScalePercent(int percent) {
        readAnew();
        file.setValue(scaleKey, percent);
    }

    /// Whether the hints of the first start have been shown.
    bool areHintsSeen() const { return file.getBoolValue(hintsKey); }
    void setHintsSeen() {
        readAnew();
        file.setValue(hintsKey, true);
    }

    /// The last size of the window before scaling; (0, 0) the first time.
    juce::Point<int> windowSize() const {
        return {file.getIntValue(widthKey), file.getIntValue(heightKey)};
    }
    void setWindowSize(juce::Point<int> size) {
        readAnew();
        file.setValue(widthKey, size.x);
        file.setValue(heightKey, size.y);
    }

    /// Whether selecting a preset plays a phrase.
    bool playsOnSelection() const { return file.getBoolValue(phraseKey, true); }
    void setPlaysOnSelection(bool plays) {
        readAnew();
        file.setValue(phraseKey, plays);
    }

private:
    static constexpr const char *lookKey = "look", *widthKey = "width", *heightKey = "height",
                                *scaleKey = "scale", *hintsKey = "hintsSeen",
                                *phraseKey = "playOnSelection", *unitsKey = "units";

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
