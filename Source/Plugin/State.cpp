#include "Plugin/State.h"

#include "Object/OneLine.h"
#include "Object/UntrustedJson.h"

#include <juce_core/juce_core.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace idiophone {
namespace {

using nlohmann::json; // for reading: ordered_json takes quadratic time for hostile key lists
using nlohmann::ordered_json; // for writing: keeps a readable order

constexpr const char* formatName = "idiophone-state";

// A fault is an exception inside this file and becomes a Result in parseState.
struct Fault {
    std::string sentence;
};

const json& member(const json& object, const char* key) {
    if (!object.is_object() || !object.contains(key))
        throw Fault{"lacks '" + std::string(key) + "'"};
    return object[key];
}

std::string text(const json& object, const char* key) {
    const auto& value = member(object, key);
    if (!value.is_string())
        throw Fault{"has '" + std::string(key) + "' that is not a text"};
    return value;
}

std::vector<std::byte>
unpacked(const std::string& packedText, const std::string& name, std::int64_t largestBytes) {
    juce::MemoryOutputStream compressed;
    if (!juce::Base64::convertFromBase64(compressed, juce::String(packedText)))
        throw Fault{"holds a damaged object " + inQuotes(name)};
    juce::MemoryInputStream source(compressed.getData(), compressed.getDataSize(), false);
    juce::GZIPDecompressorInputStream zip(source);
    juce::MemoryOutputStream plain;
    // A few bytes can unpack to any length, so limit the output.
    plain.writeFromInputStream(zip, largestBytes);
    if (plain.getDataSize() == 0 || !zip.isExhausted())
        throw Fault{"holds a damaged object " + inQuotes(name)};
    const auto* first = static_cast<const std::byte*>(plain.getData());
    return {first, first + plain.getDataSize()};
}

ParameterValues parseParameters(const json& object) {
    if (!object.is_object())
        throw Fault{"has 'parameters' that are not a JSON object"};
    ParameterValues parameters;
    for (const auto& [id, value] : object.items()) {
        if (!value.is_number())
            throw Fault{"has a parameter " + inQuotes(id) + " that is not a number"};
        if (const auto* info = findParameter(id))
            parameters.set(info->parameter, value);
    }
    return parameters;
}

ordered_json encodeParameters(const ParameterValues& parameters) {
    ordered_json object = ordered_json::object();
    for (const auto& info : parameterTable())
        object[info.id] = parameters[info.parameter];
    return object;
}

SavedOrigin parseOrigin(const json& object) {
    const auto& content = member(object, "content");
    if (!content.is_number_unsigned())
        throw Fault{"has an 'origin' with a 'content' that is not a whole number"};
    return {.presetId = text(object, "preset"),
            .presetContent = content,
            .stored = parseParameters(member(object, "parameters"))};
}

std::vector<EmbeddedObject> parseObjects(const json& list) {
    if (!list.is_array())
        throw Fault{"has 'objects' that are not a list"};
    std::vector<EmbeddedObject> objects;
    auto bytesLeft = largestEmbeddedBytes;
    for (const auto& entry : list) {
        auto name = text(entry, "name");
        auto packed = text(entry, "modal");
        auto modal = unpacked(packed, name, bytesLeft);
        bytesLeft -= static_cast<std::int64_t>(modal.size());
        objects.push_back({.name = std::move(name),
                           .modal = std::move(modal),
                           .packed = std::make_shared<const std::string>(std::move(packed))});
    }
    return objects;
}

// Refuses controller numbers that cannot be learned.
ControllerAssignments parseControllers(const json& object) {
    if (!object.is_object())
        throw Fault{"has 'controllers' that are not a JSON object"};
    ControllerAssignments assignments;
    for (const auto& info : parameterTable()) {
        const auto found = object.find(info.id);
        if (found == object.end())
            continue;
        if (!found->is_number_integer() || *found < 0 || *found > 127 ||
            !isLearnable(found->get<int>()))
            throw Fault{"has a controller for '" + std::string(info.id) +
                        "' that cannot be learned"};
        assignments[info.parameter] = found->get<std::int8_t>();
    }
    return assignments;
}

ScalaFile parseScalaFile(const json& tuning, const char* key) {
    if (!tuning.contains(key))
        return {};
    // A byte that is not UTF-8 becomes three bytes when saved.
    constexpr auto largestBytes = 3 * ScalaTuning::largestFileBytes;
    auto file = ScalaFile{.name = text(tuning[key], "name"), .text = text(tuning[key], "text")};
    if (file.text.size() > largestBytes)
        throw Fault{"has a " + std::string(key) + " that is too long"};
    return file;
}

ScalaTuning parseTuning(const json& object) {
    if (!object.is_object())
        throw Fault{"has a 'tuning' that is not a JSON object"};
    return {.scale = parseScalaFile(object, "scale"), .mapping = parseScalaFile(object, "mapping")};
}

ordered_json encodeTuning(const ScalaTuning& tuning) {
    ordered_json object = ordered_json::object();
    if (tuning.scale.isGiven())
        object["scale"] = {{"name", tuning.scale.name}, {"text", tuning.scale.text}};
    if (tuning.mapping.isGiven())
        object["mapping"] = {{"name", tuning.mapping.name}, {"text", tuning.mapping.text}};
    return object;
}

State parse(const json& root) {
    if (!root.is_object() || !root.contains("format") || root["format"] != formatName)
        throw Fault{"is not one of Idiophone's"};
    const auto& version = member(root, "version");
    if (!version.is_number_integer() || version.get<double>() < 1)
        throw Fault{"has a 'version' that is not a whole number from 1 on"};
    if (version.get<double>() > stateFormatVersion)
        throw Fault{"was made by a newer Idiophone (state version " + version.dump() + ")"};
    State state;
    state.parameters = parseParameters(member(root, "parameters"));
    auto preset = parseSavedPreset(member(root, "preset").dump(), "its preset");
    if (!preset)
        throw Fault{"has a fault in " + preset.error().message};
    state.preset = std::move(*preset);
    state.preset.unknownParameters.clear();
    if (root.contains("origin"))
        state.origin = parseOrigin(root["origin"]);
    state.objects = parseObjects(member(root, "objects"));
    if (root.contains("controllers"))
        state.controllers = parseControllers(root["controllers"]);
    if (root.contains("tuning"))
        state.tuning = parseTuning(root["tuning"]);
    return state;
}

} // namespace

std::string packedModal(std::span<const std::byte> modal) {
    juce::MemoryOutputStream compressed;
    {
        juce::GZIPCompressorOutputStream zip(compressed);
        zip.write(modal.data(), modal.size());
    }
    return juce::Base64::toBase64(compressed.getData(), compressed.getDataSize()).toStdString();
}

std::string encodeState(const State& state) {
    ordered_json controllers = ordered_json::object();
    for (const auto& info : parameterTable())
        if (const int number = state.controllers[info.parameter]; number != noController)
            controllers[info.id] = number;
    ordered_json objects = ordered_json::array();
    for (const auto& object : state.objects)
        objects.push_back(
            {{"name", object.name},
             {"modal", object.packed != nullptr ? *object.packed : packedModal(object.modal)}});
    ordered_json root{{"format", formatName},
                      {"version", stateFormatVersion},
                      {"parameters", encodeParameters(state.parameters)},
                      {"preset", ordered_json::parse(encodePreset(state.preset))},
                      {"objects", objects}};
    if (!state.origin.presetId.empty())
        root["origin"] = {{"preset", state.origin.presetId},
                          {"content", state.origin.presetContent},
                          {"parameters", encodeParameters(state.origin.stored)}};
    if (!controllers.empty())
        root["controllers"] = controllers;
    if (state.tuning.isGiven())
        root["tuning"] = encodeTuning(state.tuning);
    // Names come from users and files: replace bytes that are not UTF-8 instead of throwing.
    return root.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

Result<State> parseState(std::string_view bytes) {
    try {
        const auto root = parseUntrusted(bytes);
        if (root.is_discarded())
            throw Fault{"is damaged, or not one of Idiophone's"};
        return parse(root);
    } catch (const Fault& fault) {
        return failure("The saved state " + fault.sentence + ".");
    } catch (const json::exception&) {
        return failure("The saved state is damaged.");
    }
}

} // namespace idiophone
