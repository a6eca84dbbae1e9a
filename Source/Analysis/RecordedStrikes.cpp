#include "Analysis/RecordedStrikes.h"

#include "Analysis/FreeDecay.h"
#include "Object/NumberText.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace idiophone {
namespace {

// Rms relative to a recording's peak; any real room is noisier. Without noise, rounding errors
// would look like modes.
constexpr double ditherLevel = 3e-5; // −90 dB

/// Uniform noise, the same on every machine.
class Dither {
public:
    double operator()() {
        constexpr double uniformRms = 0.28867513459481287;
        return ditherLevel / uniformRms * (std::ldexp(static_cast<double>(random()), -32) - 0.5);
    }

private:
    std::mt19937 random;
};

/// Returns the noise alone: what sounds before the strike, or else the end of the recording.
std::span<const double> noiseOf(std::span<const double> before, std::span<const double> decay) {
    constexpr std::size_t tail = 5;
    return before.empty() ? decay.last(decay.size() / tail) : before;
}

/// Returns the amplitude of a tone in noise.
double amplitudeOf(std::span<const double> samples, double hz, double rateHz) {
    std::complex<double> sum = 0;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        const double turn = (static_cast<double>(n) + 0.5) / static_cast<double>(samples.size());
        const double window = 1 - std::cos(2 * std::numbers::pi * turn);
        sum += window * samples[n] *
               std::polar(1.0, -2 * std::numbers::pi * hz * static_cast<double>(n) / rateHz);
    }
    return 2 * std::abs(sum) / static_cast<double>(samples.size());
}

bool isOfTheMains(double hz) {
    constexpr double highest = 1000, tolerance = 0.5;
    return hz < highest && (std::abs(std::remainder(hz, 50)) < tolerance ||
                            std::abs(std::remainder(hz, 60)) < tolerance);
}

} // namespace

Result<std::vector<RecordedStrike>> recordedStrikes(std::span<const StrikeRecording> recordings,
                                                    const RecordingFitSettings& settings,
                                                    std::vector<std::string>& remarks) {
    constexpr double shortestBefore = 0.1, longestBefore = 1, guard = 0.002;
    std::vector<RecordedStrike> result;
    Dither dither;
    for (const auto& [name, samples, rate] : recordings) {
        const auto decay = findFreeDecay(samples, rate, settings.contactSeconds);
        if (!decay)
            return failure(name + ": " + decay.error().message);
        if (decay->clipped)
            remarks.push_back(name + " is clipped, which adds partials that it has not.");
        if (decay->others)
            remarks.push_back(name + " holds several strikes; the strongest at " +
                              numberText(static_cast<double>(decay->onset) / rate, 3) +
                              " s was taken.");
        const auto count = [rate = rate](double seconds) {
            return static_cast<std::size_t>(seconds * rate);
        };
        const auto used = samples.subspan(
            decay->begin, std::min(decay->end - decay->begin, count(settings.longestSeconds)));
        double peak = 0;
        for (const float sample : used)
            peak = std::max(peak, std::abs(static_cast<double>(sample)));
        if (!(peak > 0))
            return failure(name + ": nothing rings after its strongest strike");
        const auto scaled = [&](std::span<const float> part) {
            std::vector<double> values;
            for (const float sample : part)
                values.push_back(static_cast<double>(sample) / peak + dither());
            return values;
        };
        DecayRecording kept{.samples = scaled(used), .sampleRateHz = rate};
        std::vector<double> before;
        if (decay->onset > count(shortestBefore + guard) && !decay->others)
            before = scaled(samples.first(decay->onset - count(guard))
                                .last(std::min(decay->onset - count(guard), count(longestBefore))));
        const NoiseFloor noise(noiseOf(before, kept.samples), rate);
        result.push_back({.decay = std::move(kept),
                          .peak = peak,
                          .contactSeconds = static_cast<double>(decay->begin - decay->onset) / rate,
                          .begin = decay->begin,
                          .before = std::move(before),
                          .noise = noise});
    }
    return result;
}

bool RecordedStrike::isSteady(const DecayPole& pole, double amplitude, bool isAlone) const {
    constexpr double soundsBefore = 0.5, steadyFall = 0.12, mainsFall = 0.7; // falls in nepers
    if (!before.empty())
        return amplitudeOf(before, pole.frequencyHz, decay.sampleRateHz) > soundsBefore * amplitude;
    const double fall = pole.decayPerSecond * decay.seconds();
    return isAlone && (fall < steadyFall || (fall < mainsFall && isOfTheMains(pole.frequencyHz)));
}

} // namespace idiophone
