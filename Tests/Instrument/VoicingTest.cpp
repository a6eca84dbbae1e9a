// Keyboards whose keys are equally loud.
#include "Instrument/Voicing.h"
#include "Instrument/FactoryContent.h"
#include "Instrument/PhrasePrediction.h"
#include "Instrument/Player.h"
#include "Support/KeyedPresets.h"
#include "Support/RenderNotes.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

std::shared_ptr<const Instrument> instrumentOf(const Preset& preset) {
    return Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
}

/// [velocity][key] LUFS.
std::array<std::vector<double>, PhrasePrediction::velocities.size()>
loudnessOfKeys(const Preset& preset) {
    const auto instrument = instrumentOf(preset);
    std::array<std::vector<double>, PhrasePrediction::velocities.size()> keys;
    for (int note = preset.keyMap.lowestNote; note <= preset.keyMap.highestNote; ++note) {
        const auto lufs = predictedLoudness(
            Phrase(instrument, preset.surface, sampleRateHz, note, note), preset.parameters);
        for (std::size_t velocity = 0; velocity < keys.size(); ++velocity)
            keys[velocity].push_back(lufs[velocity]);
    }
    return keys;
}

double span(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    return most - least;
}

std::vector<double> mean(const std::vector<double>& values, std::size_t reach) {
    std::vector<double> means;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const std::size_t first = k - std::min(k, reach);
        const std::size_t end = std::min(values.size(), k + reach + 1);
        double sum = 0;
        for (std::size_t j = first; j < end; ++j)
            sum += values[j];
        means.push_back(sum / static_cast<double>(end - first));
    }
    return means;
}

} // namespace

TEST_CASE("Keys of factory presets lie within 4 dB of a smooth curve that spans at most 8 dB") {
    for (const auto& preset : keyedFactoryPresets()) {
        const auto keys = loudnessOfKeys(preset);
        for (std::size_t velocity = 0; velocity < keys.size(); ++velocity) {
            INFO(preset.name << " at velocity " << PhrasePrediction::velocities[velocity]);
            const auto smooth = mean(keys[velocity], 6);
            CHECK(span(smooth) <= 8);
            for (std::size_t key = 0; key < smooth.size(); ++key) {
                INFO("note " << preset.keyMap.lowestNote + static_cast<int>(key));
                CHECK(std::abs(keys[velocity][key] - smooth[key]) <= 4);
            }
        }
        INFO(preset.name);
        CHECK(span(keys[0]) <= span(keys[PhrasePrediction::middleVelocity]) + 3);
    }
}

TEST_CASE("A voicing of 20 dB multiplies what its key strikes by ten and no other key") {
    auto preset = *findFactoryPreset("Rosewood Xylophone");
    preset.keyMap.voicingDb = {};
    const auto plain = instrumentOf(preset);
    preset.keyMap.voicingDb = {0, 20};
    const auto voiced = instrumentOf(preset);
    for (const int note : {65, 66, 67, 40, 110}) {
        const double ratio = voiced->key(note).mallet.gain / plain->key(note).mallet.gain;
        CHECK(ratio == (note == 66 ? 10 : 1));
    }
    const auto peak = [&](const std::shared_ptr<const Instrument>& instrument) {
        Player player(instrument, sampleRateHz);
        const auto sound =
            renderStereo(player, {midi(0, 0x90, 66, 100)}, 4800, 480, preset.parameters);
        return std::ranges::max(sound.left);
    };
    CHECK(std::abs(peak(voiced) / peak(plain) - 10) < 1e-3);
}

TEST_CASE("An even voicing brings the mean over the velocities onto a line and is found again") {
    auto preset = *findFactoryPreset("Marimba");
    preset.keyMap.voicingDb = {};
    const auto found = evenVoicingDb(preset, ObjectLibrary::shared(), sampleRateHz).value();
    preset.keyMap.voicingDb = found;
    CHECK(evenVoicingDb(preset, ObjectLibrary::shared(), sampleRateHz).value() == found);
    const auto keys = loudnessOfKeys(preset);
    const auto meanOf = [&](std::size_t key) {
        return (keys[0][key] + keys[1][key] + keys[2][key]) / 3;
    };
    const std::size_t last = found.size() - 1;
    const double step = (meanOf(last) - meanOf(0)) / static_cast<double>(last);
    CHECK(std::abs(step) * static_cast<double>(last) < 6.1);
    for (std::size_t key = 0; key <= last; ++key)
        CHECK(std::abs(meanOf(key) - meanOf(0) - step * static_cast<double>(key)) < 0.1);
}
