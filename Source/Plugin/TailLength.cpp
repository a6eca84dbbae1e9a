#include "Plugin/TailLength.h"

#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {

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
    const double slowest = slowestDecay((report.playedResizedKeys ? allKeys : ownKeys).load(),
                                        synthesisSettings(values), semitonesBelow);
    const double inRoom = values[room] > 0 ? values[roomDecay] * std::log10(65536) / 3 : 0;
    return std::min(stageSeconds + std::log(65536) / slowest + inRoom, maximumSeconds);
}

} // namespace idiophone
