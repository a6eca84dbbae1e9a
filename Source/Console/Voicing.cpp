#include "Console/Voicing.h"

#include "Console/LoudnessMeter.h"
#include "Instrument/Instrument.h"
#include "Instrument/Player.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

constexpr double mostClimbDb = 3;
constexpr double mostGainDb = 40;

constexpr int sampleRateHz = 48000;
constexpr std::size_t noteSamples = sampleRateHz;
constexpr std::array velocities{40, 100};

/// Plays a key for a second and measures its loudest 400 ms. A silent key has -infinity.
double loudestLufs(const Preset& preset,
                   const std::shared_ptr<const Instrument>& instrument,
                   int note,
                   int velocity) {
    Player player(instrument, sampleRateHz, preset.surface, preset.seed, preset.matched());
    std::vector<float> left(noteSamples), right(noteSamples);
    const MidiEvent struck{
        .sampleOffset = 0,
        .bytes = {0x90, static_cast<std::uint8_t>(note), static_cast<std::uint8_t>(velocity)}};
    player.process({left, right}, std::array{struck}, preset.parameters);
    std::vector<float> interleaved;
    for (std::size_t i = 0; i < noteSamples; ++i)
        interleaved.insert(interleaved.end(), {left[i], right[i]});
    return loudestMomentLufs(interleaved, 2, sampleRateHz);
}

/// The line of least squares, with its slope held within the climb.
std::vector<double> evenLine(const std::vector<double>& loudness) {
    double count = 0, places = 0, sum = 0, squares = 0, products = 0;
    for (std::size_t key = 0; key < loudness.size(); ++key)
        if (const auto place = static_cast<double>(key); std::isfinite(loudness[key])) {
            count += 1;
            places += place;
            sum += loudness[key];
            squares += place * place;
            products += place * loudness[key];
        }
    if (count == 0)
        return std::vector<double>(loudness.size(), 0.0);
    const double spread = count * squares - places * places;
    const double slope = spread > 0 ? (count * products - places * sum) / spread : 0;
    const double steepest = mostClimbDb / std::max(1.0, static_cast<double>(loudness.size()) - 1);
    const double held = std::clamp(slope, -steepest, steepest);
    std::vector<double> line;
    for (std::size_t key = 0; key < loudness.size(); ++key)
        line.push_back(sum / count + held * (static_cast<double>(key) - places / count));
    return line;
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
    auto gains = evenLine(loudness);
    for (std::size_t key = 0; key < gains.size(); ++key)
        gains[key] = std::isfinite(loudness[key])
                         ? std::clamp(gains[key] - loudness[key], -mostGainDb, mostGainDb)
                         : 0;
    return gains;
}

} // namespace idiophone
