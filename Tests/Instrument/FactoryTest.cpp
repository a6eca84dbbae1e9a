#include "Instrument/FactoryContent.h"
#include "Instrument/LoudnessPhrase.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "IntegratedLufs.h"
#include "Support/KeyedPresets.h"
#include "Support/Level.h"
#include "Support/PoleFit.h"
#include "Support/RenderNotes.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <cmath>
#include <set>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

std::unique_ptr<Player> playerFor(const Preset& preset) {
    auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared());
    REQUIRE(instrument);
    return std::make_unique<Player>(*instrument, sampleRateHz, preset.surface, preset.seed);
}

void applyLevel(std::vector<float>& sound, const Preset& preset) {
    const auto gain = static_cast<float>(std::pow(10, preset.parameters[ParameterId::level] / 20));
    for (float& sample : sound)
        sample *= gain;
}

/// Returns both channels one after the other, with the level applied.
std::vector<float> renderBoth(Player& player,
                              const std::vector<MidiEvent>& events,
                              std::size_t samples,
                              const Preset& preset) {
    auto sound = renderStereo(player, events, samples, 480, preset.parameters);
    sound.left.insert(sound.left.end(), sound.right.begin(), sound.right.end());
    applyLevel(sound.left, preset);
    return sound.left;
}

} // namespace

TEST_CASE("Every factory preset is complete and builds an instrument") {
    auto presets = keyedFactoryPresets();
    CHECK(presets.front().name == "Rosewood Xylophone");
    std::set<std::string> names;
    for (const auto& preset : presets) {
        INFO(preset.name);
        CHECK(names.insert(preset.name).second);
        CHECK_FALSE(preset.description.empty());
        CHECK_FALSE(preset.tags.empty());
        CHECK(preset.unknownParameters.empty());
        CHECK(Instrument::build(preset.keyMap, ObjectLibrary::shared()));
        CHECK(findFactoryPreset(preset.name) == &preset);
    }
    CHECK(findFactoryPreset("no such preset") == nullptr);
}

TEST_CASE("Every factory preset has one sound word for brightness and one for length") {
    const std::set<std::string> brightness{"dark", "warm", "clear", "bright"};
    const std::set<std::string> length{"short", "ringing", "long"};
    for (const auto& preset : factoryPresets()) {
        INFO(preset.name);
        const auto count = [&](const std::set<std::string>& words) {
            return std::ranges::count_if(
                preset.tags, [&](const std::string& tag) { return words.contains(tag); });
        };
        CHECK(count(brightness) == 1);
        CHECK(count(length) == 1);
    }
}

TEST_CASE("Every key of every bar instrument sounds within 1 cent of equal temperament") {
    std::set<std::string> objects;
    for (const auto& preset : keyedFactoryPresets()) {
        // Tubular bells have no mode at their pitch (TubeTuningTest).
        if (preset.keyMap.kind != KeyMapKind::bars || preset.name == "Tubular Bells" ||
            !objects.insert(preset.keyMap.object).second)
            continue;
        // Compression would merge one fundamental with a twisting mode 2.5 Hz away and shift it by
        // a cent.
        auto parameters = preset.parameters;
        parameters.set(ParameterId::compression, 0);
        const auto player = playerFor(preset);
        for (int note = preset.keyMap.lowestNote; note <= preset.keyMap.highestNote; ++note) {
            player->reset();
            const auto sound =
                renderStereo(*player, {midi(0, 0x90, note, 100)}, 14400, 480, parameters);
            const double expectedHz = 440 * std::exp2((note - 69) / 12.0);
            for (const auto* channel : {&sound.left, &sound.right}) {
                const auto pole = fitPole(*channel, sampleRateHz, expectedHz, 0.04);
                INFO(preset.name << ", note " << note << ": " << pole.frequencyHz << " Hz for "
                                 << expectedHz);
                CHECK(std::abs(cents(pole.frequencyHz, expectedHz)) < 1);
            }
        }
    }
    CHECK(objects.size() >= 6);
}

TEST_CASE("Radiation separates left and right of every factory preset by at most 12 dB") {
    for (const auto& preset : keyedFactoryPresets()) {
        auto player = playerFor(preset);
        const auto sound = renderStereo(*player, loudnessPhrase(preset.keyMap, 100, sampleRateHz),
                                        static_cast<std::size_t>(loudnessPhraseSeconds * 48000),
                                        480, preset.parameters);
        std::vector<float> side(sound.left.size());
        for (std::size_t i = 0; i < side.size(); ++i)
            side[i] = (sound.left[i] - sound.right[i]) / 2;
        INFO(preset.name);
        CHECK(peak(side) > 1e-4f * peak(sound.left));
        CHECK(rms(sound.left) < 4 * rms(sound.right));
        CHECK(rms(sound.right) < 4 * rms(sound.left));
    }
}

TEST_CASE("Factory presets play their phrase at -26 LUFS at velocity 100, within 1 LU") {
    for (const auto& preset : keyedFactoryPresets()) {
        const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared());
        REQUIRE(instrument);
        const auto [left, right] = playLoudnessPhrase(preset, *instrument, sampleRateHz);
        std::vector<float> interleaved;
        for (std::size_t i = 0; i < left.size(); ++i)
            interleaved.insert(interleaved.end(), {left[i], right[i]});
        applyLevel(interleaved, preset);
        const double lufs = integratedLufs(interleaved, 2, sampleRateHz);
        INFO(preset.name << ": " << lufs << " LUFS; `idiophone presets` finds its level");
        CHECK(std::abs(lufs - factoryLufs) <= 1);
    }
}

TEST_CASE("Ten notes at once at velocity 127 give finite sound and end in silence") {
    for (const auto& preset : keyedFactoryPresets()) {
        INFO(preset.name);
        const int range = preset.keyMap.highestNote - preset.keyMap.lowestNote;
        for (int lowest = preset.keyMap.lowestNote; lowest <= preset.keyMap.highestNote - 10;
             lowest += 13) {
            auto player = playerFor(preset);
            const bool adjacent = lowest % 2 == 0;
            std::vector<MidiEvent> events, releases;
            for (int i = 0; i < 10; ++i) {
                const int note = adjacent ? lowest + i : preset.keyMap.lowestNote + range * i / 9;
                events.push_back(midi(0, 0x90, note, 127));
                releases.push_back(midi(0, 0x80, note, 0));
            }
            const auto sound = renderBoth(*player, events, 24000, preset);
            for (const float sample : sound)
                REQUIRE(std::isfinite(sample));
            render(*player, releases, 480, 480, preset.parameters);
            for (int seconds = 0; seconds < 60 && !player->silent(); ++seconds)
                render(*player, {}, 48000, 4800, preset.parameters);
            CHECK(player->silent());
        }
    }
}
