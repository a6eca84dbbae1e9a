#include "Editor/Preferences.h"

#include "Object/MaterialFile.h"

namespace idiophone {
namespace {

constexpr const char *lookKey = "look", *widthKey = "width", *heightKey = "height";

} // namespace

Preferences::Preferences() {
    const auto folder = userMaterialFolder().parent_path();
    if (folder.empty())
        return;
    juce::PropertiesFile::Options options;
    options.millisecondsBeforeSaving = 2000;
    options.storageFormat = juce::PropertiesFile::storeAsXML;
    file = std::make_unique<juce::PropertiesFile>(
        juce::File(juce::String::fromUTF8((folder / "Window.settings").string().c_str())), options);
}

LookScheme Preferences::look() const {
    return file != nullptr && file->getValue(lookKey) == "light" ? LookScheme::light
                                                                 : LookScheme::dark;
}

void Preferences::setLook(LookScheme scheme) {
    if (file != nullptr)
        file->setValue(lookKey, scheme == LookScheme::light ? "light" : "dark");
}

juce::Point<int> Preferences::windowSize() const {
    return file == nullptr ? juce::Point<int>()
                           : juce::Point(file->getIntValue(widthKey), file->getIntValue(heightKey));
}

void Preferences::setWindowSize(juce::Point<int> size) {
    if (file == nullptr)
        return;
    file->setValue(widthKey, size.x);
    file->setValue(heightKey, size.y);
}

} // namespace idiophone
