#include "Instrument/Mutation.h"

#include "Instrument/LoudnessMatch.h"
#include "Instrument/Mallet.h"
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
    {fluidDamping, 0.1, 0.05, 200}, {viscoelasticDamping, 0.08, 0.001, 20},
    {lossFactor, 0.08, 0, 0.05},    {malletHardness, 0.15, 2, 60000},
    {malletMass, 0.12, 5, 120},     {malletRadius, 0.1, 5, 40},
    {malletSpeed, 0.05, 1, 6},      {velocityCurve, 0.05, 1, 2.2},
    {strikeAlong, 0.2, -90, 90},    {strikeAcross, 0.2, -90, 90},
    {strikeSpread, 0.05, 0, 20},    {chatter, 0.15, 0, 60},
    {radiation, 0.2, 0, 100},       {width, 0.1, 50, 150},
    {releaseTime, 0.1, 0.02, 3},    {contactForce, 0.1, 0.5, 30},
    {contactSpeed, 0.1, 0.2, 4},    {roughness, 0.1, 0.2, 5},
    {rollCoupling, 0.15, 0, 100},   {motorSpeed, 0.15, 1, 9},
    {motorDepth, 0.15, 0, 100},
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

ParameterValues withPlayedMallet(ParameterValues now, const ModalObject& object) {
    const int index = static_cast<int>(now[mallet]) - firstRackMallet;
    const auto rack = malletRack();
    if (index < 0 || index >= static_cast<int>(rack.size()))
        return now;
    const auto& chosen = rack[static_cast<std::size_t>(index)];
    const double contactPa = contactModulusPa(chosen, surfaceCompliancePerPa(object.material, now));
    now.set(mallet, customMallet);
    now.set(malletHardness, contactPa / 1e6);
    now.set(malletMass, chosen.massKg * 1e3);
    now.set(malletRadius, chosen.headRadiusMetres * 1e3);
    return now;
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
