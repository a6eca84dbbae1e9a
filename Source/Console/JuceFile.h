// Converts paths between the standard library and JUCE. Windows stores them in UTF-16, and its
// narrow texts are not UTF-8.
#pragma once

#include <filesystem>
#include <juce_core/juce_core.h>

namespace idiophone {

inline juce::File juceFile(const std::filesystem::path& file) {
    std::error_code ignored;
    return juce::String::fromUTF8(std::filesystem::absolute(file, ignored).u8string().c_str());
}

inline std::filesystem::path pathOf(const juce::File& file) {
    const auto text = file.getFullPathName();
    return std::filesystem::path(reinterpret_cast<const char8_t*>(text.toRawUTF8()));
}

} // namespace idiophone
