// Tests that the keys of factory keyboards are about equally loud.
#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "IntegratedLufs.h"
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
constexpr std::array velocities{20, 40, 100, 127};

std::shared_ptr<const Instrument> instrumentOf(const Preset& preset) {
    return Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
}

/// Returns the LUFS of the loudest 400 ms, [velocity][key].
std::array<std::vector<double>, velocities.size()> loudnessOfKeys(const Preset& preset) {
    Player player(instrumentOf(preset), sampleRateHz, preset.surface, preset.seed);
    std::array<std::vector<double>, velocities.size()> keys;
    for (int note = preset.keyMap.lowestNote; note <= preset.keyMap.highestNote; ++note)
        for (std::size_t k = 0; k < velocities.size(); ++k) {
            player.reset();
            const auto sound = renderStereo(player, {midi(0, 0x90, note, velocities[k])}, 28800,
                                            960, preset.parameters);
            std::vector<float> interleaved;
            for (std::size_t i = 0; i < sound.left.size(); ++i)
                interleaved.insert(interleaved.end(), {sound.left[i], sound.right[i]});
            keys[k].push_back(loudestMomentLufs(interleaved, 2, sampleRateHz));
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
        if (preset.keyMap.kind == KeyMapKind::kit) // each object answers velocity in its own way
            continue;
        const auto keys = loudnessOfKeys(preset);
        for (std::size_t velocity = 0; velocity < keys.size(); ++velocity) {
            INFO(preset.name << " at velocity " << velocities[velocity]);
            const auto smooth = mean(keys[velocity], 6);
            CHECK(span(smooth) <= 8);
            for (std::size_t key = 0; key < smooth.size(); ++key) {
                INFO("note " << preset.keyMap.lowestNote + static_cast<int>(key));
                CHECK(std::abs(keys[velocity][key] - smooth[key]) <= 4);
            }
        }
        INFO(preset.name);
        CHECK(span(keys[1]) <= span(keys[2]) + 3);
    }
}

TEST_CASE("A voicing of 20 dB multiplies the impulse of its own key by ten") {
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
