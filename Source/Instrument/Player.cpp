#include "Instrument/Player.h"

#include "Instrument/DecayTime.h"
#include "Instrument/HandStrengths.h"
#include "Instrument/SettingsOfParameters.h"
#include "Instrument/SharedSurfaceProfile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double silencingSeconds = 0.02; // T60 of All Sound Off
constexpr float matchingShare = 0.15f;    // share of the way to the matching gain in a cell: 10 ms
constexpr std::size_t pendingCapacity = 1024; // 113 chattering strikes with modal pulses in 15 ms
constexpr std::size_t lateCapacity = 256;     // notes between two blocks of sound
constexpr std::size_t surfaceCapacity = 64;   // strikes on surfaces between two blocks of sound

std::vector<SynthesiserSlot> copySlots(const Instrument& instrument) {
    return {instrument.slots().begin(), instrument.slots().end()};
}

std::vector<LowestModes> lowestModesOf(const Instrument& instrument) {
    std::vector<LowestModes> modes;
    for (const auto& slot : instrument.slots())
        modes.emplace_back(*slot.object);
    return modes;
}

std::vector<KeyMallet> malletsOf(const Instrument& instrument) {
    std::vector<KeyMallet> mallets(instrument.slots().size());
    if (instrument.keyMap().kind == KeyMapKind::zones)
        return mallets; // all keys share the slot
    for (int note = 0; note < 128; ++note)
        if (const auto& key = instrument.key(note); key.slot >= 0)
            mallets[static_cast<std::size_t>(key.slot)] = key.mallet;
    return mallets;
}

bool has(const Instrument& instrument, std::size_t slot, const StrikePoint& point) {
    if (slot >= instrument.slots().size())
        return false;
    const auto rows = instrument.slots()[slot].object->shapeVertexCount();
    return std::ranges::all_of(point.shapeRows, [rows](std::int32_t row) {
        return row >= 0 && static_cast<std::size_t>(row) < rows;
    });
}

/// Returns the leading events up to a sample, from events in order of time.
std::span<const MidiEvent> dueAt(int sample, std::span<const MidiEvent> events) {
    const auto later = std::ranges::find_if(
        events, [sample](const MidiEvent& event) { return event.sampleOffset > sample; });
    return {events.begin(), later};
}

/// Returns the number of the first strike: 0 for the default seed, and far apart between seeds.
std::uint32_t firstStrike(std::uint64_t seed) {
    return static_cast<std::uint32_t>((seed - 1) * 0x9e3779b97f4a7c15u >> 32);
}

} // namespace

Player::Player(std::shared_ptr<const Instrument> instrument,
               double sampleRateHz,
               const Surface& surface,
               std::uint64_t seed,
               const ParameterValues& own)
    : playedInstrument(std::move(instrument)),
      synth(copySlots(*playedInstrument), sampleRateHz, playedInstrument->stage() ? 1 : 2),
      glide(cellSamples / sampleRateHz), firstStrikeNumber(firstStrike(seed)),
      strikeCount(firstStrikeNumber), pending(pendingCapacity),
      lowestModes(lowestModesOf(*playedInstrument)), mallets(malletsOf(*playedInstrument)),
      held(*playedInstrument, lowestModes, sharedSurfaceProfile(surface, sampleRateHz), seed),
      handScrape(*playedInstrument,
                 sharedSurfaceProfile(surface, sampleRateHz),
                 seed,
                 handStrengths(playedInstrument, surface, sampleRateHz, own)),
      loudness(playedInstrument, surface, sampleRateHz, own), motor(cellSamples / sampleRateHz),
      slotTuning(*playedInstrument, cellSamples / sampleRateHz),
      slotTouched(playedInstrument->slots().size(), false),
      slotHeld(playedInstrument->slots().size(), false),
      slotPressed(playedInstrument->slots().size(), 0) {
    if (playedInstrument->stage()) {
        performance = playedInstrument->stage()->makePlayer(sampleRateHz, seed);
        slotSamples.resize(synth.slotCount() * cellSamples);
        slotCells = cellsOfSlotsIn(slotSamples);
        remains.resize(slotSamples.size());
        remainsOfSlots = cellsOfSlotsIn(remains);
    } else {
        slotCells.assign(synth.slotCount(), cell());
        remains.resize(2 * cellSamples);
        const std::span samples(remains);
        remainsOfSlots.assign(synth.slotCount(),
                              {samples.first<cellSamples>(), samples.last<cellSamples>()});
    }
    late.reserve(lateCapacity);
    surfaceStrikes.reserve(surfaceCapacity);
}

void Player::process(const StereoSpan& output,
                     std::span<const MidiEvent> events,
                     const ParameterValues& parameters) {
    glide.setGoal(parameters);
    current = glide.values();
    bend.setParameters(current);
    const int count = static_cast<int>(output.size());
    const double beatsPerSample = tempo / 60 / synth.sampleRateHz();
    const auto placeAt = [this, beatsPerSample](int position) {
        return songPlace ? std::optional(*songPlace + position * beatsPerSample) : std::nullopt;
    };
    std::size_t next = 0;
    silencedSamples = 0;
    for (int position = 0; position < count;) {
        const auto due = dueAt(position, events.subspan(next));
        next += due.size();
        const auto striking = follow(due);
        if (cellPosition == cellSamples)
            beginCell(placeAt(position));
        else if (!performance && (!striking.empty() || !late.empty() || !surfaceStrikes.empty()))
            prepareStrikes();
        strikeWaiting();
        for (const auto& event : striking)
            strikeFor(event);

        int until = std::min(count, position + cellSamples - cellPosition);
        if (next < events.size())
            until = std::min(until, events[next].sampleOffset);
        if (!performance)
            strikePendingBefore(cellPosition + until - position);
        copyOut(output, position, until - position);
        cellPosition += until - position;
        position = until;
        if (isSilenced)
            silencedSamples = static_cast<std::size_t>(position);
    }
    songPlace = placeAt(count);
    // Events at or beyond the end, also those of an empty block: their notes strike at the first
    // sample of the next block.
    while (next < events.size()) {
        const auto due = dueAt(events[next].sampleOffset, events.subspan(next));
        next += due.size();
        for (const auto& event : follow(due))
            if (event.isNoteOn() && late.size() < lateCapacity)
                late.push_back(event);
    }
}

void Player::strikeSurface(const SurfaceStrike& strike) {
    if (!has(*playedInstrument, strike.slot, strike.point))
        return;
    playedLast = strike.slot;
    slotTouched[strike.slot] = strike.velocity > 0;
    if (strike.velocity <= 0 || surfaceStrikes.size() == surfaceCapacity)
        return;
    forgetSilenced();
    surfaceStrikes.push_back(strike);
}

void Player::scrapeSurface(const SurfaceTouch& touch) {
    if (!has(*playedInstrument, touch.slot, touch.point))
        return;
    playedLast = touch.slot;
    forgetSilenced();
    handScrape.touch(touch);
}

void Player::liftHands() {
    std::fill(slotTouched.begin(), slotTouched.end(), false);
    handScrape.lift();
}

void Player::setSilencedModes(const SilencedModes& silenced) {
    const auto slots = playedInstrument->slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const auto found = std::ranges::find(silenced.objects, slots[slot].object.get(),
                                             &SilencedModes::OfObject::object);
        if (found == silenced.objects.end())
            synth.setSilencedModes(slot, {});
        else
            synth.setSilencedModes(slot, found->isSilenced);
    }
}

SynthesisSettings Player::settingsNow() const {
    return synthesisSettings(current);
}

void Player::beginCell(std::optional<double> beats) {
    glide.advance();
    current = glide.values();
    synth.setSettings(settingsNow());
    slotTuning.apply(bend, synth);
    updateDampers();
    turnMotor(beats);
    soundCell(cell(), slotCells);
    addRemains();
    ++cellIndex;
    if (performance)
        playStage();
    updateGain();
    cellPosition = 0;
}

/// Within a cell: gives the new notes' slots their pitch and lifts their dampers before they
/// strike.
void Player::prepareStrikes() {
    slotTuning.applyToPlayed(bend, synth);
    updateDampers();
}

/// Adds ringing and held sounds to the cells. `mixed` is the cell of all slots if they share one.
void Player::soundCell(const CellOutput& mixed, std::span<const CellOutput> cellsOfSlots) {
    if (performance)
        synth.beginCell(cellsOfSlots);
    else
        synth.beginCell(mixed);
    held.sound(current, settingsNow(), synth, cellsOfSlots);
    handScrape.sound(current, mallets, synth, cellsOfSlots);
}

/// The first strike after All Sound Off lifts the damper. Fade the old sound out over one cell,
/// then drop it, so that it does not come back. That cell also lifts the damper before the strike
/// begins. On a second call in the same cell only strikes that have just begun ring; drop them
/// without a fade.
void Player::forgetSilenced() {
    if (!std::exchange(isSilenced, false))
        return;
    updateDampers();
    // Before the first cell nothing has sounded and there is no damper.
    if (cellIndex >= 0 && !std::exchange(hasRemains, true)) {
        synth.setTubeOpening({.start = motor.gain(), .end = motor.gain()});
        soundCell(remainsOfSlots.front(), remainsOfSlots);
        if (performance)
            performance->release(synth, remainsOfSlots);
    }
    synth.reset();
    held.forgetAll();
    handScrape.reset();
}

void Player::addRemains() {
    if (!std::exchange(hasRemains, false))
        return;
    const std::size_t cells = performance ? slotCells.size() : 1;
    for (std::size_t k = 0; k < cellSamples; ++k) {
        const double way = static_cast<double>(k + 1) / cellSamples;
        const auto gain = static_cast<float>((1 + std::cos(std::numbers::pi * way)) / 2);
        for (std::size_t slot = 0; slot < cells; ++slot)
            for (std::size_t c = 0; c < slotCells[slot].channels(); ++c)
                slotCells[slot][c][k] += gain * remainsOfSlots[slot][c][k];
    }
}

/// The ears process whole cells, so every strike in a cell must be known when it begins.
void Player::playStage() {
    performance->sound(cellIndex, synth, slotCells);
    strikePendingBefore(cellSamples);
    performance->hear(slotCells, cell());
}

void Player::setOffline(bool isOffline) noexcept {
    if (performance)
        performance->setOffline(isOffline);
}

void Player::waitForSimulation() noexcept {
    if (performance)
        performance->waitForSimulation();
}

void Player::pauseStage(bool isPaused) noexcept {
    if (performance)
        performance->setPaused(isPaused);
}

void Player::resetStage() noexcept {
    if (performance)
        performance->stop();
}

std::span<const PlacedImpact> Player::takeImpacts() noexcept {
    return performance ? performance->takeImpacts() : std::span<const PlacedImpact>();
}

std::uint32_t Player::performanceNumber() const noexcept {
    return performance ? performance->number() : 0;
}

std::span<const BodyPose> Player::bodyPoses() const noexcept {
    return performance ? performance->poses() : std::span<const BodyPose>();
}

std::int64_t Player::lateEvents() const noexcept {
    return performance ? performance->lateEvents() : 0;
}

void Player::prepare(const ParameterValues& parameters, int awaitedWheel) {
    loudness.prepare(parameters, awaitedWheel);
}

void Player::turnMotor(std::optional<double> beats) {
    if (const auto turns = beats && tempo > 0 ? motorTurnsAt(current, *beats) : std::nullopt)
        motor.keepTo(*turns, silent());
    const float before = motor.gain();
    const float after =
        motor.advance(motorTurnsPerSecond(current, tempo), current[motorDepth] / 100);
    synth.setTubeOpening({.start = before, .end = after});
}

/// Updates the matching gain once a cell, on the grid; its goal moves when a prediction is
/// complete.
void Player::updateGain() {
    loudness.advance(glide.goalValues());
    // The prediction covers mallet strikes only, not a stage.
    const auto goal = performance ? 1.0f : static_cast<float>(std::pow(10, loudness.gainDb() / 20));
    gainAtCellStart = cellIndex == 0 ? goal : gainAtCellEnd;
    gainAtCellEnd = cellIndex == 0 ? goal : gainAtCellEnd + matchingShare * (goal - gainAtCellEnd);
    if (std::abs(goal - gainAtCellEnd) < 1e-5f * goal)
        gainAtCellEnd = goal;
}

/// Copies the next part of the cell to the output, with its gain.
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
    slotHeld = slotTouched;
    if (const auto slot = handScrape.heldSlot())
        slotHeld[*slot] = true;
    if (current[letRing] != 0 || performance)
        slotHeld.assign(slotHeld.size(), true);
    auto keys = keysSustained | keysCaught;
    for (const auto& down : keysDown)
        keys |= down;
    std::fill(slotPressed.begin(), slotPressed.end(), 0.0f);
    const bool pressureDamps = strikes(current) && !performance;
    for (std::size_t note = 0; note < keys.size(); ++note) {
        const int key = playedInstrument->key(static_cast<int>(note)).slot;
        if (key < 0 || !keys[note])
            continue;
        const auto slot = static_cast<std::size_t>(key);
        slotHeld[slot] = true;
        if (pressureDamps)
            slotPressed[slot] = std::max(slotPressed[slot], notePressures[note]);
    }
    for (std::size_t slot = 0; slot < slotHeld.size(); ++slot) {
        const double share = slotHeld[slot] ? slotPressed[slot] * slotPressed[slot] : 1;
        synth.setDamping(slot, isSilenced ? decayPerSecond(silencingSeconds)
                                          : share * decayPerSecond(current[releaseTime]));
    }
}

std::optional<std::size_t> Player::takeSilenced() {
    if (!std::exchange(allSoundOffCame, false) && silencedSamples == 0)
        return std::nullopt;
    return silencedSamples;
}

} // namespace idiophone
