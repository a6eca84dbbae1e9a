#include "Instrument/Mutation.h"

#include "Instrument/LoudnessMatch.h"
#include "Instrument/PhrasePrediction.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double maximumLouderDb = 6;
constexpr double anyRateHz = 48000; // any rate, but the same for both predictions

/// Returns −1 to 1. The standard's distributions differ from library to library.
double nextRandom(std::mt19937& random) {
    return 2 * (static_cast<double>(random()) / 4294967295.0) - 1;
}

double moved(const ParameterInfo& info, double value, double strength, std::mt19937& random) {
    const auto& range = info.mutation;
    const double place = info.toNormalised(value);
    const double lowest = std::min(info.toNormalised(range.lowest), place);
    const double highest = std::max(info.toNormalised(range.highest), place);
    double next = place + strength * range.step * nextRandom(random);
    if (next < lowest)
        next = 2 * lowest - next;
    if (next > highest)
        next = 2 * highest - next;
    return info.fromNormalised(std::clamp(next, lowest, highest));
}

} // namespace

ParameterValues mutated(const ParameterValues& now,
                        const std::shared_ptr<const Instrument>& instrument,
                        const Preset& preset,
                        double strength,
                        std::uint32_t seed) {
    if (instrument == nullptr || instrument->slots().empty() || !(strength > 0))
        return now;
    const auto& own = instrument->slots().front().object->material;
    auto next = effectiveFigures(now, &own);
    for (const auto& choice : figureChoices)
        next.set(choice.choice, choice.custom);
    std::mt19937 random(seed);
    for (const auto& info : parameterTable())
        if (info.mutation.step > 0)
            next.set(info.parameter,
                     moved(info, next[info.parameter], std::min(strength, 1.0), random));

    const Phrase phrase(instrument, preset.surface, anyRateHz);
    const LoudnessMatch match(phrase, preset.parameters);
    const auto matchedLufs = [&](const ParameterValues& values) {
        return predictedLufs(phrase, values) + match.gainDb(values);
    };
    const double louderDb = matchedLufs(next) - matchedLufs(now);
    if (std::isfinite(louderDb)) {
        const double wanted = now[level] + std::min(-louderDb, maximumLouderDb);
        next.set(level, std::min(wanted, std::max(now[level], 0.0)));
    }
    return next;
}

} // namespace idiophone
