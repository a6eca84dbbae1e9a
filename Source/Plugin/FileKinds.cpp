#include "Plugin/FileKinds.h"

#include "Editor/Utf8.h"

namespace idiophone {

bool matches(const std::filesystem::path& file, const char* patterns) {
    return juce::StringArray::fromTokens(patterns, ";", "")
        .contains("*" + textOf(file.extension()), true);
}

std::string fileNameOf(const std::filesystem::path& file) {
    return textOf(file.filename()).toStdString();
}

} // namespace idiophone
