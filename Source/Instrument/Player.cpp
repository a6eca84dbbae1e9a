#include "Instrument/Player.h"

#include "Instrument/ContactTrain.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/SettingsOfParameters.h"
#include "Instrument/SharedSurfaceProfile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double decibels60 = 6.907755278982137; // ln(1000)
constexpr double silencingSeconds = 0.02;        // T60 of "all sound off"
constexpr std::int64_t matchingCells = 16;       // between two predictions of loudness
constexpr float matchingShare = 0.15f;           // of the way to the matching gain in a cell: 10 ms
constexpr std::size_t pendingCapacity = 1024;    // 113 chattering blows with modal pulses in 15 ms

enum ControllerNumber {
    modulationController = 1,
    sustainController = 64,
    placeController = 74,
    allSoundOff = 120,
    resetControllers,
    allNotesOff = 123
};

std::vector<SynthesiserSlot> copySlots(const Instrument& instrument) {
    return {instrument.slots().begin(), instrument.slots().end()};
}

std::vector<LowestModes> lowestModesOf(const Instrument& instrument) {
    std::vector<LowestModes> modes;
    for (const auto& slot : instrument.slots())
        modes.emplace_back(*slot.object, slot.sizeRatio);
    return modes;
}

} // namespace

Player::Player(std::shared_ptr<const Instrument> instrument,
               double sampleRateHz,
               const Surface& surface,
               std::uint64_t seed,
               const ParameterValues& own)
    : playedInstrument(std::move(instrument)), synth(copySlots(*playedInstrument), sampleRateHz, 2),
      pending(pendingCapacity), lowestModes(lowestModesOf(*playedInstrument)),
      held(*playedInstrument, lowestModes, sharedSurfaceProfile(surface, sampleRateHz), seed),
      sampleRate(sampleRateHz), loudness(playedInstrument, surface), ownValues(own),
      matchedValues(own), slotHeld(playedInstrument->slots().size(), false),
      slotSilenced(playedInstrument->slots().size(), false) {}

void Player::process(const StereoSpan& output,
                     std::span<const MidiEvent> events,
                     const ParameterValues& parameters) {
    current = parameters;
    const int count = static_cast<int>(output.size());
    std::size_t next = 0;
    for (int position = 0; position < count;) {
        const auto due = next;
        while (next < events.size() && events[next].sampleOffset <= position)
            follow(events[next++]);
        if (cellPosition == cellSamples)
            beginCell();
        for (auto event = due; event < next; ++event)
            strikeFor(events[event]);

        int until = std::min(count, position + cellSamples - cellPosition);
        if (next < events.size())
            until = std::min(until, events[next].sampleOffset);
        strikePendingBefore(cellPosition + until - position);
        copyOut(output, position, until - position);
        cellPosition += until - position;
        position = until;
    }
    // Stamped at or beyond the end, as controllers handed over with an empty block are.
    while (next < events.size())
        follow(events[next++]);
}

// Keys, pedals and wheels are followed at their sample, so that a key struck again is down again by
// the next grid point; what follows for the sound happens there.
void Player::follow(const MidiEvent& event) {
    const int kind = event.bytes[0] & 0xf0;
    const int first = event.bytes[1] & 0x7f;
    const int second = event.bytes[2] & 0x7f;
    if (kind == 0x90 && second > 0)
        keyDown(first, second);
    else if (kind == 0x80 || kind == 0x90)
        keyUp(first);
    else if (kind == 0xa0)
        held.setPressure(first, second / 127.0);
    else if (kind == 0xb0)
        controller(first, second);
    else if (kind == 0xc0)
        programChange = first;
    else if (kind == 0xd0)
        held.setPressure(first / 127.0);
    else if (kind == 0xe0)
        bend = std::clamp((second * 128 + first - 8192) / 8191.0, -1.0, 1.0);
}

void Player::keyDown(int note, int velocity) {
    keysDown.set(static_cast<std::size_t>(note));
    if (!strikes(current))
        held.press(note, velocity / 127.0);
    if (const auto slot = playedInstrument->key(note).slot; slot >= 0)
        slotSilenced[static_cast<std::size_t>(slot)] = false;
}

void Player::keyUp(int note) {
    const auto index = static_cast<std::size_t>(note);
    if (sustainPedal && keysDown[index])
        keysSustained.set(index);
    keysDown.reset(index);
    held.release(note);
}

void Player::controller(int number, int value) {
    switch (number) {
    case modulationController:
        held.setSpeedController(value);
        break;
    case placeController:
        held.setPlaceController(value);
        break;
    case sustainController:
        sustainPedal = value >= 64;
        if (!sustainPedal)
            keysSustained.reset();
        break;
    case allSoundOff:
        std::fill(slotSilenced.begin(), slotSilenced.end(), true);
        pending.clear();
        held.stop();
        [[fallthrough]];
    case allNotesOff:
        held.releaseAll();
        keysDown.reset();
        keysSustained.reset();
        break;
    case resetControllers:
        sustainPedal = false;
        keysSustained.reset();
        bend = 0;
        held.resetControllers();
        break;
    default:
        break;
    }
}

void Player::strikeFor(const MidiEvent& event) {
    const int velocity = event.bytes[2] & 0x7f;
    if ((event.bytes[0] & 0xf0) != 0x90 || velocity == 0 || !strikes(current))
        return;
    const auto& key = playedInstrument->key(event.bytes[1]);
    if (key.slot < 0)
        return;
    const auto slot = static_cast<std::size_t>(key.slot);
    const auto& own = playedInstrument->slots()[slot].object->material;
    const auto number = strikeCount++;
    const auto place = strikePlace(key.along, current, number);
    const auto strike =
        malletStrike(playedInstrument->strip(key).at(place.along, place.across), velocity,
                     key.malletScale, current, surfaceCompliancePerPa(own, current));
    auto train = contactTrain(strike, key.malletScale, current[chatter], number);
    if (current[modalPulse] != 0) {
        const auto settings = synthesisSettings(current, bend * current[bendRange]);
        train = withModalPulses(train,
                                lowestModes[slot].moved(liveFrequencyRatio(own, settings)).span());
    }
    if (train.size() > pending.room()) {
        synth.strike(slot, strike, cellPosition, cell());
        return;
    }
    for (const auto& contact : train)
        schedule(slot, contact.delaySeconds, contact.strike);
}

void Player::schedule(std::size_t slot, double delaySeconds, const Strike& strike) {
    const double sample = cellPosition + delaySeconds * synth.sampleRateHz();
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
        synth.strike(next->slot, next->strike, next->sampleInCell, cell());
        pending.pop();
    }
}

void Player::beginCell() {
    const auto settings = synthesisSettings(current, bend * current[bendRange]);
    synth.setSettings(settings);
    updateDampers();
    synth.beginCell(cell());
    held.sound(current, settings, synth, cell());
    ++cellIndex;
    matchLoudness();
    cellPosition = 0;
}

/// A prediction costs a tenth of a millisecond, so it is made now and then, on the grid.
void Player::matchLoudness() {
    if (cellIndex % matchingCells == 0 && current != matchedValues) {
        matchedValues = current;
        const bool matches = current[ParameterId::matchLoudness] != 0;
        const double gainDb = matches ? loudness.gainDb(ownValues, current, sampleRate) : 0;
        matchingGain = static_cast<float>(std::pow(10, gainDb / 20));
    }
    gainAtCellStart = cellIndex == 0 ? matchingGain : gainAtCellEnd;
    gainAtCellEnd = gainAtCellStart + matchingShare * (matchingGain - gainAtCellStart);
    if (std::abs(matchingGain - gainAtCellEnd) < 1e-5f * matchingGain)
        gainAtCellEnd = matchingGain;
}

/// Copies what is next in the cell to the output, with the gain that matches loudness.
void Player::copyOut(const StereoSpan& output, int position, int count) const {
    for (int k = 0; k < count; ++k) {
        const auto from = static_cast<std::size_t>(cellPosition + k);
        const auto to = static_cast<std::size_t>(position + k);
        const float part = static_cast<float>(from + 1) / cellSamples;
        const float gain = gainAtCellStart + part * (gainAtCellEnd - gainAtCellStart);
        output.left[to] = gain * leftCell[from];
        output.right[to] = gain * rightCell[from];
    }
}

void Player::updateDampers() {
    slotHeld.assign(slotHeld.size(), current[letRing] != 0);
    const auto keys = keysDown | keysSustained;
    for (int note = 0; note < 128; ++note)
        if (const int slot = playedInstrument->key(note).slot;
            slot >= 0 && keys[static_cast<std::size_t>(note)])
            slotHeld[static_cast<std::size_t>(slot)] = true;
    for (std::size_t slot = 0; slot < slotHeld.size(); ++slot)
        synth.setDamping(slot, slotSilenced[slot] ? decibels60 / silencingSeconds
                               : slotHeld[slot]   ? 0
                                                  : decibels60 / current[releaseTime]);
}

void Player::reset() {
    synth.reset();
    leftCell.fill(0);
    rightCell.fill(0);
    cellPosition = cellSamples;
    cellIndex = -1;
    strikeCount = 0;
    matchedValues = ownValues;
    matchingGain = gainAtCellStart = gainAtCellEnd = 1;
    pending.clear();
    held.reset();
    keysDown.reset();
    keysSustained.reset();
    sustainPedal = false;
    bend = 0;
    programChange.reset();
    std::fill(slotSilenced.begin(), slotSilenced.end(), false);
}

bool Player::silent() const {
    const auto played = [this](const auto& samples) {
        return std::all_of(samples.begin() + cellPosition, samples.end(),
                           [](float x) { return x == 0; });
    };
    return synth.silent() && pending.empty() && held.silent() && played(leftCell) &&
           played(rightCell);
}

std::optional<int> Player::takeProgramChange() {
    return std::exchange(programChange, std::nullopt);
}

} // namespace idiophone
