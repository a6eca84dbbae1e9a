#include "Instrument/StrikeScheduler.h"

#include "Instrument/ContactTrain.h"
#include "Instrument/HeldContacts.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/SettingsOfParameters.h"
#include "Synth/LiveConditions.h"

namespace idiophone {
namespace {

using enum ParameterId;

constexpr std::size_t pendingCapacity = 1024; // 113 chattering strikes with modal pulses in 15 ms
constexpr std::size_t surfaceCapacity = 64;   // strikes on surfaces between two blocks of sound

} // namespace

StrikeScheduler::StrikeScheduler(const Instrument& played, std::uint64_t seed)
    : instrument(played), firstNumber(distantNumber(seed - 1)), strikeCount(firstNumber),
      pending(pendingCapacity) {
    surfaceStrikes.reserve(surfaceCapacity);
}

void StrikeScheduler::strikeKey(const Key& key,
                                int velocity,
                                int placeController,
                                const StrikeMoment& moment) {
    const auto number = strikeCount++;
    auto place = strikePlace(key.along, moment.values, number);
    place.along = HeldContacts::placeMoved(placeController, place.along);
    strike(static_cast<std::size_t>(key.slot), key.strip->between(place.along, place.across).point,
           velocity, key.mallet, number, moment);
}

bool StrikeScheduler::keep(const SurfaceStrike& strike) {
    if (surfaceStrikes.size() == surfaceCapacity)
        return false;
    surfaceStrikes.push_back(strike);
    return true;
}

void StrikeScheduler::strikeSurfaces(const StrikeMoment& moment) {
    for (const auto& [slot, point, velocity] : surfaceStrikes)
        strike(slot, point, velocity, instrument.mallet(slot), strikeCount++, moment);
    surfaceStrikes.clear();
}

void StrikeScheduler::strike(std::size_t slot,
                             const StrikePoint& point,
                             int velocity,
                             const KeyMallet& mallet,
                             std::uint32_t number,
                             const StrikeMoment& moment) {
    struckLast = velocity;
    const auto& struck = instrument.slots()[slot];
    const auto& synthesiser = moment.cell.synthesiser;
    auto values = moment.values;
    values.set(malletSpeed, moment.softness * values[malletSpeed]);
    if (const auto* part = instrument.part(slot))
        values = withPart(values, *part);
    const auto whole = malletStrike(point, velocity, mallet, values, struck);
    auto train = contactTrain(whole, mallet.scale, moment.values[chatter], number);
    if (moment.values[modalPulse] != 0) {
        const auto settings = synthesisSettings(moment.values);
        const double ratio =
            liveConditions(struck, settings, synthesiser.frequencyRatio(slot)).frequencyRatio();
        const auto modes =
            instrument.lowestModes(slot).atThickness(settings.thicknessRatio).moved(ratio);
        train = withModalPulses(train, modes.span());
    } else
        train = withFilledNulls(train);
    if (train.size() > pending.freeSpace()) {
        pending.strike(slot, whole, moment.sample, moment.cell);
        return;
    }
    for (const auto& contact : train)
        pending.schedule(slot, contact.strike, moment.cell.index,
                         moment.sample + contact.delaySeconds * synthesiser.sampleRateHz());
}

void StrikeScheduler::clear() {
    pending.clear();
    surfaceStrikes.clear();
}

void StrikeScheduler::reset() {
    clear();
    countFrom(0);
}

} // namespace idiophone
