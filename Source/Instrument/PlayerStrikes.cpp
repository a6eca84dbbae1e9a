#include "Instrument/ContactTrain.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/Player.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <array>
#include <cmath>

// The blows: from a key or a place to the contacts that the synthesiser strikes at their samples.

namespace idiophone {

using enum ParameterId;

void Player::strikeFor(const MidiEvent& event) {
    if (!event.isNoteOn() || (!strikes(current) && !performance))
        return;
    const int velocity = event.bytes[2] & 0x7f;
    const auto& key = playedInstrument->key(event.bytes[1]);
    if (!slotTuning.sounds(event.bytes[1] & 0x7f))
        return;
    if (performance) {
        const int softened = std::max(1, static_cast<int>(std::lround(softness * velocity)));
        performance->cue(event.bytes[1] & 0x7f, softened, cellIndex, cellPosition);
        return;
    }
    const auto number = strikeCount++;
    auto place = strikePlace(key.along, current, number);
    place.along = held.placeMoved(event.bytes[0] & 0x0f, place.along);
    strikeAt(static_cast<std::size_t>(key.slot),
             playedInstrument->strip(key).between(place.along, place.across).point, velocity,
             key.malletScale, number);
}

/// What came between two blocks of sound.
void Player::strikeWaiting() {
    for (const auto& event : late)
        strikeFor(event);
    late.clear();
    for (const auto& strike : surfaceStrikes)
        strikeAt(strike.slot, strike.point, strike.velocity, malletScales[strike.slot],
                 strikeCount++);
    surfaceStrikes.clear();
}

void Player::strikeAt(std::size_t slot,
                      const StrikePoint& point,
                      int velocity,
                      double malletScale,
                      std::uint32_t number) {
    const auto& own = playedInstrument->slots()[slot].object->material;
    auto softened = current;
    softened.set(malletSpeed, softness * current[malletSpeed]);
    const auto strike =
        malletStrike(point, velocity, malletScale, softened, surfaceCompliancePerPa(own, current));
    auto train = contactTrain(strike, malletScale, current[chatter], number);
    if (current[modalPulse] != 0) {
        const double ratio = synth.frequencyRatio(slot) * liveFrequencyRatio(own, settingsNow());
        train = withModalPulses(train, lowestModes[slot].moved(ratio).span());
    }
    if (train.size() > pending.room()) {
        strikeNow(slot, strike, cellPosition);
        return;
    }
    for (const auto& contact : train)
        schedule(slot, nextStrikeSample() + contact.delaySeconds * synth.sampleRateHz(),
                 contact.strike);
}

/// The first sample of the cell begun last, or beyond it, at which a blow is still heard.
double Player::nextStrikeSample() const {
    return performance ? cellSamples : cellPosition;
}

/// `sample` counts from the start of the cell begun last.
void Player::schedule(std::size_t slot, double sample, const Strike& strike) {
    const double cells = std::floor(sample / cellSamples);
    pending.add({.cell = cellIndex + static_cast<std::int64_t>(cells),
                 .sampleInCell = sample - cells * cellSamples,
                 .slot = slot,
                 .strike = strike});
}

// In order of time and before their samples are played: so the order of strikes, and with it every
// bit, is the same for all block sizes.
void Player::strikePendingBefore(double sampleInCell) {
    for (const auto* next = pending.next();
         next != nullptr && next->cell == cellIndex && next->sampleInCell < sampleInCell;
         next = pending.next()) {
        const auto due = *next;
        pending.pop();
        strikeNow(due.slot, due.strike, due.sampleInCell);
    }
}

/// An object has room for so many contacts at a time. A pulse beyond comes as ideal impulses, which
/// need no room: as its values at a quarter, the half and three quarters of its time, which have
/// its spectrum up to 2/T and are too bright above.
void Player::strikeNow(std::size_t slot, const Strike& strike, double sampleInCell) {
    if (synth.strike(slot, strike, sampleInCell, slotCells[slot]))
        return;
    auto impulse = strike;
    impulse.durationSeconds = 0;
    constexpr std::array shares{0.25f, 0.5f, 0.25f};
    if (pending.room() < shares.size()) {
        synth.strike(slot, impulse, sampleInCell, slotCells[slot]);
        return;
    }
    for (std::size_t k = 0; k < shares.size(); ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            impulse.impulseNewtonSeconds[axis] = shares[k] * strike.impulseNewtonSeconds[axis];
        const double delaySamples =
            0.25 * static_cast<double>(k + 1) * strike.durationSeconds * synth.sampleRateHz();
        schedule(slot, sampleInCell + delaySamples, impulse);
    }
}

} // namespace idiophone
