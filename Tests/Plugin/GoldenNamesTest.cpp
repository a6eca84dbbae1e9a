// What projects of released versions hold by a name or a number alone is what it was: all names
// and numbers by which projects, presets and hosts know things, and what stands behind them, line
// by line in Golden/VERSION/names.txt. What a state holds itself is not here.
#include "Instrument/FactoryContent.h"
#include "Object/Mallet.h"
#include "Object/MaterialFile.h"
#include "Plugin/ContentHash.h"
#include "Plugin/GoldenFolder.h"
#include "Scene/FactoryScenes.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using nlohmann::json;

namespace {

using Lines = std::vector<std::string>;

template <typename... Words>
void add(Lines& lines, const Words&... words) {
    std::ostringstream line;
    line << std::setprecision(9);
    ((line << words << ' '), ...);
    lines.push_back(line.str().substr(0, line.str().size() - 1));
}

std::string hashOf(std::span<const std::byte> bytes) {
    std::ostringstream text;
    text << std::hex << std::setw(16) << std::setfill('0') << contentHash(bytes);
    return text.str();
}

json without(json object, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        object.erase(key);
    return object;
}

/// A line for each figure.
void addFigures(Lines& lines, const std::string& of, const json& figures) {
    const json flat = figures.flatten();
    for (const auto& [place, value] : flat.items())
        add(lines, of, place, value.dump());
}

/// By which hosts find the plugin.
void addPlugin(Lines& lines) {
    add(lines, "plugin manufacturer", IDIOPHONE_MANUFACTURER_CODE);
    add(lines, "plugin code", IDIOPHONE_PLUGIN_CODE);
    add(lines, "plugin AU type", IDIOPHONE_AU_MAIN_TYPE);
    add(lines, "plugin LV2", IDIOPHONE_LV2_URI);
}

void addParameters(Lines& lines) {
    Processor processor;
    const auto& parameters = processor.getParameters();
    for (int i = 0; i < parameters.size(); ++i) {
        auto* hosted = dynamic_cast<juce::HostedAudioProcessorParameter*>(parameters[i]);
        REQUIRE(hosted != nullptr);
        const auto id = hosted->getParameterID().toStdString();
        add(lines, "parameter", i, id, "since", hosted->getVersionHint());
        const auto* info = findParameter(id);
        REQUIRE(info != nullptr);
        const auto choices = choiceNames(info->parameter);
        for (std::size_t choice = 0; choice < choices.size(); ++choice)
            add(lines, id, choice, choices[choice]);
        std::ostringstream lane; // hosts record places from 0 to 1
        lane << std::setprecision(9);
        for (const float place : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
            hosted->setValue(place);
            lane << ' ' << processor.parameterValue(info->parameter);
        }
        add(lines, "lane", id, "by quarters:" + lane.str());
        add(lines, "default", id, ParameterValues()[info->parameter]);
    }
    for (int choice = 0; choice < static_cast<int>(choiceNames(ParameterId::motorSync).size());
         ++choice)
        add(lines, "motor_sync", choice, "beats", motorSyncBeats(choice));
}

void addMaterialsAndMallets(Lines& lines) {
    for (const auto& material : materialLibrary())
        addFigures(lines, "material " + material.name,
                   without(json::parse(encodeMaterial(material)),
                           {"format", "version", "name", "source"}));
    for (const auto& mallet : malletRack())
        addFigures(lines, "mallet " + std::string(mallet.name),
                   {{"mass_kg", mallet.massKg},
                    {"head_radius_m", mallet.headRadiusMetres},
                    {"effective_modulus_pa", mallet.effectiveModulusPa}});
}

/// Tracks change programs, and scenes name the preset whose bars they play.
void addPresets(Lines& lines) {
    Processor processor;
    for (int i = 0; i < processor.getNumPrograms(); ++i)
        add(lines, "program", i, processor.getProgramName(i));
    for (const auto& preset : factoryPresets()) {
        auto figures = without(json::parse(encodePreset(preset)),
                               {"format", "version", "name", "author", "description", "tags"});
        figures["surface"] = without(figures["surface"], {"format", "version", "name"});
        addFigures(lines, "preset " + preset.name, figures);
    }
}

std::set<std::filesystem::path> filesOf(const char* folder) {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "Resources" / folder))
        files.insert(entry.path());
    return files;
}

void addScenes(Lines& lines) {
    for (const auto& scene : factoryScenes())
        add(lines, "scene", scene.name);
    for (const auto& file : filesOf("Scenes")) {
        const auto scene = json::parse(bytesOf(file));
        const auto text = without(scene, {"format", "version", "name", "description"}).dump();
        REQUIRE(findFactoryScene(scene.at("name").get<std::string>()) != nullptr);
        add(lines, "scene", scene.at("name").get<std::string>(), "holds",
            hashOf(std::as_bytes(std::span(text))));
    }
}

void addObjects(Lines& lines) {
    for (const auto& file : filesOf("Objects")) {
        const auto name = file.stem().string();
        const auto bytes = factoryObject(name);
        if (!bytes)
            continue;
        add(lines, "object", name);
        add(lines, "object", name, "holds", hashOf(*bytes));
    }
}

Lines published() {
    Lines lines;
    addPlugin(lines);
    addParameters(lines);
    addMaterialsAndMallets(lines);
    addPresets(lines);
    addScenes(lines);
    addObjects(lines);
    return lines;
}

} // namespace

TEST_CASE("What a released version named and numbered is there and is what it was") {
    const auto now = published();
    const std::set<std::string> present(now.begin(), now.end());
    int found = 0;
    for (const auto& version : std::filesystem::directory_iterator(goldenFolder)) {
        INFO(version.path());
        std::ifstream file(version.path() / "names.txt");
        REQUIRE(file);
        for (std::string line; std::getline(file, line); ++found) {
            INFO(line);
            CHECK(present.contains(line));
        }
    }
    CHECK(found >= 2400);
}

// For a release, as the golden states (GoldenStateTest.cpp).
TEST_CASE("Record the names of this version", "[.][make-golden]") {
    const auto folder = folderOfThisVersion();
    const auto lines = published();
    std::ofstream file(folder / "names.txt", std::ios::binary);
    for (const auto& line : lines)
        file << line << '\n';
}
