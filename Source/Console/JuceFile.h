// Converts paths between the standard library and JUCE. Windows stores them in UTF-16, and its
// narrow texts are not UTF-8.
#pragma once

#include <filesystem>
#include <juce_core/juce_core.h>

namespace idiophone {

inline juce::String juceText(const std::filesystem::path& path) {
    const auto text = path.u8string();
    return juce::String::fromUTF8(reinterpret_cast<const char*>(text.data()),
                                  static_cast<int>(text.size()));
}

inline juce::File juceFile(const std::filesystem::path& file) {
    std::error_code ignored;
    return juce::File(juceText(std::filesystem::absolute(file, ignored)));
}

inline std::filesystem::path pathOf(const juce::File& file) {
    const auto text = file.getFullPathName();
    return std::filesystem::path(reinterpret_cast<const char8_t*>(text.toRawUTF8()));
}

} // namespace idiophone
