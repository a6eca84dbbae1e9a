#include "Instrument/StartingLevel.h"

#include "Instrument/LoudestBlow.h"
#include "Object/Mallet.h"
#include "Instrument/PhrasePrediction.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

/// As PhrasePrediction hears the factory presets, at their levels and velocity 100.
constexpr double wantedLufs = -42;
constexpr double hardestBlowDecibels = -18;

double lufsOf(const Phrase& phrase, const ParameterValues& values) {
    return predictedLoudness(phrase, values)[PhrasePrediction::middleVelocity];
}

} // namespace

double predictedLufs(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values) {
    return lufsOf(Phrase(instrument, surface, sampleRateHz), values);
}

ParameterValues withAudibleMallet(const std::shared_ptr<const Instrument>& instrument,
                                  const Surface& surface,
                                  double sampleRateHz,
                                  const ParameterValues& values) {
    constexpr double faintestLufs = wantedLufs - 12; // what the level has to make up for
    const Phrase phrase(instrument, surface, sampleRateHz);
    double loudest = lufsOf(phrase, values);
    auto best = values;
    for (std::size_t k = 0; k < malletRack().size() && !(loudest >= faintestLufs); ++k) {
        auto with = values;
        with.set(ParameterId::mallet, static_cast<double>(firstRackMallet + k));
        if (const double lufs = lufsOf(phrase, with); lufs > loudest) {
            loudest = lufs;
            best = with;
        }
    }
    return best;
}

double highestLevel(const std::shared_ptr<const Instrument>& instrument,
                    const Surface& surface,
                    double sampleRateHz,
                    const ParameterValues& values) {
    const double peak = loudestBlowPeak(instrument, surface, sampleRateHz, values);
    return hardestBlowDecibels - 20 * std::log10(peak);
}

double startingLevel(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values) {
    const double asLoud = wantedLufs - predictedLufs(instrument, surface, sampleRateHz, values);
    const double level = std::min(asLoud, highestLevel(instrument, surface, sampleRateHz, values));
    return std::isfinite(level) ? level : values[ParameterId::level];
}

} // namespace idiophone
