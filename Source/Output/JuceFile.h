// Converts a path of the standard library to JUCE. Windows stores paths in UTF-16, and its narrow
// texts are not UTF-8.
#pragma once

#include <filesystem>
#include <juce_core/juce_core.h>

namespace idiophone {

inline juce::File juceFile(const std::filesystem::path& file) {
    std::error_code ignored;
    return juce::String::fromUTF8(std::filesystem::absolute(file, ignored).u8string().c_str());
}

} // namespace idiophone
