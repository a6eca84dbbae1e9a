#include "Editor/PresetSearch.h"

#include "Editor/TypingErrors.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <array>
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
    Letters result;  // appending to a juce::String would search its end for each letter
    for (auto letter = text.getCharPointer(); !letter.isEmpty(); ++letter)
        result += smallLetter(*letter);
    return juce::CharPointer_UTF32(result.c_str());
}

juce::String small(const std::string& text) {
    return small(fromUtf8(text));
}

/// The tags of the factory presets (docs/presets.md), in the order of a list.
constexpr std::array soundWords{"dark",    "warm", "clear", "bright", "short",
                                "ringing", "long", "soft",  "hard"};

/// "ph" becomes "f", the same sound.
Letters lettersOf(const juce::String& word) {
    const auto sounding = word.replace("ph", "f");
    Letters letters;
    for (auto letter = sounding.getCharPointer(); !letter.isEmpty(); ++letter)
        letters += *letter;
    return letters;
}

std::vector<Letters> wordsOf(const juce::StringArray& fields) {
    std::vector<Letters> words;
    for (const auto& field : fields)
        for (const auto& word : juce::StringArray::fromTokens(field, " -/,.()", {}))
            words.push_back(lettersOf(word));
    return words;
}

/// Returns the errors in the typed word that one of the words has least, at least 1, or nothing if
/// they are too many. A short word must have the right first letter.
std::optional<int> errorsIn(const juce::String& typed, const std::vector<Letters>& words) {
    constexpr int shortest = 6, longest = 64; // letters: work grows with their square
    const int permitted = permittedErrors(typed.length());
    if (permitted == 0 || typed.length() > longest)
        return std::nullopt;
    const auto letters = lettersOf(typed);
    int fewest = permitted + 1;
    for (const auto& word : words)
        if (typed.length() >= shortest || word.starts_with(letters.front()))
            fewest = std::min(fewest, typingErrors(letters, word.substr(0, longest)));
    return fewest > permitted ? std::nullopt : std::optional(std::max(fewest, 1));
}

} // namespace

std::optional<int> searchErrors(const ShelvedPreset& preset, const juce::String& words) {
    juce::StringArray fields{small(preset.name), small(preset.folder)};
    for (const auto& tag : preset.tags)
        fields.add(small(tag));
    const auto forgiving = wordsOf(fields);
    fields.addArray({small(preset.author), small(preset.description)});
    int errors = 0;
    for (const auto& word : juce::StringArray::fromTokens(small(words), false)) {
        if (std::any_of(fields.begin(), fields.end(),
                        [&](const juce::String& field) { return field.contains(word); }))
            continue;
        const auto more = errorsIn(word, forgiving);
        if (!more)
            return std::nullopt;
        errors += *more;
    }
    return errors;
}

juce::StringArray tagsOf(const std::vector<ShelvedPreset>& presets) {
    std::map<juce::String, int> counts;
    for (const auto& preset : presets)
        for (const auto& tag : preset.tags)
            ++counts[small(tag).trim()];
    counts.erase(juce::String());
    std::vector<std::pair<juce::String, int>> sorted(counts.begin(), counts.end());
    std::ranges::stable_sort(sorted, {}, [](const auto& tag) {
        const auto sound =
            std::ranges::find_if(soundWords, [&](const char* word) { return tag.first == word; });
        return std::pair(sound - soundWords.begin(), -tag.second);
    });
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
