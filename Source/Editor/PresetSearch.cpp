#include "Editor/PresetSearch.h"

#include "Editor/Utf8.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <string>

namespace idiophone {
namespace {

/// Converts Latin, Greek and Cyrillic capitals to lower case. The C library converts them only in
/// some locales.
juce::juce_wchar smallLetter(juce::juce_wchar letter) {
    const auto isIn = [&](juce::juce_wchar first, juce::juce_wchar last) {
        return letter >= first && letter <= last;
    };
    if ((isIn(0xc0, 0xde) && letter != 0xd7) || isIn(0x391, 0x3a9) || isIn(0x410, 0x42f))
        return letter + 0x20;
    if (isIn(0x400, 0x40f))
        return letter + 0x50;
    if (isIn(0x100, 0x137) || isIn(0x14a, 0x177))
        return letter | 1;
    if (isIn(0x139, 0x148) || isIn(0x179, 0x17e))
        return letter + (letter & 1);
    return juce::CharacterFunctions::toLowerCase(letter);
}

juce::String small(const juce::String& text) {
    const auto bytes = text.toRawUTF8();
    if (!juce::CharPointer_UTF8::isValidString(bytes, static_cast<int>(std::strlen(bytes))))
        return text; // a folder's name that is not UTF-8, which JUCE would read past its end
    // Appending to a juce::String would search its end for each letter.
    std::basic_string<juce::juce_wchar> result;
    for (auto letter = text.getCharPointer(); !letter.isEmpty(); ++letter)
        result += smallLetter(*letter);
    return juce::CharPointer_UTF32(result.c_str());
}

juce::String small(const std::string& text) {
    return small(fromUtf8(text));
}

} // namespace

bool matchesSearch(const ShelvedPreset& preset, const juce::String& words) {
    juce::StringArray fields{small(preset.name), small(preset.author), small(preset.description),
                             small(preset.folder)};
    for (const auto& tag : preset.tags)
        fields.add(small(tag));
    const auto wanted = juce::StringArray::fromTokens(small(words), false);
    return std::all_of(wanted.begin(), wanted.end(), [&](const juce::String& word) {
        return std::any_of(fields.begin(), fields.end(),
                           [&](const juce::String& field) { return field.contains(word); });
    });
}

juce::StringArray tagsOf(const std::vector<ShelvedPreset>& presets) {
    std::map<juce::String, int> counts;
    for (const auto& preset : presets)
        for (const auto& tag : preset.tags)
            ++counts[small(tag).trim()];
    counts.erase(juce::String());
    std::vector<std::pair<juce::String, int>> sorted(counts.begin(), counts.end());
    std::ranges::stable_sort(sorted, std::ranges::greater(), &std::pair<juce::String, int>::second);
    juce::StringArray tags;
    for (const auto& [tag, count] : sorted)
        tags.add(tag);
    return tags;
}

juce::String tagLine(const std::vector<std::string>& tags) {
    juce::StringArray texts;
    for (const auto& tag : tags)
        texts.add(fromUtf8(tag));
    return texts.joinIntoString(", ");
}

} // namespace idiophone
