#include "Analysis/RecordingFit.h"

#include "Analysis/ModeSearch.h"
#include "Analysis/PulseSpectrum.h"
#include "Analysis/RecordedStrikes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace idiophone {
namespace {

constexpr double deepestPulse = 0.1;

double decibels(double energyRatio) {
    return 10 * std::log10(std::max(energyRatio, 1e-30));
}

double energyOf(std::span<const double> samples) {
    double sum = 0;
    for (const double sample : samples)
        sum += sample * sample;
    return sum;
}

/// Extrapolates back to the equivalent impulse: the middle of the contact, or near its onset if the
/// length is unknown, because the estimate is likely too long.
double gainAtImpulse(const DecayPole& pole,
                     const RecordedStrike& strike,
                     const RecordingFitSettings& settings) {
    constexpr double farthest = 1; // nepers
    const double back = strike.contactSeconds - settings.contactSeconds / 2;
    const double gain = std::exp(std::min(pole.decayPerSecond * back, farthest));
    if (settings.contactSeconds > 0)
        return gain /
               std::max(pulseSpectrum(pole.frequencyHz * settings.contactSeconds), deepestPulse);
    return gain;
}

} // namespace

Result<RecordingFit> fitRecordings(std::span<const StrikeRecording> recordings,
                                   const RecordingFitSettings& settings,
                                   const WorkControl& control) {
    if (recordings.empty())
        return failure("There is no recording to fit.");
    std::vector<std::string> remarks;
    const auto strikes = recordedStrikes(recordings, settings, remarks);
    if (!strikes)
        return tl::unexpected(strikes.error());
    ModeSearch search(*strikes, control);
    if (auto searched = search.run(settings.modeCount); !searched)
        return tl::unexpected(searched.error());
    if (search.modes.empty())
        return failure(recordings.front().name + ": nothing in it rings like a struck object");
    RecordingFit fit{.modes = {},
                     .modesFound = search.found,
                     .remarks = std::move(remarks),
                     .noiseDecibels = {}};
    for (const auto& [pole, amplitudes] : search.modes) {
        auto& mode =
            fit.modes.emplace_back(MeasuredMode{pole.frequencyHz, pole.decayPerSecond, {}, {}});
        for (std::size_t r = 0; r < amplitudes.size(); ++r) {
            const auto& strike = (*strikes)[r];
            mode.waves.push_back(strike.peak * amplitudes[r]);
            mode.amplitudes.push_back(std::abs(mode.waves.back()) *
                                      gainAtImpulse(pole, strike, settings));
        }
    }
    for (std::size_t r = 0; r < recordings.size(); ++r) {
        const auto& [decay, peak, contact, begin, before, noise] = (*strikes)[r];
        const auto rest = without(decay, search.modes, r);
        fit.noiseDecibels.push_back(decibels(energyOf(rest) / energyOf(decay.samples)));
        const auto withoutTones =
            without({.samples = rest, .sampleRateHz = decay.sampleRateHz}, search.steady, r);
        fit.rests.push_back(restOf(decay, withoutTones, search.steady, r, noise.meanEnergy()));
        fit.decayBegins.push_back(begin);
    }
    return fit;
}

std::vector<float>
resynthesised(const RecordingFit& fit, std::size_t recording, const StrikeRecording& original) {
    std::vector<DampedSinusoid> sinusoids;
    for (const auto& mode : fit.modes)
        sinusoids.push_back({.pole = {mode.frequencyHz, mode.decayPerSecond},
                             .amplitudes = {-mode.waves[recording]}});
    const std::size_t begin = fit.decayBegins[recording];
    const DecayRecording silence{.samples = std::vector<double>(original.samples.size() - begin),
                                 .sampleRateHz = original.sampleRateHz};
    std::vector<float> result(begin, 0.0f);
    std::ranges::transform(without(silence, sinusoids, 0), std::back_inserter(result),
                           [](double sample) { return static_cast<float>(sample); });
    return result;
}

} // namespace idiophone
