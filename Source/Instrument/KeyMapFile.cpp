#include "Instrument/KeyMapFile.h"

#include "Instrument/JsonPlace.h"
#include "Instrument/StereoSpan.h"
#include "Object/OneLine.h"
#include "Parameters/ParameterTable.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace idiophone {
namespace {

using nlohmann::ordered_json; // keeps the order of members for readers

constexpr std::array<std::pair<KeyMapKind, const char*>, 5> kindNames{{
    {KeyMapKind::bars, "bars"},
    {KeyMapKind::zones, "zones"},
    {KeyMapKind::scaled, "scaled"},
    {KeyMapKind::scene, "scene"},
    {KeyMapKind::kit, "kit"},
}};

KeyMapKind parseKind(const JsonPlace& place) {
    const auto name = place.textOrEmpty();
    for (const auto& [kind, word] : kindNames)
        if (name == word)
            return kind;
    place.fail("is " + inQuotes(name) + " and none of bars, zones, scaled, scene and kit");
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

/// Reads the name of a choice, such as "Rosewood".
int parseChoice(const JsonPlace& place, ParameterId parameter) {
    const auto& info = parameterInfo(parameter);
    const auto name = place.textOrEmpty();
    const auto choice = parseParameter(info, name);
    if (!choice)
        place.fail("is " + inQuotes(name) + ", which is no choice of " + inQuotes(info.name));
    return static_cast<int>(*choice);
}

KeyMap parseKit(const JsonPlace& parts);

KeyMap parseKeyMap(const JsonPlace& place) {
    KeyMap map;
    map.kind = parseKind(place.at("kind"));
    if (map.kind == KeyMapKind::kit)
        return parseKit(place.at("parts"));
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

KitPart parsePart(const JsonPlace& place) {
    KitPart part{.keyMap = parseKeyMap(place.at("keyMap"))};
    read(place, "lowestVelocity", part.lowestVelocity, &JsonPlace::integer, 1, 127);
    read(place, "highestVelocity", part.highestVelocity, &JsonPlace::integer, part.lowestVelocity,
         127);
    read(place, "material", part.material, parseChoice, ParameterId::material);
    if (part.material == customMaterial)
        place.at("material").fail("is 'Custom', but the custom figures belong to all parts");
    read(place, "mallet", part.mallet, parseChoice, ParameterId::mallet);
    read(place, "levelDb", part.levelDb, &JsonPlace::number, -40, 40);
    read(place, "chokeGroup", part.chokeGroup, &JsonPlace::integer, 0, maximumChokeGroup);
    read(place, "output", part.output, &JsonPlace::integer, 1, int{maximumOutputs});
    return part;
}

KeyMap parseKit(const JsonPlace& parts) {
    std::vector<KitPart> parsed;
    for (const auto& place : parts.list(maximumKitParts))
        parsed.push_back(parsePart(place));
    auto kit = kitOf(std::move(parsed));
    if (const auto valid = validKit(kit); !valid)
        parts.fail(valid.error().message);
    return kit;
}

ordered_json strikeAtToJson(const KeyMap& map) {
    return map.strikeAt.size() == 1 ? ordered_json(map.strikeAt.front())
                                    : ordered_json(map.strikeAt);
}

ordered_json toJson(const KeyMap& map);

ordered_json partToJson(const KitPart& part) {
    ordered_json json{{"keyMap", toJson(part.keyMap)},
                      {"lowestVelocity", part.lowestVelocity},
                      {"highestVelocity", part.highestVelocity},
                      {"levelDb", part.levelDb},
                      {"chokeGroup", part.chokeGroup}};
    const auto name = [](ParameterId parameter, int choice) {
        return formatParameter(parameterInfo(parameter), choice);
    };
    if (part.material)
        json["material"] = name(ParameterId::material, *part.material);
    if (part.mallet)
        json["mallet"] = name(ParameterId::mallet, *part.mallet);
    if (part.output > 0)
        json["output"] = part.output;
    return json;
}

ordered_json toJson(const KeyMap& map) {
    ordered_json json{{"kind", kindName(map.kind)},
                      {"lowestNote", map.lowestNote},
                      {"highestNote", map.highestNote}};
    if (map.kind == KeyMapKind::kit) {
        json["parts"] = ordered_json::array();
        for (const auto& part : map.parts)
            json["parts"].push_back(partToJson(part));
        return json;
    }
    json.update({{"resizedFrom", map.resizedFrom},
                 {"resizedTo", map.resizedTo},
                 {"object", map.object},
                 {"strikePath", map.strikePath},
                 {"strikeAt", strikeAtToJson(map)},
                 {"strikeWidth", map.strikeWidth}});
    if (map.referenceNote >= 0)
        json["referenceNote"] = map.referenceNote;
    if (!map.voicingDb.empty())
        json["voicingDb"] = map.voicingDb;
    return json;
}

} // namespace

const char* kindName(KeyMapKind wanted) {
    for (const auto& [kind, word] : kindNames)
        if (kind == wanted)
            return word;
    return "";
}

KeyMap keyMapAt(const JsonPlace& place) {
    return parseKeyMap(place);
}

std::string encodeKeyMap(const KeyMap& map) {
    // Names come from people and files: replace bytes that are not UTF-8 rather than throw.
    return toJson(map).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

} // namespace idiophone
