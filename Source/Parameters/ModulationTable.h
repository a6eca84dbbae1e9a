// The sources and targets of modulation, and the parameters that say which source moves which
// target. Independent of notes and time.
#pragma once

#include "Parameters/ParameterTable.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace idiophone {

/// Choices of a route's source. All are 0 to 1, and some −1 to 1 (isBipolar).
enum class ModulationSource : std::size_t {
    none,
    lfo1,
    lfo2,
    envelope,
    velocity,
    key,      ///< −1 to 1, 0 at middle C, five octaves to either side
    pressure, ///< of the key or channel
    wheel,    ///< 0 before it moves
    random,   ///< another value for each note and each route
    count
};

/// Whether the source reaches from −1 to 1.
bool isBipolar(ModulationSource source) noexcept;

/// Choices of an LFO's shape. All but random begin a swing as a sine does, or at its highest.
enum class LfoShape { sine, triangle, square, rising, falling, random };

struct LfoParameters {
    ParameterId rate, sync, shape, perNote;
};
inline constexpr std::array lfoParameters{
    LfoParameters{ParameterId::lfo1Rate, ParameterId::lfo1Sync, ParameterId::lfo1Shape,
                  ParameterId::lfo1PerNote},
    LfoParameters{ParameterId::lfo2Rate, ParameterId::lfo2Sync, ParameterId::lfo2Shape,
                  ParameterId::lfo2PerNote}};

/// Returns the beats of one swing for an LFO's sync choice, 0 for the free one.
double lfoSyncBeats(int choice);

/// The parameters of one route from a source to a target.
struct ModulationRoute {
    ParameterId source, target, amount;
};
inline constexpr std::size_t routeCount = 8;
inline constexpr std::array<ModulationRoute, routeCount> modulationRoutes{{
#define ROUTE(number)                                                                              \
    {ParameterId::modulation##number##Source, ParameterId::modulation##number##Target,             \
     ParameterId::modulation##number##Amount}
    ROUTE(1),
    ROUTE(2),
    ROUTE(3),
    ROUTE(4),
    ROUTE(5),
    ROUTE(6),
    ROUTE(7),
    ROUTE(8),
#undef ROUTE
}};

/// Returns the parameters that a route can move, in the order of its choices from 1 on; 0 is none.
std::span<const ParameterId> modulationTargets() noexcept;
/// Returns the choice of a target, or 0 if modulation cannot move the parameter.
int modulationTargetChoice(ParameterId parameter) noexcept;
/// The first of the targets, which every note has for itself.
inline constexpr std::size_t noteTargetCount = 13;
inline std::span<const ParameterId> noteTargets() noexcept {
    return modulationTargets().first(noteTargetCount);
}
/// Returns the index of a parameter in noteTargets().
std::optional<std::size_t> noteTargetIndex(ParameterId parameter) noexcept;

/// A route with a source and a target. Its amount is a share of the target's range, −1 to 1.
struct ActiveRoute {
    std::size_t number = 0; ///< index into modulationRoutes
    ModulationSource source = ModulationSource::none;
    ParameterId target = ParameterId::hardness;
    double amount = 0;
};

/// The active routes of some values, and their arithmetic. Plain data; any thread, also the audio
/// thread.
class ActiveRoutes {
public:
    /// The value of each route's source.
    using Inputs = std::array<double, routeCount>;

    ActiveRoutes() = default;
    explicit ActiveRoutes(const ParameterValues& values) noexcept;

    std::span<const ActiveRoute> all() const noexcept { return std::span(routes).first(count); }
    bool empty() const noexcept { return count == 0; }
    bool moves(ParameterId target) const noexcept;
    bool uses(ModulationSource source) const noexcept;

    /// Returns the value to which the routes move `base`: by the sum of each amount times its
    /// input, and by `share` of the range, on the parameter's own scale, within its range. First,
    /// routes to the amounts of others move these.
    double
    moved(ParameterId target, double base, const Inputs& inputs, double share = 0) const noexcept;

private:
    double amountOf(const ActiveRoute& route, const Inputs& inputs) const noexcept;

    std::array<ActiveRoute, routeCount> routes{};
    std::size_t count = 0;
};

/// The lowest and highest value that the sources can give a target, in its unit.
struct ModulatedRange {
    double lowest = 0, highest = 0;
};
ModulatedRange modulatedRange(const ParameterValues& values, ParameterId target) noexcept;

} // namespace idiophone
