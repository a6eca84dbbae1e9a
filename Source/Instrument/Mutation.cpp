#include "Instrument/Mutation.h"

#include "Instrument/ContactLaw.h"
#include "Instrument/LoudnessMatch.h"
#include "Instrument/MalletStrike.h"
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

ParameterValues withPlayedMaterial(const ParameterValues& now, const ModalObject& object) {
    if (static_cast<int>(now[material]) == customMaterial)
        return now;
    const auto* chosen = chosenLibraryMaterial(now);
    return withCustomMaterial(now, chosen != nullptr ? *chosen : object.material);
}

ParameterValues withPlayedMallet(const ParameterValues& now, const ModalObject& object) {
    const auto* chosen = chosenMallet(now);
    if (chosen == nullptr)
        return now;
    const double compliance = surfaceCompliancePerPa(object.material, now);
    return withCustomMallet(now, *chosen, contactModulusPa(*chosen, compliance));
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

double loudnessLufs(LoudnessMatch& match, const ParameterValues& values) {
    match.prepare(values);
    return match.predictedLufs(values)[PhrasePrediction::middleVelocity] + match.gainDb();
}

} // namespace

ParameterValues mutated(const ParameterValues& now,
                        const std::shared_ptr<const Instrument>& instrument,
                        const Preset& preset,
                        double strength,
                        std::uint32_t seed) {
    if (instrument == nullptr || instrument->slots().empty() || !(strength > 0))
        return now;
    const auto& object = *instrument->slots().front().object;
    auto next = withPlayedMaterial(withPlayedMallet(now, object), object);
    std::mt19937 random(seed);
    for (const auto& info : parameterTable())
        if (info.mutation.step > 0)
            next.set(info.parameter,
                     moved(info, next[info.parameter], std::min(strength, 1.0), random));

    LoudnessMatch match(instrument, preset.surface, anyRateHz, preset.parameters);
    const double louderDb = loudnessLufs(match, next) - loudnessLufs(match, now);
    if (std::isfinite(louderDb)) {
        const double wanted = now[level] + std::min(-louderDb, maximumLouderDb);
        next.set(level, std::min(wanted, std::max(now[level], 0.0)));
    }
    return next;
}

} // namespace idiophone
