// The window's look and size, saved for all instances of this user. Contains nothing about the
// sound.
#pragma once

#include "Editor/Look.h"
#include "Editor/SettingsFolder.h"

#include <juce_data_structures/juce_data_structures.h>
#include <memory>

namespace idiophone {

/// For the message thread. Stored in `Window.settings` in the user's Idiophone folder. If the file
/// cannot be read or written, the defaults apply.
class Preferences {
public:
    Preferences() {
        const auto folder = userSettingsFolder();
        if (folder == juce::File())
            return;
        juce::PropertiesFile::Options options;
        options.millisecondsBeforeSaving = 2000;
        options.storageFormat = juce::PropertiesFile::storeAsXML;
        file =
            std::make_unique<juce::PropertiesFile>(folder.getChildFile("Window.settings"), options);
    }

    LookScheme look() const {
        return file != nullptr && file->getValue(lookKey) == "light" ? LookScheme::light
                                                                     : LookScheme::dark;
    }
    void setLook(LookScheme scheme) {
        readAnew();
        if (file != nullptr)
            file->setValue(lookKey, scheme == LookScheme::light ? "light" : "dark");
    }

    /// The last size of the window; (0, 0) the first time.
    juce::Point<int> windowSize() const {
        return file == nullptr
                   ? juce::Point<int>()
                   : juce::Point(file->getIntValue(widthKey), file->getIntValue(heightKey));
    }
    void setWindowSize(juce::Point<int> size) {
        readAnew();
        if (file == nullptr)
            return;
        file->setValue(widthKey, size.x);
        file->setValue(heightKey, size.y);
    }

private:
    static constexpr const char *lookKey = "look", *widthKey = "width", *heightKey = "height";

    /// Reads other windows' changes first, because saving writes the whole file.
    void readAnew() {
        if (file != nullptr && !file->needsToBeSaved())
            file->reload();
    }

    std::unique_ptr<juce::PropertiesFile> file; ///< its destructor saves it
};

} // namespace idiophone
