#include "Browser/InstrumentText.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/KeyMapFile.h"
#include "Instrument/OwnSlots.h"
#include "Instrument/StruckPlaces.h"
#include "Scene/NamedContent.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

std::string textOf(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

/// Returns each note that plays, with the index of its first object.
ordered_json notesOf(const Instrument& instrument) {
    const auto objects = objectsOfSlots(instrument);
    auto notes = ordered_json::array();
    for (int note = 0; note < 128; ++note)
        if (const int slot = instrument.key(note).slot; slot >= 0)
            notes.push_back({{"note", note},
                             {"object", objects[static_cast<std::size_t>(slot)]},
                             {"isOwn", instrument.hasOwn(note)}});
    return notes;
}

/// Returns the keys of materials.json that a picture and a map of materials need.
ordered_json materialOf(const Material& material) {
    return {{"name", material.name},
            {"youngs_modulus_pa", material.youngsModulusPa},
            {"density_kg_per_m3", material.densityKgPerM3},
            {"fluid_damping_per_s", material.damping.fluidPerSecond},
            {"viscoelastic_damping_s", material.damping.viscoelasticSeconds},
            {"loss_factor", material.damping.lossFactor},
            {"hasGrain", material.grain.has_value()}};
}

/// Returns the frequency of the mode that a bar shares with its tube; 0 if it has none.
double tubeHz(const ModalObject& object) {
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        if (object.isShared(mode))
            return object.dampedFrequencyHz(mode);
    return 0;
}

ordered_json objectsOf(const Instrument& instrument, std::span<const std::size_t> slots) {
    auto objects = ordered_json::array();
    for (const auto slot : slots) {
        const auto& object = *instrument.slots()[slot].object;
        objects.push_back(
            {{"name", instrument.objectName(slot)},
             {"title", object.name},
             {"sizeRatio", instrument.slots()[slot].sizeRatio},
             {"modes", object.modeCount()},
             {"vertexCount", object.vertexCount()},
             {"faceCount", object.faceCount()},
             {"material", materialOf(object.material)},
             {"thicknessMetres", object.body == BodyKind::shell ? object.thicknessMetres : 0.0},
             {"clampedVertices", object.clampedVertices},
             {"tubeHz", tubeHz(object)},
             {"struckPlaces", struckPlaces(instrument, slot)}});
    }
    return objects;
}

/// Returns the objects of a scene's bodies and of its keyboard.
Result<std::vector<std::string>> objectNamesOf(const Scene& scene) {
    std::vector<std::string> names;
    for (const auto& kind : scene.kinds)
        if (kind.given == nullptr && std::ranges::find(names, kind.object) == names.end())
            names.push_back(kind.object);
    if (!scene.keyboard)
        return names;
    return presetNamed(scene.keyboard->preset).transform([&](const Preset& preset) {
        for (auto& name : objectNames(preset.keyMap))
            names.push_back(std::move(name));
        return names;
    });
}

} // namespace

std::string presetsText() {
    auto list = ordered_json::array();
    for (const auto& preset : factoryPresets())
        list.push_back({{"name", preset.name},
                        {"description", preset.description},
                        {"tags", preset.tags},
                        {"kind", kindName(preset.keyMap.kind)}});
    return textOf(list);
}

std::string parametersText() {
    auto list = ordered_json::array();
    for (const auto& info : parameterTable()) {
        ordered_json row{{"id", info.id},
                         {"name", info.name},
                         {"shortName", info.shortName != nullptr ? info.shortName : info.name},
                         {"group", info.group},
                         {"unit", info.unit},
                         {"scale", scaleName(info.scale)},
                         {"minimum", info.minimum},
                         {"maximum", info.maximum},
                         {"default", info.defaultValue},
                         {"decimals", info.decimals},
                         {"isSetup", info.isSetup},
                         {"description", info.description}};
        if (const auto choices = choiceNames(info.parameter); !choices.empty())
            row["choices"] = choices;
        list.push_back(std::move(row));
    }
    return textOf(list);
}

std::string instrumentText(const BrowserInstrument& played) {
    if (played.instrument() == nullptr)
        return "null";
    const auto& preset = *played.preset();
    auto values = ordered_json::array();
    for (const auto& info : parameterTable())
        values.push_back(played.values()[info.parameter]);
    return textOf({{"name", preset.name},
                   {"description", preset.description},
                   {"kind", kindName(preset.keyMap.kind)},
                   {"lowestNote", preset.keyMap.lowestNote},
                   {"highestNote", preset.keyMap.highestNote},
                   {"notes", notesOf(*played.instrument())},
                   {"objects", objectsOf(*played.instrument(), played.slots())},
                   {"bodies", objectsOfSlots(*played.instrument())},
                   {"values", values}});
}

Result<std::string> objectNamesText(const Preset& preset) {
    if (preset.keyMap.kind != KeyMapKind::scene)
        return textOf(objectNames(preset.keyMap));
    return sceneNamed(preset.keyMap.object)
        .and_then(objectNamesOf)
        .transform([](const auto& names) { return textOf(names); });
}

} // namespace idiophone
