#include "Editor/Preferences.h"

#include "Editor/SettingsFolder.h"

namespace idiophone {
namespace {

constexpr const char *lookKey = "look", *widthKey = "width", *heightKey = "height";

} // namespace

Preferences::Preferences() {
    const auto folder = userSettingsFolder();
    if (folder == juce::File())
        return;
    juce::PropertiesFile::Options options;
    options.millisecondsBeforeSaving = 2000;
    options.storageFormat = juce::PropertiesFile::storeAsXML;
    file = std::make_unique<juce::PropertiesFile>(folder.getChildFile("Window.settings"), options);
}

LookScheme Preferences::look() const {
    return file != nullptr && file->getValue(lookKey) == "light" ? LookScheme::light
                                                                 : LookScheme::dark;
}

void Preferences::setLook(LookScheme scheme) {
    readAnew();
    if (file != nullptr)
        file->setValue(lookKey, scheme == LookScheme::light ? "light" : "dark");
}

juce::Point<int> Preferences::windowSize() const {
    return file == nullptr ? juce::Point<int>()
                           : juce::Point(file->getIntValue(widthKey), file->getIntValue(heightKey));
}

void Preferences::setWindowSize(juce::Point<int> size) {
    readAnew();
    if (file == nullptr)
        return;
    file->setValue(widthKey, size.x);
    file->setValue(heightKey, size.y);
}

/// Reads other windows' changes first, because saving writes the whole file.
void Preferences::readAnew() {
    if (file != nullptr && !file->needsToBeSaved())
        file->reload();
}

} // namespace idiophone
