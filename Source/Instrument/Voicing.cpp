#include "Instrument/Voicing.h"

#include "Instrument/Instrument.h"
#include "Instrument/PhrasePrediction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace idiophone {
namespace {

constexpr double mostClimbDb = 6;
constexpr double mostGainDb = 40;

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

Result<std::vector<double>>
evenVoicingDb(Preset preset, ObjectLibrary& library, double sampleRateHz) {
    preset.keyMap.voicingDb.clear();
    const auto instrument = Instrument::build(preset.keyMap, library);
    if (!instrument)
        return tl::unexpected(instrument.error());
    std::vector<double> loudness;
    for (int note = preset.keyMap.lowestNote; note <= preset.keyMap.highestNote; ++note) {
        const auto lufs = predictedLoudness(
            Phrase(*instrument, preset.surface, sampleRateHz, note, note), preset.parameters);
        loudness.push_back(std::reduce(lufs.begin(), lufs.end()) /
                           static_cast<double>(lufs.size()));
    }
    auto gains = evenLine(loudness);
    for (std::size_t key = 0; key < gains.size(); ++key)
        gains[key] = std::isfinite(loudness[key])
                         ? std::clamp(gains[key] - loudness[key], -mostGainDb, mostGainDb)
                         : 0;
    return gains;
}

} // namespace idiophone
