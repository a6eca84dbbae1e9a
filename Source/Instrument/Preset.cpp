#include "Instrument/Preset.h"

#include "Instrument/JsonPlace.h"
#include "Instrument/ParameterJson.h"
#include "Instrument/SurfaceFile.h"
#include "Object/OneLine.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using nlohmann::ordered_json; // keeps the order of members for readers

constexpr std::array<std::pair<KeyMapKind, const char*>, 4> kindNames{{
    {KeyMapKind::bars, "bars"},
    {KeyMapKind::zones, "zones"},
    {KeyMapKind::scaled, "scaled"},
    {KeyMapKind::scene, "scene"},
}};

KeyMapKind parseKind(const JsonPlace& place) {
    const auto name = place.textOrEmpty();
    for (const auto& [kind, kindName] : kindNames)
        if (name == kindName)
            return kind;
    place.fail("is " + inQuotes(name) + " and none of bars, zones, scaled and scene");
}

const char* kindName(KeyMapKind wanted) {
    for (const auto& [kind, name] : kindNames)
        if (kind == wanted)
            return name;
    return "";
}

std::vector<std::array<double, 3>> parsePath(const JsonPlace& path) {
    std::vector<std::array<double, 3>> points;
    for (const auto& place : path.list(maximumPathPoints)) {
        const auto point = place.vector(1);
        points.push_back({point.x(), point.y(), point.z()});
    }
    if (points.empty())
        path.fail("has no points");
    return points;
}

std::vector<double> parseStrikeAt(const JsonPlace& place) {
    if (!place.json().is_array())
        return {place.number(0, 1)};
    std::vector<double> places;
    for (const auto& key : place.list(128))
        places.push_back(key.number(0, 1));
    if (places.empty())
        place.fail("is empty");
    return places;
}

KeyMap parseKeyMap(const JsonPlace& place) {
    KeyMap map;
    map.kind = parseKind(place.at("kind"));
    map.lowestNote = place.at("lowestNote").integer(0, 127);
    map.highestNote = place.at("highestNote").integer(map.lowestNote, 127);
    read(place, "resizedFrom", map.resizedFrom, &JsonPlace::integer, 0, 127);
    read(place, "resizedTo", map.resizedTo, &JsonPlace::integer, 0, 127);
    map.object = place.at("object").textOrEmpty();
    read(place, "strikePath", map.strikePath, parsePath);
    read(place, "strikeAt", map.strikeAt, parseStrikeAt);
    read(place, "strikeWidth", map.strikeWidth, &JsonPlace::number, 0, 1);
    read(place, "referenceNote", map.referenceNote, &JsonPlace::number, 0, 127);
    if (place.has("voicingDb"))
        for (const auto& key : place.at("voicingDb").list(128))
            map.voicingDb.push_back(key.number(-40, 40));
    return map;
}

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

ordered_json strikeAtToJson(const KeyMap& map) {
    return map.strikeAt.size() == 1 ? ordered_json(map.strikeAt.front())
                                    : ordered_json(map.strikeAt);
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
    preset.keyMap = parseKeyMap(root.at("keyMap"));
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

double KeyMap::strikePlace(int midiNote) const {
    const int range = std::max(1, highestNote - lowestNote);
    const double share = std::clamp(static_cast<double>(midiNote - lowestNote) / range, 0.0, 1.0);
    if (kind == KeyMapKind::zones && highestNote > lowestNote)
        return share;
    const double place = share * static_cast<double>(strikeAt.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, strikeAt.size() - 1);
    return std::lerp(strikeAt[below], strikeAt[above], place - static_cast<double>(below));
}

std::string KeyMap::objectFor(int midiNote) const {
    constexpr std::string_view mark = "{note}";
    std::string name = object;
    if (const auto place = name.find(mark); kind == KeyMapKind::bars && place != std::string::npos)
        name.replace(place, mark.size(), std::to_string(midiNote));
    return name;
}

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
    const auto& map = preset.keyMap;
    ordered_json keyMap{{"kind", kindName(map.kind)},     {"lowestNote", map.lowestNote},
                        {"highestNote", map.highestNote}, {"resizedFrom", map.resizedFrom},
                        {"resizedTo", map.resizedTo},     {"object", map.object},
                        {"strikePath", map.strikePath},   {"strikeAt", strikeAtToJson(map)},
                        {"strikeWidth", map.strikeWidth}};
    if (map.referenceNote >= 0)
        keyMap["referenceNote"] = map.referenceNote;
    if (!map.voicingDb.empty())
        keyMap["voicingDb"] = map.voicingDb;
    ordered_json parameters = ordered_json::object();
    for (const auto& info : parameterTable())
        parameters[info.id] = preset.parameters[info.parameter];
    ordered_json root{{"format", "idiophone-preset"},
                      {"version", presetFormatVersion},
                      {"name", preset.name},
                      {"author", preset.author},
                      {"description", preset.description},
                      {"tags", preset.tags},
                      {"keyMap", keyMap},
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
