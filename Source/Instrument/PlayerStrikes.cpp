#include "Instrument/ContactTrain.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/Player.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>

// The part of Player that turns a key or a place into contacts at their samples.

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
        performance->startNote(event.bytes[1] & 0x7f, softened, cellIndex, cellPosition);
        return;
    }
    const auto number = strikeCount++;
    auto place = strikePlace(key.along, current, number);
    place.along = held.placeMoved(event.bytes[0] & 0x0f, place.along);
    strikeAt(static_cast<std::size_t>(key.slot),
             playedInstrument->strip(key).between(place.along, place.across).point, velocity,
             key.mallet, number);
}

/// Strikes events that came between two blocks of sound.
void Player::strikeWaiting() {
    for (const auto& event : late)
        strikeFor(event);
    late.clear();
    for (const auto& strike : surfaceStrikes)
        strikeAt(strike.slot, strike.point, strike.velocity, mallets[strike.slot], strikeCount++);
    surfaceStrikes.clear();
}

void Player::strikeAt(std::size_t slot,
                      const StrikePoint& point,
                      int velocity,
                      const KeyMallet& mallet,
                      std::uint32_t number) {
    const auto& struck = playedInstrument->slots()[slot];
    auto softened = current;
    softened.set(malletSpeed, softness * current[malletSpeed]);
    const auto strike = malletStrike(point, velocity, mallet, softened, struck);
    auto train = contactTrain(strike, mallet.scale, current[chatter], number);
    if (current[modalPulse] != 0) {
        const auto settings = settingsNow();
        const double ratio =
            liveConditions(playedInstrument->slots()[slot], settings, synth.frequencyRatio(slot))
                .frequencyRatio();
        const auto modes = lowestModes[slot].atThickness(settings.thicknessRatio).moved(ratio);
        train = withModalPulses(train, modes.span());
    } else
        train = withFilledNulls(train);
    if (train.size() > pending.room()) {
        pending.strike(slot, strike, cellPosition, begunCell());
        return;
    }
    for (const auto& contact : train)
        schedule(slot, nextStrikeSample() + contact.delaySeconds * synth.sampleRateHz(),
                 contact.strike);
}

/// Returns the first sample, from the start of the newest cell, at which a strike can still sound.
double Player::nextStrikeSample() const {
    return performance ? cellSamples : cellPosition;
}

/// `sample` counts from the start of the newest cell.
void Player::schedule(std::size_t slot, double sample, const Strike& strike) {
    pending.schedule(slot, strike, cellIndex, sample);
}

// Strikes act in order of time before their samples are played. So their order, and every bit of
// the output, is the same for all block sizes.
void Player::strikePendingBefore(double sampleInCell) {
    pending.strikeBefore(sampleInCell, begunCell());
}

} // namespace idiophone
