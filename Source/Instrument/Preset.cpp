#include "Instrument/Preset.h"

#include "Instrument/ParameterJson.h"
#include "Instrument/SurfaceFile.h"
#include "Object/OneLine.h"
#include "Object/UntrustedJson.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace idiophone {
namespace {

// Sorted for reading, whose look-ups stay fast however many keys a hostile file has; in order for
// writing, for the people who read it.
using nlohmann::json;
using nlohmann::ordered_json;

// Inside this file a fault travels as an exception and becomes a Result at parsePreset.
struct Fault {
    std::string sentence;
};

const json& member(const json& object, const char* key) {
    if (!object.is_object() || !object.contains(key))
        throw Fault{"it lacks '" + std::string(key) + "'"};
    return object[key];
}

std::string text(const json& object, const char* key) {
    const auto& value = member(object, key);
    if (!value.is_string())
        throw Fault{"'" + std::string(key) + "' is not a text"};
    return value;
}

double number(const json& object, const char* key, double lowest, double highest) {
    const auto& value = member(object, key);
    if (!value.is_number())
        throw Fault{"'" + std::string(key) + "' is not a number"};
    const auto result = value.get<double>();
    if (!(result >= lowest && result <= highest))
        throw Fault{"'" + std::string(key) + "' is out of range"};
    return result;
}

int integer(const json& object, const char* key, int lowest, int highest) {
    const double result = number(object, key, lowest, highest);
    if (result != std::floor(result))
        throw Fault{"'" + std::string(key) + "' is not a whole number"};
    return static_cast<int>(result);
}

constexpr std::array<std::pair<KeyMapKind, const char*>, 4> kindNames{{
    {KeyMapKind::bars, "bars"},
    {KeyMapKind::zones, "zones"},
    {KeyMapKind::scaled, "scaled"},
    {KeyMapKind::scene, "scene"},
}};

KeyMapKind parseKind(const std::string& name) {
    for (const auto& [kind, kindName] : kindNames)
        if (name == kindName)
            return kind;
    throw Fault{"its key map " + inQuotes(name) + " is none of bars, zones, scaled and scene"};
}

const char* kindName(KeyMapKind wanted) {
    for (const auto& [kind, name] : kindNames)
        if (kind == wanted)
            return name;
    return "";
}

std::vector<std::array<double, 3>> parsePath(const json& path) {
    if (!path.is_array() || path.empty() || path.size() > mostPathPoints)
        throw Fault{"'strikePath' is not a list of 1 to " + std::to_string(mostPathPoints) +
                    " points"};
    std::vector<std::array<double, 3>> points;
    for (const auto& point : path) {
        if (!point.is_array() || point.size() != 3)
            throw Fault{"'strikePath' holds something that is not a point [x, y, z]"};
        std::array<double, 3> coordinates{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!point[axis].is_number() || !(std::abs(point[axis].get<double>()) <= 1))
                throw Fault{"'strikePath' holds a coordinate that is not between -1 and 1"};
            coordinates[axis] = point[axis];
        }
        points.push_back(coordinates);
    }
    return points;
}

KeyMap parseKeyMap(const json& object) {
    KeyMap map;
    map.kind = parseKind(text(object, "kind"));
    map.lowestNote = integer(object, "lowestNote", 0, 127);
    map.highestNote = integer(object, "highestNote", map.lowestNote, 127);
    map.object = text(object, "object");
    if (object.contains("strikePath"))
        map.strikePath = parsePath(object["strikePath"]);
    if (object.contains("strikeAt"))
        map.strikeAt = number(object, "strikeAt", 0, 1);
    if (object.contains("strikeWidth"))
        map.strikeWidth = number(object, "strikeWidth", 0, 1);
    if (object.contains("referenceNote"))
        map.referenceNote = number(object, "referenceNote", 0, 127);
    return map;
}

void parseParameters(const json& object, Preset& preset) {
    if (!object.is_object())
        throw Fault{"'parameters' are not a JSON object"};
    for (const auto& [id, value] : object.items()) {
        const auto* info = findParameter(id);
        if (info == nullptr) {
            preset.unknownParameters.push_back(id);
            continue;
        }
        const auto parsed = parameterOfJson(*info, value);
        if (!parsed)
            throw Fault{"parameter '" + id + "' has a value it cannot take"};
        preset.parameters.set(info->parameter, *parsed);
    }
}

Surface parseSurfaceOf(const json& root) {
    auto surface = parseSurface(root["surface"].dump(), "its surface");
    if (!surface)
        throw Fault{surface.error().message};
    return std::move(*surface);
}

std::uint32_t parseSeed(const json& root) {
    if (!root["seed"].is_number_integer())
        throw Fault{"'seed' is not a whole number"};
    return static_cast<std::uint32_t>(number(root, "seed", 0, 4294967295));
}

ModeSet parseMutedModes(const json& object) {
    if (!object.is_object())
        throw Fault{"'mutedModes' are not a JSON object"};
    ModeSet muted;
    for (const auto& [name, modes] : object.items()) {
        if (!modes.is_array())
            throw Fault{"'mutedModes' has something for " + inQuotes(name) + " that is not a list"};
        for (const auto& mode : modes) {
            const bool isNumber = mode.is_number_unsigned() &&
                                  mode.get<std::uint64_t>() < std::uint64_t{ModeSet::mostModes};
            if (!isNumber)
                throw Fault{"'mutedModes' holds something for " + inQuotes(name) +
                            " that is not the number of a mode"};
            if (!muted.set(name, mode.get<std::int32_t>(), true))
                throw Fault{"'mutedModes' holds more than " + std::to_string(ModeSet::capacity) +
                            " modes"};
        }
    }
    return muted;
}

Preset parse(const json& root) {
    if (!root.is_object() || !root.contains("format") || root["format"] != "idiophone-preset")
        throw Fault{"it is not an Idiophone preset"};
    const int version = integer(root, "version", 1, 1'000'000'000);
    if (version > presetFormatVersion)
        throw Fault{"it was made by a newer Idiophone (preset version " + std::to_string(version) +
                    ")"};
    Preset preset;
    preset.name = text(root, "name");
    if (preset.name.empty())
        throw Fault{"its name is empty"};
    preset.author = root.contains("author") ? text(root, "author") : "";
    preset.description = root.contains("description") ? text(root, "description") : "";
    if (root.contains("tags")) {
        if (!root["tags"].is_array())
            throw Fault{"'tags' are not a list"};
        for (const auto& tag : root["tags"]) {
            if (!tag.is_string())
                throw Fault{"'tags' are not all texts"};
            preset.tags.push_back(tag);
        }
    }
    preset.keyMap = parseKeyMap(member(root, "keyMap"));
    if (root.contains("parameters"))
        parseParameters(root["parameters"], preset);
    if (root.contains("surface"))
        preset.surface = parseSurfaceOf(root);
    if (root.contains("mutedModes"))
        preset.mutedModes = parseMutedModes(root["mutedModes"]);
    if (root.contains("seed"))
        preset.seed = parseSeed(root);
    return preset;
}

} // namespace

std::string KeyMap::objectFor(int midiNote) const {
    constexpr std::string_view mark = "{note}";
    std::string name = object;
    if (const auto place = name.find(mark); kind == KeyMapKind::bars && place != std::string::npos)
        name.replace(place, mark.size(), std::to_string(midiNote));
    return name;
}

Result<Preset> parsePreset(std::string_view text, std::string_view name) {
    const auto refuse = [&](const std::string& sentence) {
        return failure(std::string(name) + ": " + sentence);
    };
    if (text.size() > largestPresetBytes)
        return refuse("it is too large for a preset");
    try {
        const auto root = parseUntrusted(text);
        if (root.is_discarded())
            return refuse("it is not JSON");
        return parse(root);
    } catch (const Fault& fault) {
        return refuse(fault.sentence);
    } catch (const nlohmann::json::exception&) {
        return refuse("it is damaged");
    }
}

std::string encodePreset(const Preset& preset) {
    const auto& map = preset.keyMap;
    ordered_json keyMap{{"kind", kindName(map.kind)},     {"lowestNote", map.lowestNote},
                        {"highestNote", map.highestNote}, {"object", map.object},
                        {"strikePath", map.strikePath},   {"strikeAt", map.strikeAt},
                        {"strikeWidth", map.strikeWidth}};
    if (map.referenceNote >= 0)
        keyMap["referenceNote"] = map.referenceNote;
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
    if (!preset.mutedModes.empty())
        root["mutedModes"] = preset.mutedModes.objects();
    // Names come from people and files: replace what is not UTF-8 rather than throw.
    return root.dump(4, ' ', false, ordered_json::error_handler_t::replace);
}

} // namespace idiophone
