#include "Instrument/LoudnessMatch.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/Mallet.h"
#include "Instrument/Player.h"
#include "Object/Material.h"
#include "Support/RenderNotes.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <ebur128.h>
#include <string>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

constexpr double sampleRateHz = 48000;

/// Eight notes spread over the keys, two a second.
std::vector<MidiEvent> phrase(const KeyMap& map) {
    std::vector<MidiEvent> events;
    for (int i = 0; i < 8; ++i) {
        const int note = map.lowestNote + (map.highestNote - map.lowestNote) * i / 7;
        const int time = static_cast<int>(i * sampleRateHz / 2);
        events.push_back(midi(time, 0x90, note, 100));
        events.push_back(midi(time + static_cast<int>(sampleRateHz / 2) - 100, 0x80, note, 0));
    }
    return events;
}

/// A preset played and measured.
class Rig {
public:
    explicit Rig(const Preset& preset)
        : map(preset.keyMap), instrument(Instrument::build(map, ObjectLibrary::shared()).value()),
          match(instrument, preset.surface),
          player(instrument, sampleRateHz, preset.surface, preset.seed) {}

    /// After a gain on top of the level.
    double loudness(const ParameterValues& parameters, double gainDb) {
        player.reset();
        const auto sound = renderStereo(
            player, phrase(map), static_cast<std::size_t>(4.5 * sampleRateHz), 4800, parameters);
        const auto gain = static_cast<float>(std::pow(10, (parameters[level] + gainDb) / 20));
        std::vector<float> interleaved;
        for (std::size_t i = 0; i < sound.left.size(); ++i) {
            interleaved.push_back(gain * sound.left[i]);
            interleaved.push_back(gain * sound.right[i]);
        }
        auto* meter = ebur128_init(2, static_cast<unsigned long>(sampleRateHz), EBUR128_MODE_I);
        ebur128_add_frames_float(meter, interleaved.data(), sound.left.size());
        double result = 0;
        ebur128_loudness_global(meter, &result);
        ebur128_destroy(&meter);
        return result;
    }

    KeyMap map;
    std::shared_ptr<const Instrument> instrument;
    LoudnessMatch match;
    Player player;
};

ParameterValues with(ParameterValues parameters, ParameterId parameter, double value) {
    parameters.set(parameter, value);
    return parameters;
}

} // namespace

TEST_CASE("With the gain applied, every library material and every mallet of the rack is within "
          "2 LU of every factory preset's own") {
    for (const auto& preset : factoryPresets()) {
        Rig rig(preset);
        const auto& own = preset.parameters;
        const double ownLoudness = rig.loudness(own, 0);
        double worst = 0;
        std::string worstChange;
        const auto check = [&](const ParameterValues& now, std::string_view change) {
            const double gain = rig.match.gainDb(own, now, sampleRateHz);
            const double error = rig.loudness(now, gain) - ownLoudness;
            INFO(preset.name << ", " << change << ": gain " << gain << " dB, off by " << error);
            CHECK(std::abs(error) <= 2);
            if (std::abs(error) > std::abs(worst)) {
                worst = error;
                worstChange = change;
            }
        };
        int choice = firstLibraryMaterial;
        for (const auto& other : materialLibrary())
            check(with(own, material, choice++), other.name);
        choice = firstRackMallet;
        for (const auto& other : malletRack())
            check(with(own, mallet, choice++), other.name);
        check(with(own, material, ownMaterial), "the objects' own material");
        check(with(own, mallet, customMallet), "the custom mallet");
        UNSCOPED_INFO(preset.name << ": worst " << worst << " LU, " << worstChange);
    }
    SUCCEED();
}

TEST_CASE("Without the gain, mallets on a xylophone are more than 20 LU apart") {
    const auto& preset = factoryPresets().front();
    Rig rig(preset);
    const double plastic = rig.loudness(preset.parameters, 20);
    const double yarn = rig.loudness(with(preset.parameters, mallet, firstRackMallet), 20);
    CHECK(plastic - yarn > 20);
}

TEST_CASE("The predicted loudness of factory presets that strike is libebur128's within 0.5 LU") {
    for (const auto& preset : factoryPresets()) {
        if (static_cast<int>(preset.parameters[contact]) != strikeContact)
            continue;
        Rig rig(preset);
        const double bothChannels = 10 * std::log10(2);
        const double measured =
            rig.loudness(preset.parameters, -preset.parameters[level]) - bothChannels;
        INFO(preset.name << ": " << measured);
        CHECK(std::abs(rig.match.predictedLufs(preset.parameters, sampleRateHz) - measured) < 0.5);
    }
}

TEST_CASE("With the preset's own material and mallet the gain is 0, whatever else moves") {
    const auto& preset = factoryPresets().front();
    const LoudnessMatch match(Instrument::build(preset.keyMap, ObjectLibrary::shared()).value());
    auto now = preset.parameters;
    for (const auto parameter : {malletSpeed, size, strikeAlong, tune, radiation, chatter, level})
        now.set(parameter, parameterInfo(parameter).maximum);
    CHECK(match.gainDb(preset.parameters, now, sampleRateHz) == 0);
}

TEST_CASE("The gain from one mallet to another is the opposite of the way back") {
    const auto& preset = factoryPresets().front();
    const LoudnessMatch match(Instrument::build(preset.keyMap, ObjectLibrary::shared()).value());
    const auto brass = with(preset.parameters, mallet, firstRackMallet + 6);
    const double gain = match.gainDb(preset.parameters, brass, sampleRateHz);
    CHECK(gain < -3);
    CHECK(std::abs(gain + match.gainDb(brass, preset.parameters, sampleRateHz)) < 1e-9);
}

TEST_CASE("The gain is finite and at most 40 dB, and 0 where nothing sounds") {
    ObjectLibrary library;
    const auto bar = library.add("bar", syntheticObject({15, 440, 440, 9000}));
    KeyMap map;
    map.object = "bar";
    const LoudnessMatch match(Instrument::build(map, library).value());
    const ParameterValues own;
    auto now = own;
    for (const auto parameter : {mallet, youngsModulus, density, fluidDamping, viscoelasticDamping,
                                 malletMass, malletHardness, modalPulse})
        for (const double value :
             {parameterInfo(parameter).minimum, parameterInfo(parameter).maximum}) {
            now = with(with(own, material, customMaterial), parameter, value);
            INFO(parameterInfo(parameter).id << " " << value);
            CHECK(std::abs(match.gainDb(own, now, sampleRateHz)) <= 40);
        }
    CHECK(match.gainDb(own, with(own, malletMass, 500), 30) == 0);
    CHECK(std::isinf(match.predictedLufs(own, 30)));
}
