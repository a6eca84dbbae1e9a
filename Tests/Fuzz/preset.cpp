// Fuzzes preset files.
#include "Instrument/Preset.h"
#include "Fuzz/FuzzTarget.h"

namespace idiophone::fuzz {
namespace {

void claimKeys(const KeyMap& map) {
    claim(0 <= map.lowestNote && map.lowestNote <= map.highestNote && map.highestNote <= 127,
          "keys are MIDI notes");
    claim(!map.strikeAt.empty() &&
              std::ranges::all_of(map.strikeAt, [](double x) { return x >= 0 && x <= 1; }) &&
              map.strikeWidth >= 0 && map.strikeWidth <= 1,
          "strikes are on the path");
    claim(0 <= map.resizedFrom && map.resizedFrom <= 127 && 0 <= map.resizedTo &&
              map.resizedTo <= 127,
          "its other keys are MIDI notes");
    claim(map.referenceNote <= 127 && !std::isnan(map.referenceNote),
          "the reference is a MIDI note");
    claim(!map.strikePath.empty(), "there is a path");
    for (const auto& point : map.strikePath)
        claim(std::ranges::all_of(point, [](double x) { return std::abs(x) <= 1; }),
              "the path is within the bounding box");
}

void claimParameters(const ParameterValues& values) {
    for (const auto& info : parameterTable())
        claim(values[info.parameter] == info.clamped(values[info.parameter]),
              "parameters have values that they can take");
}

} // namespace

void examine(std::string_view bytes) {
    auto preset = parsePreset(bytes, "fuzz.json");
    if (!preset)
        return claimSentence(preset.error());
    claim(!preset->name.empty(), "a preset has a name");
    claimKeys(preset->keyMap);
    claimParameters(preset->parameters);
    claimParameters(preset->matched());
    claim(validated(preset->surface).has_value(), "its surface is valid");
    claim(preset->mutedModes.size() <= ModeSet::capacity, "muted modes are few");
    preset->unknownParameters.clear(); // they are not written
    const auto again = parsePreset(encodePreset(*preset), "again.json");
    claim(again && *again == *preset, "a preset that was written reads back equal");
}

} // namespace idiophone::fuzz
