#include "Console/Voicing.h"

#include "Console/LoudnessMeter.h"
#include "Instrument/Instrument.h"
#include "Instrument/Player.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

constexpr double maximumGainDb = 40;

constexpr std::size_t noteSamples = measuredRateHz;
constexpr std::array velocities{40, 100};

/// Plays a key for a second and measures its loudest 400 ms. A silent key has -infinity.
double loudestLufs(const Preset& preset,
                   const std::shared_ptr<const Instrument>& instrument,
                   int note,
                   int velocity) {
    Player player(instrument, measuredRateHz, preset.surface, preset.seed, preset.matched());
    std::vector<float> left(noteSamples), right(noteSamples);
    const MidiEvent struck{
        .sampleOffset = 0,
        .bytes = {0x90, static_cast<std::uint8_t>(note), static_cast<std::uint8_t>(velocity)}};
    player.process({left, right}, std::array{struck}, preset.parameters);
    std::vector<float> interleaved;
    for (std::size_t i = 0; i < noteSamples; ++i)
        interleaved.insert(interleaved.end(), {left[i], right[i]});
    return loudestMomentLufs(interleaved, 2, measuredRateHz);
}

/// The mean of the keys that are heard.
double meanLufs(const std::vector<double>& loudness) {
    double sum = 0, count = 0;
    for (const double key : loudness)
        if (std::isfinite(key)) {
            sum += key;
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

} // namespace

Result<std::vector<double>> evenVoicingDb(Preset preset) {
    preset.keyMap.voicingDb.clear();
    const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared());
    if (!instrument)
        return tl::unexpected(instrument.error());
    std::vector<double> loudness;
    for (int note = preset.keyMap.lowestNote; note <= preset.keyMap.highestNote; ++note) {
        double sum = 0;
        for (const int velocity : velocities)
            sum += loudestLufs(preset, *instrument, note, velocity);
        loudness.push_back(sum / static_cast<double>(velocities.size()));
    }
    const double mean = meanLufs(loudness);
    std::vector<double> gains;
    for (const double key : loudness)
        gains.push_back(std::isfinite(key) ? std::clamp(mean - key, -maximumGainDb, maximumGainDb)
                                           : 0);
    return gains;
}

} // namespace idiophone
