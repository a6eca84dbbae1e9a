// Converts texts and paths between the standard library and JUCE, always as UTF-8. On Windows a
// path's narrow text is not UTF-8.
#pragma once

#include <filesystem>
#include <juce_core/juce_core.h>
#include <string>
#include <string_view>

namespace idiophone {

inline juce::String fromUtf8(std::string_view text) {
    return juce::String::fromUTF8(text.data(), static_cast<int>(text.size()));
}

inline juce::String textOf(const std::filesystem::path& path) {
    return juce::String::fromUTF8(path.u8string().c_str());
}

inline std::filesystem::path pathOf(const juce::String& fullName) {
    const auto text = fullName.toStdString();
    return std::u8string(text.begin(), text.end());
}

inline std::filesystem::path pathOf(const juce::File& file) {
    return pathOf(file.getFullPathName());
}

/// The path is absolute.
inline juce::File fileOf(const std::filesystem::path& path) {
    return juce::File(textOf(path));
}

} // namespace idiophone
