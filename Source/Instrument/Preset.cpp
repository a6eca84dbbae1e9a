#include "Instrument/Preset.h"

#include "Instrument/JsonPlace.h"
#include "Instrument/KeyMapFile.h"
#include "Instrument/ParameterJson.h"
#include "Instrument/SurfaceFile.h"
#include "Object/OneLine.h"

#include <nlohmann/json.hpp>

namespace idiophone {
namespace {

using nlohmann::ordered_json; // keeps the order of members for readers

/// Returns the tags whose total length fits.
std::vector<std::string> parseTags(const JsonPlace& place) {
    std::vector<std::string> tags;
    std::size_t bytes = 0;
    for (const auto& tag : place.list(maximumTags)) {
        auto text = tag.textCutTo(longestNameBytes);
        bytes += text.size();
        if (bytes <= longestTagsBytes)
            tags.push_back(std::move(text));
    }
    return tags;
}

/// Returns the values that differ from the preset's own.
ordered_json matchedToJson(const Preset& preset) {
    auto differing = ordered_json::object();
    for (const auto& info : parameterTable())
        if ((*preset.matchedTo)[info.parameter] != preset.parameters[info.parameter])
            differing[info.id] = (*preset.matchedTo)[info.parameter];
    return differing;
}

ModeSet parseMutedModes(const JsonPlace& place) {
    ModeSet muted;
    for (const auto& [name, modes] : place.members())
        for (const auto& mode : modes.list(ModeSet::capacity))
            if (!muted.set(name, mode.integer(0, ModeSet::maximumModes - 1), true))
                place.fail("are more than " + std::to_string(ModeSet::capacity));
    return muted;
}

Preset parse(const JsonPlace& root) {
    root.expectFormat("preset", presetFormatVersion);
    Preset preset;
    preset.name = root.at("name").textCutTo(longestNameBytes);
    read(root, "author", preset.author, &JsonPlace::textCutTo, longestNameBytes);
    read(root, "description", preset.description, &JsonPlace::textCutTo, longestDescriptionBytes);
    read(root, "tags", preset.tags, parseTags);
    preset.keyMap = keyMapAt(root.at("keyMap"));
    if (root.has("parameters"))
        preset.unknownParameters = readParameters(root.at("parameters"), preset.parameters);
    if (root.has("matchedTo")) {
        preset.matchedTo = preset.parameters;
        readParameters(root.at("matchedTo"), *preset.matchedTo);
    }
    read(root, "surface", preset.surface, surfaceAt);
    read(root, "mutedModes", preset.mutedModes, parseMutedModes);
    read(root, "seed", preset.seed, &JsonPlace::wholeNumber, 0, 4294967295);
    return preset;
}

} // namespace

Result<Preset> parsePreset(std::string_view text, std::string_view name) {
    if (text.size() > largestPresetBytes)
        return failure(std::string(name) + ": it is too large for a preset");
    return parseSavedPreset(text, name).and_then([&](Preset preset) -> Result<Preset> {
        if (preset.name.empty())
            return failure(std::string(name) + ": name is empty");
        return preset;
    });
}

Result<Preset> parseSavedPreset(std::string_view text, std::string_view name) {
    return parsedJson(text, name, parse);
}

std::string encodePreset(const Preset& preset) {
    ordered_json parameters = ordered_json::object();
    for (const auto& info : parameterTable())
        parameters[info.id] = preset.parameters[info.parameter];
    ordered_json root{{"format", "idiophone-preset"},
                      {"version", presetFormatVersion},
                      {"name", preset.name},
                      {"author", preset.author},
                      {"description", preset.description},
                      {"tags", preset.tags},
                      {"keyMap", ordered_json::parse(encodeKeyMap(preset.keyMap))},
                      {"parameters", parameters},
                      {"surface", ordered_json::parse(encodeSurface(preset.surface))},
                      {"seed", preset.seed}};
    if (preset.matchedTo)
        root["matchedTo"] = matchedToJson(preset);
    if (!preset.mutedModes.empty())
        root["mutedModes"] = preset.mutedModes.objects();
    // Names come from people and files: replace bytes that are not UTF-8 rather than throw.
    return root.dump(4, ' ', false, ordered_json::error_handler_t::replace);
}

} // namespace idiophone
