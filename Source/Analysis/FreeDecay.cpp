#include "Analysis/FreeDecay.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {
namespace {

constexpr double faintestPeak = 1e-6; // of full scale
constexpr double nearFullScale = 0.9;
// A sound of beating modes may reach its peak long after the strike.
constexpr double riseSeconds = 0.01, attackSeconds = 0.25;
constexpr double shortestContactSeconds = 0.0002, longestContactSeconds = 0.008;
// Minimum rise of energy at a strike, and its minimum energy relative to the strongest strike. A
// beat rarely reaches both.
constexpr double strikeRise = 100, strikeEnergy = 1e-3;

class Strikes {
public:
    Strikes(std::span<const float> recording, double sampleRateHz)
        : samples(recording), rate(sampleRateHz), energies(recording.size() + 1),
          sharpEnergies(recording.size() + 1) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double here = at(i), bend = here - 2 * at(i - 1) + at(i - 2);
            energies[i + 1] = energies[i] + here * here;
            sharpEnergies[i + 1] = sharpEnergies[i] + bend * bend;
        }
        peak = static_cast<std::size_t>(
            std::ranges::max_element(samples, {}, [](float x) { return std::abs(x); }) -
            samples.begin());
    }

    double peakLevel() const { return std::abs(at(peak)); }

    /// Returns the first sample of the strike. First finds the largest ratio of the energy after to
    /// the energy before, shortly before the peak. Then finds the first sample near it that exceeds
    /// the level before.
    std::size_t onset() const {
        const std::size_t before = window, after = count(0.002);
        const double floor = 1e-5 * peakLevel() * peakLevel() * static_cast<double>(before);
        std::size_t best = peak;
        double bestRise = 0;
        for (std::size_t i = peak - std::min(peak, count(attackSeconds)); i <= peak; ++i) {
            const double rise = energy(energies, i, i + after) /
                                (energy(energies, i - std::min(i, before), i) + floor);
            if (rise > bestRise) {
                bestRise = rise;
                best = i;
            }
        }
        double quiet = 0, loud = 0;
        for (std::size_t i = best - std::min(best, before); i + count(0.0005) < best; ++i)
            quiet = std::max(quiet, std::abs(at(i)));
        for (std::size_t i = best; i < std::min(best + before, samples.size()); ++i)
            loud = std::max(loud, std::abs(at(i)));
        std::size_t first = best - std::min(best, count(0.0005));
        while (first < peak && std::abs(at(first)) <= std::max(2 * quiet, 0.01 * loud))
            ++first;
        return first;
    }

    /// Returns twice the time in which the sound rises to half its height. Later peaks are beats of
    /// many modes.
    std::size_t contactEnd(std::size_t onset) const {
        const std::size_t until = std::min(onset + count(riseSeconds), samples.size());
        double highest = 0;
        for (std::size_t i = onset; i < until; ++i)
            highest = std::max(highest, std::abs(at(i)));
        std::size_t risen = onset;
        while (risen < until && std::abs(at(risen)) < highest / 2)
            ++risen;
        return onset + std::clamp(2 * (risen - onset), count(shortestContactSeconds),
                                  count(longestContactSeconds));
    }

    /// Returns the next sudden rise from `begin` on, or the end of the recording.
    std::size_t nextStrike(std::size_t onset, std::size_t begin) const {
        const auto strike = firstStrike(onset, begin + window, samples.size() + 1 - window);
        return strike ? *strike - window / 4 : samples.size();
    }

    bool hasStrikeBefore(std::size_t onset) const {
        return firstStrike(onset, window, onset - std::min(onset, 2 * window)).has_value();
    }

    /// Returns true if three samples in a row have the maximum value. They must be near full scale,
    /// or fall off by more than a few 16-bit steps, as in a recording that was attenuated later. In
    /// quiet low sounds, steps make flat tops too.
    bool clipped() const {
        const double highest = peakLevel() * (1 - 1e-6);
        const double minimumFall = std::max(0.01 * peakLevel(), 4.0 / 32768);
        const auto isHighest = [&](std::size_t i) { return std::abs(at(i)) >= highest; };
        for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end + 1) {
            for (end = begin; end < samples.size() && isHighest(end);)
                ++end;
            const bool isFlat = end - begin >= 3;
            const double beside = std::min(std::abs(at(begin - 1)), std::abs(at(end)));
            if (isFlat && (highest >= nearFullScale || highest - beside >= minimumFall))
                return true;
        }
        return false;
    }

    std::size_t count(double seconds) const {
        return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(seconds * rate)));
    }

private:
    /// Returns 0 before the first sample.
    double at(std::size_t i) const {
        return i < samples.size() ? static_cast<double>(samples[i]) : 0;
    }
    static double energy(const std::vector<double>& sums, std::size_t from, std::size_t until) {
        const std::size_t last = sums.size() - 1;
        return sums[std::min(until, last)] - sums[std::min(from, last)];
    }
    /// Returns the first sudden rise of energy in a range that is not too faint beside the strike
    /// at `onset`.
    std::optional<std::size_t>
    firstStrike(std::size_t onset, std::size_t from, std::size_t until) const {
        const double faintest = strikeEnergy * energy(sharpEnergies, onset, onset + window);
        for (std::size_t i = from; i < until; ++i) {
            const double after = energy(sharpEnergies, i, i + window);
            if (after > faintest && after > strikeRise * energy(sharpEnergies, i - window, i))
                return i;
        }
        return std::nullopt;
    }

    std::span<const float> samples;
    double rate;
    std::size_t window = count(0.005); ///< samples that are compared before and after a strike
    std::vector<double> energies, sharpEnergies; ///< cumulative, of samples and second differences
    std::size_t peak = 0;
};

} // namespace

Result<FreeDecay>
findFreeDecay(std::span<const float> samples, double sampleRateHz, double contactSeconds) {
    if (!std::ranges::all_of(samples, [](float x) { return std::isfinite(x); }))
        return failure("it holds values that are not numbers");
    if (static_cast<double>(samples.size()) < shortestDecaySeconds * sampleRateHz)
        return failure("it is shorter than 20 ms");
    const Strikes strikes(samples, sampleRateHz);
    if (strikes.peakLevel() < faintestPeak)
        return failure("it is silent");
    FreeDecay decay;
    decay.onset = strikes.onset();
    decay.begin = contactSeconds > 0 ? decay.onset + strikes.count(contactSeconds)
                                     : strikes.contactEnd(decay.onset);
    decay.end = strikes.nextStrike(decay.onset, decay.begin);
    decay.clipped = strikes.clipped();
    decay.others = decay.end < samples.size() || strikes.hasStrikeBefore(decay.onset);
    if (static_cast<double>(decay.end) <
        static_cast<double>(decay.begin) + shortestDecaySeconds * sampleRateHz)
        return failure("it ends or is struck again less than 20 ms after its strongest strike");
    return decay;
}

} // namespace idiophone
