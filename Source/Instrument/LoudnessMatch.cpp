#include "Instrument/LoudnessMatch.h"

#include "Instrument/PhrasePrediction.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double largestGainDb = 40;
// The tolerance is 2 LU; the prediction's own error uses up the rest.
constexpr double maximumFromMiddleDb = 1.5;

void copyInto(ParameterValues& to,
              const ParameterValues& from,
              std::span<const ParameterId> parameters) noexcept {
    for (const auto parameter : parameters)
        to.set(parameter, from[parameter]);
}

/// `now` with the preset's material and mallet.
ParameterValues withOwn(ParameterValues now, const ParameterValues& own) noexcept {
    copyInto(now, own, materialFigures);
    copyInto(now, own, malletFigures);
    copyInto(now, own, std::array{material, mallet});
    return now;
}

} // namespace

ParameterValues valuesThatMatter(const ParameterValues& values) noexcept {
    ParameterValues result;
    copyInto(result, values,
             std::array{material, decay, size, thickness, keepPitch, tune, concertPitch,
                        strikeAlong, strikeAcross, radiation, letRing, contact});
    if (static_cast<int>(values[material]) == customMaterial)
        copyInto(result, values, materialFigures);
    if (values[letRing] == 0)
        result.set(releaseTime, values[releaseTime]);
    if (!strikes(values)) {
        result.set(contactSpeed, values[contactSpeed]);
        if (static_cast<int>(values[contact]) == rollContact)
            result.set(rollCoupling, values[rollCoupling]);
        return result;
    }
    copyInto(result, values,
             std::array{mallet, hardness, malletSpeed, malletFollow, velocityCurve, chatter,
                        modalPulse});
    if (static_cast<int>(values[mallet]) == customMallet)
        copyInto(result, values, malletFigures);
    return result;
}

std::optional<LoudnessMatch::Goal> LoudnessMatch::goalOf(const ParameterValues& now,
                                                         int wheel) const noexcept {
    // A bow moves its place as fast as itself, whatever the material.
    if (now[matchLoudness] == 0 || bows(now))
        return std::nullopt;
    const auto values = valuesThatMatter(now);
    if (values == valuesThatMatter(withOwn(now, ownValues)))
        return std::nullopt;
    return Goal{.values = values, .wheel = strikes(now) ? HeldContacts::controllerAtRest : wheel};
}

double LoudnessMatch::gainDb(const Goal& goal) const noexcept {
    auto gains = predictedLoudness(phrase, withOwn(goal.values, ownValues), goal.wheel);
    const auto played = predictedLoudness(phrase, goal.values, goal.wheel);
    for (std::size_t k = 0; k < gains.size(); ++k)
        gains[k] -= played[k];
    const double mean =
        std::accumulate(gains.begin(), gains.end(), 0.0) / static_cast<double>(gains.size());
    if (!std::isfinite(mean))
        return 0;
    const double middle = gains[PhrasePrediction::middleVelocity];
    const double gain =
        std::clamp(mean, middle - maximumFromMiddleDb, middle + maximumFromMiddleDb);
    return std::clamp(gain, -largestGainDb, largestGainDb);
}

} // namespace idiophone
