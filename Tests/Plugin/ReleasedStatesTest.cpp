// Tests that projects saved with a released version open as they were. The folder of each version
// has a few states: `test_plugin "[.release]"` writes those of the version being released.
#include "Plugin/RestoredSound.h"
#include "Support/UserSettings.h"

#include "Instrument/FactoryContent.h"
#include "Object/FileBytes.h"
#include "Plugin/FactoryPrograms.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

const auto folderOfVersions = pathNamed(IDIOPHONE_SOURCE_DIR) / "Tests/Plugin/states";

std::string contentOf(const std::filesystem::path& file) {
    const auto bytes = readBytes(file, std::uintmax_t{1} << 20);
    REQUIRE(bytes);
    return *bytes;
}

std::vector<std::filesystem::path> releasedStates() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folderOfVersions))
        if (entry.is_regular_file())
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// Returns strikes of four octaves, so that some key has a sound in every preset.
juce::MidiBuffer middleKeys() {
    juce::MidiBuffer midi;
    for (int note = 36; note <= 84; ++note)
        midi.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(100)), 10);
    return midi;
}

/// Returns a state with all that a state may hold: an object, controllers, a tuning, an origin.
State fullState() {
    auto state = unusualState();
    state.objects.resize(3);
    state.controllers[ParameterId::size] = 1;
    state.tuning.scale = {.name = "fifths.scl", .text = "! fifths.scl\nFifths\n 2\n 3/2\n 2/1\n"};
    state.origin = {.presetId = "Mine/Bell.json", .presetContent = 7, .stored = state.parameters};
    return state;
}

} // namespace

TEST_CASE("States that released versions saved restore every value and sound") {
    const auto files = releasedStates();
    REQUIRE(files.size() >= 5);
    for (const auto& file : files) {
        INFO(nameOf(file));
        const auto bytes = contentOf(file);
        const auto asReleased = parseState(bytes);
        REQUIRE(asReleased);
        Processor processor;
        processor.setNonRealtime(true); // so that a scene does not depend on its worker's speed
        processor.prepareToPlay(48000, blockSamples);
        restoreBytes(processor, bytes);
        const auto now = parseState(saved(processor));
        REQUIRE(now);
        CHECK(*now == *asReleased);
        const auto released = nlohmann::json::parse(bytes);
        for (const auto& [id, value] : released.at("parameters").items()) {
            const auto* info = findParameter(id);
            INFO(id);
            REQUIRE(info);
            CHECK(now->parameters[info->parameter] == value.get<double>());
        }
        CHECK(loudest(render(processor, 48000, blockSamples, middleKeys())) > 1e-3f);
    }
}

TEST_CASE("The states of the version being released", "[.release]") {
    const auto folder = folderOfVersions / IDIOPHONE_VERSION;
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& state) {
        std::ofstream stream(folder / (name + ".json"), std::ios::binary);
        stream << state;
        REQUIRE(stream.flush());
    };
    for (const auto& [name, preset] : {std::pair{"xylophone", "Rosewood Xylophone"},
                                       {"kit", "Junkyard Kit"},
                                       {"scene", "Falling Rings"},
                                       {"vibraphone", "Vibraphone"}}) {
        Processor processor;
        processor.prepareToPlay(48000, blockSamples);
        REQUIRE(processor.view().presets.loadPreset(factoryPresetId(preset)));
        write(name, saved(processor));
    }
    Processor processor;
    processor.prepareToPlay(48000, blockSamples);
    restore(processor, fullState());
    write("full", saved(processor));
}
