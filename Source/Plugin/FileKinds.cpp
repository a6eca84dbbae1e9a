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

std::string withoutFolder(const std::string& sentence, const std::filesystem::path& file) {
    if (file.empty())
        return sentence;
    return fromUtf8(sentence).replace(textOf(file), fromUtf8(fileNameOf(file))).toStdString();
}

} // namespace idiophone
