#include "Plugin/TailLength.h"

#include "Instrument/SettingsOfParameters.h"
#include "Parameters/ModulationTable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

/// Returns the slowest decay [1/s] to which the routes of modulation, one after the other, can move
/// that of the values. `decayOf` returns the decay of values.
double slowestModulated(ParameterValues values, const auto& decayOf) noexcept {
    double slowest = decayOf(values);
    const ActiveRoutes routes(values);
    for (const auto& route : routes.all()) {
        const auto range = modulatedRange(values, route.target);
        for (const double end : {range.lowest, range.highest}) {
            auto moved = values;
            moved.set(route.target, end);
            if (const double decay = decayOf(moved); decay < slowest) {
                slowest = decay;
                values = moved;
            }
        }
    }
    return slowest;
}

} // namespace

void TailLength::SharedBounds::store(const DecayBounds& bounds) noexcept {
    std::ranges::copy(std::bit_cast<Values>(bounds), shared.begin());
}

DecayBounds TailLength::SharedBounds::load() const noexcept {
    Values values;
    std::ranges::copy(shared, values.begin());
    return std::bit_cast<DecayBounds>(values);
}

void TailLength::setInstrument(std::shared_ptr<const Instrument> loaded) {
    instrument = std::move(loaded);
    ownKeys.store(decayBounds(*instrument, RingingKeys::own));
    allKeys.store(decayBounds(*instrument));
    stageSeconds = instrument->stage() ? instrument->stage()->lengthSeconds() : 0;
    followTuning();
}

void TailLength::setTuning(const KeyTuning& keys) noexcept {
    tuning = keys;
    followTuning();
}

void TailLength::followTuning() noexcept {
    if (instrument != nullptr)
        semitonesBelowEqual = idiophone::semitonesBelowEqual(*instrument, tuning);
}

double TailLength::seconds(const ParameterValues& values,
                           const EngineReport& report) const noexcept {
    using enum ParameterId;
    // Before the first callback the player does not know tunings and bend ranges.
    const double bends = values[bendRange] + (values[mpe] != 0 ? values[mpeBendRange] : 0);
    const double semitonesBelow =
        std::max(bends + semitonesBelowEqual.load(), report.semitonesBelowEqual.load());
    const auto bounds = (report.playedResizedKeys ? allKeys : ownKeys).load();
    const double slowest = slowestModulated(values, [&](const ParameterValues& moved) {
        return slowestDecay(bounds, synthesisSettings(moved), semitonesBelow);
    });
    const double inRoom = values[room] > 0 ? values[roomDecay] * std::log10(65536) / 3 : 0;
    return std::min(stageSeconds + std::log(65536) / slowest + inRoom, maximumSeconds);
}

} // namespace idiophone
