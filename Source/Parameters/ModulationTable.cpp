#include "Parameters/ModulationTable.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using enum ParameterId;

// Append only: states store the position.
constexpr std::array targets{hardness,
                             strikeAlong,
                             strikeAcross,
                             strikeSpread,
                             malletHardness,
                             malletMass,
                             malletRadius,
                             malletExponent,
                             malletSpeed,
                             malletFollow,
                             chatter,
                             tune,
                             releaseTime,
                             decay,
                             size,
                             thickness,
                             imperfection,
                             radiation,
                             youngsModulus,
                             density,
                             fluidDamping,
                             lossFactor,
                             viscoelasticDamping,
                             contactForce,
                             contactSpeed,
                             roughness,
                             rollCoupling,
                             motorSpeed,
                             motorDepth,
                             inputDrive,
                             level,
                             lfo1Rate,
                             lfo2Rate,
                             modulation1Amount,
                             modulation2Amount,
                             modulation3Amount,
                             modulation4Amount,
                             modulation5Amount,
                             modulation6Amount,
                             modulation7Amount,
                             modulation8Amount};

static_assert(targets[noteTargetCount - 1] == releaseTime);

constexpr std::array<double, 11> syncLengths{0, 16,      8,   4,       2,   4.0 / 3,
                                             1, 2.0 / 3, 0.5, 1.0 / 3, 0.25};

} // namespace

bool isBipolar(ModulationSource source) noexcept {
    using enum ModulationSource;
    return source == lfo1 || source == lfo2 || source == key || source == random;
}

double lfoSyncBeats(int choice) {
    const auto index = static_cast<std::size_t>(std::max(choice, 0));
    return index < syncLengths.size() ? syncLengths[index] : 0;
}

std::span<const ParameterId> modulationTargets() noexcept {
    return targets;
}

int modulationTargetChoice(ParameterId parameter) noexcept {
    const auto found = std::ranges::find(targets, parameter);
    return found == targets.end() ? 0 : static_cast<int>(found - targets.begin()) + 1;
}

std::optional<std::size_t> noteTargetIndex(ParameterId parameter) noexcept {
    const auto ofNotes = noteTargets();
    const auto found = std::ranges::find(ofNotes, parameter);
    return found == ofNotes.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - ofNotes.begin()));
}

ActiveRoutes::ActiveRoutes(const ParameterValues& values) noexcept {
    for (std::size_t number = 0; number < routeCount; ++number) {
        const auto& route = modulationRoutes[number];
        const auto source = static_cast<ModulationSource>(values[route.source]);
        const auto target = static_cast<std::size_t>(values[route.target]);
        if (source != ModulationSource::none && target > 0)
            routes[count++] = {.number = number,
                               .source = source,
                               .target = targets[target - 1],
                               .amount = values[route.amount] / 100};
    }
    // Routes without an effect cost nothing.
    const auto given = *this;
    const auto acting = std::remove_if(
        routes.begin(), routes.begin() + static_cast<std::ptrdiff_t>(count),
        [&](const auto& route) {
            return route.amount == 0 && !given.moves(modulationRoutes[route.number].amount);
        });
    count = static_cast<std::size_t>(acting - routes.begin());
}

bool ActiveRoutes::moves(ParameterId target) const noexcept {
    return std::ranges::any_of(all(), [=](const auto& route) { return route.target == target; });
}

bool ActiveRoutes::uses(ModulationSource source) const noexcept {
    return std::ranges::any_of(all(), [=](const auto& route) { return route.source == source; });
}

/// An amount's range is twice the full amount. Amounts of routes to amounts stay as they are.
double ActiveRoutes::amountOf(const ActiveRoute& route, const Inputs& inputs) const noexcept {
    double amount = route.amount;
    for (const auto& other : all())
        if (other.target == modulationRoutes[route.number].amount)
            amount += 2 * other.amount * inputs[other.number];
    return std::clamp(amount, -1.0, 1.0);
}

double ActiveRoutes::moved(ParameterId target,
                           double base,
                           const Inputs& inputs,
                           double share) const noexcept {
    double offset = share;
    for (const auto& route : all())
        if (route.target == target)
            offset += amountOf(route, inputs) * inputs[route.number];
    if (offset == 0)
        return base;
    const auto& info = parameterInfo(target);
    return info.fromNormalised(info.toNormalised(base) + offset);
}

ModulatedRange modulatedRange(const ParameterValues& values, ParameterId target) noexcept {
    const ActiveRoutes routes(values);
    double below = 0, above = 0;
    for (const auto& route : routes.all()) {
        if (route.target != target)
            continue;
        const bool swings = routes.moves(modulationRoutes[route.number].amount);
        const double reach = swings ? 1 : route.amount;
        const bool both = swings || isBipolar(route.source);
        above += both ? std::abs(reach) : std::max(reach, 0.0);
        below += both ? std::abs(reach) : std::max(-reach, 0.0);
    }
    const auto& info = parameterInfo(target);
    const double base = values[target], place = info.toNormalised(base);
    return {below > 0 ? info.fromNormalised(place - below) : base,
            above > 0 ? info.fromNormalised(place + above) : base};
}

} // namespace idiophone
