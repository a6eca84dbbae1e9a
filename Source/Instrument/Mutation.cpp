#include "Instrument/Mutation.h"

#include "Instrument/HertzContact.h"
#include "Instrument/LoudnessMatch.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace idiophone {
namespace {

using enum ParameterId;

// Chosen, not derived: at full strength a damping or a hardness moves by a factor of three to six,
// so that a few mutations reach another instrument and one does not.
constexpr MutationStep steps[] = {
    {.parameter = fluidDamping, .step = 0.1, .lowest = 0.05, .highest = 200},
    {.parameter = viscoelasticDamping, .step = 0.08, .lowest = 0.001, .highest = 20},
    {.parameter = lossFactor, .step = 0.08, .lowest = 0, .highest = 0.05},
    {.parameter = malletHardness, .step = 0.15, .lowest = 2, .highest = 60000},
    {.parameter = malletMass, .step = 0.12, .lowest = 5, .highest = 120},
    {.parameter = malletRadius, .step = 0.1, .lowest = 5, .highest = 40},
    {.parameter = malletSpeed, .step = 0.05, .lowest = 1, .highest = 6},
    {.parameter = velocityCurve, .step = 0.05, .lowest = 1, .highest = 2.2},
    {.parameter = strikeAlong, .step = 0.2, .lowest = -90, .highest = 90},
    {.parameter = strikeAcross, .step = 0.2, .lowest = -90, .highest = 90},
    {.parameter = strikeSpread, .step = 0.05, .lowest = 0, .highest = 20},
    {.parameter = chatter, .step = 0.15, .lowest = 0, .highest = 60},
    {.parameter = radiation, .step = 0.2, .lowest = 0, .highest = 100},
    {.parameter = width, .step = 0.1, .lowest = 50, .highest = 150},
    {.parameter = releaseTime, .step = 0.1, .lowest = 0.02, .highest = 3},
    {.parameter = contactForce, .step = 0.1, .lowest = 0.5, .highest = 30},
    {.parameter = contactSpeed, .step = 0.1, .lowest = 0.2, .highest = 4},
    {.parameter = roughness, .step = 0.1, .lowest = 0.2, .highest = 5},
    {.parameter = rollCoupling, .step = 0.15, .lowest = 0, .highest = 100},
    {.parameter = motorSpeed, .step = 0.15, .lowest = 1, .highest = 9},
    {.parameter = motorDepth, .step = 0.15, .lowest = 0, .highest = 100},
};

constexpr double mostLouderDb = 6;
constexpr double anyRateHz = 48000; // both predictions are at the same

/// −1 to 1; the standard's distributions differ from library to library.
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

double moved(const MutationStep& row, double value, double strength, std::mt19937& random) {
    const auto& info = parameterInfo(row.parameter);
    const double place = info.toNormalised(value);
    const double lowest = std::min(info.toNormalised(row.lowest), place);
    const double highest = std::max(info.toNormalised(row.highest), place);
    double next = place + strength * row.step * nextRandom(random);
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

std::span<const MutationStep> mutationSteps() {
    return steps;
}

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
    for (const auto& row : steps)
        next.set(row.parameter, moved(row, next[row.parameter], std::min(strength, 1.0), random));

    LoudnessMatch match(instrument, preset.surface, anyRateHz, preset.parameters);
    const double louderDb = loudnessLufs(match, next) - loudnessLufs(match, now);
    if (std::isfinite(louderDb)) {
        const double wanted = now[level] + std::min(-louderDb, mostLouderDb);
        next.set(level, std::min(wanted, std::max(now[level], 0.0)));
    }
    return next;
}

} // namespace idiophone
