#include "Instrument/SlotTuning.h"

#include "Instrument/ParameterGlide.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace idiophone {
namespace {

constexpr double smallestStep = 1e-3; // in semitones; a smaller step is not heard

} // namespace

SlotTuning::SlotTuning(const Instrument& playedInstrument, double secondsPerCell)
    : instrument(playedInstrument), glideShare(ParameterGlide::fractionPerCell(secondsPerCell)),
      keysHaveObjects(instrument.keysHaveObjects()), slots(instrument.slots().size()) {
    for (int note = 0; note < KeyTuning::notes; ++note)
        for (const Key& key : instrument.keysOf(note))
            if (followsKey(key))
                slots[static_cast<std::size_t>(key.slot)].note = note;
}

bool SlotTuning::followsKey(const Key& key) const noexcept {
    return key.slot >= 0 && instrument.followsKey(static_cast<std::size_t>(key.slot));
}

bool SlotTuning::sounds(int note) const noexcept {
    const Key& key = instrument.key(note);
    return key.slot >= 0 && !(followsKey(key) && tuning.unmapped[static_cast<std::size_t>(note)]);
}

double SlotTuning::semitonesBelowEqual() const noexcept {
    double below = 0;
    for (const auto& slot : slots)
        below = std::max(below, -slot.tuned);
    return below;
}

void SlotTuning::noteOn(int note) noexcept {
    if (instrument.stage() && !keysHaveObjects)
        return; // the note has no slot
    for (const Key& key : instrument.keysOf(note))
        if (key.slot >= 0) {
            auto& slot = slots[static_cast<std::size_t>(key.slot)];
            slot.note = note;
            slot.bendsAtOnce = true;
        }
}

void SlotTuning::apply(const PitchBend& bend, Synthesiser& synthesiser) noexcept {
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        apply(slot, bend, synthesiser);
}

void SlotTuning::applyToPlayed(const PitchBend& bend, Synthesiser& synthesiser) noexcept {
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
        if (slots[slot].bendsAtOnce)
            apply(slot, bend, synthesiser);
}

void SlotTuning::apply(std::size_t slot, const PitchBend& bend, Synthesiser& synthesiser) noexcept {
    auto& [note, tuned, bent, shifted, bendsAtOnce, semitones] = slots[slot];
    double goal = bend.commonSemitones(note);
    if (note >= 0) {
        goal += bend.ownSemitones(note);
        if (const auto index = static_cast<std::size_t>(note);
            instrument.followsKey(slot) && !tuning.unmapped[index])
            tuned = tuning.semitonesFromEqual[index];
    }
    const double distance = goal - bent;
    const bool isThere = std::exchange(bendsAtOnce, false) || std::abs(distance) <= smallestStep;
    bent = isThere ? goal : bent + glideShare * distance;
    const double wanted = tuned + bent + shifted;
    if (wanted == semitones)
        return;
    semitones = wanted;
    synthesiser.setFrequencyRatio(slot, std::exp2(wanted / 12));
}

void SlotTuning::reset() noexcept {
    for (auto& slot : slots)
        slot.bendsAtOnce = true;
}

} // namespace idiophone
