#include "Instrument/Player.h"

#include "Instrument/HandStrengths.h"
#include "Instrument/InputStrengths.h"
#include "Instrument/MidiControllers.h"
#include "Instrument/PlayedTime.h"
#include "Instrument/SettingsOfParameters.h"
#include "Synth/SharedSurfaceProfile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr std::size_t lateCapacity = 256; // notes between two blocks of sound

std::unique_ptr<CellStrategy> cellStrategy(StagePlayer* performance) {
    if (performance == nullptr)
        return std::make_unique<MalletCells>();
    return std::make_unique<StageCells>(*performance);
}

} // namespace

Player::Player(std::shared_ptr<const Instrument> instrument,
               double sampleRateHz,
               const Surface& surface,
               std::uint64_t seed,
               const ParameterValues& own)
    : playedInstrument(std::move(instrument)),
      performance(playedInstrument->stage()
                      ? playedInstrument->stage()->makePlayer(sampleRateHz, seed)
                      : nullptr),
      glide(cellSamples / sampleRateHz),
      held(*playedInstrument, sharedSurfaceProfile(surface, sampleRateHz), seed),
      hand(*playedInstrument,
           sharedSurfaceProfile(surface, sampleRateHz),
           seed,
           handStrengths({playedInstrument, surface, sampleRateHz}, own)),
      inputForce(*playedInstrument,
                 sampleRateHz,
                 inputStrengths({playedInstrument, surface, sampleRateHz}, own),
                 HandScrape::firstFreeForce),
      keys(held), modulation(glide, keys, cellSamples / sampleRateHz, seed),
      slotTuning(*playedInstrument, cellSamples / sampleRateHz),
      slotModulation(playedInstrument->slots().size()), scheduler(*playedInstrument, seed),
      renderer(*playedInstrument,
               sampleRateHz,
               cellStrategy(performance.get()),
               held,
               hand,
               inputForce) {
    if (!performance)
        loudness = std::make_shared<MatchedGain>(
            LoudnessMatch(Phrase(playedInstrument, surface, sampleRateHz), own));
    lateNotes.reserve(lateCapacity);
}

void Player::prepare(const ParameterValues& parameters, int pendingWheel) {
    renderer.prepare(parameters, keys);
    if (loudness)
        loudness->follow(parameters, pendingWheel, true);
}

void Player::setOffline(bool isOffline) noexcept {
    mayWait = isOffline;
    stage().setOffline(isOffline);
}

void Player::process(std::span<const StereoSpan> outputs,
                     std::span<const MidiEvent> events,
                     const ParameterValues& parameters,
                     std::span<const float> input) {
    if (!input.empty())
        inputForce.connect();
    glide.setGoal(parameters);
    keys.bend().setParameters(glide.values());
    renderer.connect(connectedOutputs(outputs));
    const int count = static_cast<int>(outputs.front().size());
    const double beatsPerSample = tempo / 60 / synthesiser().sampleRateHz();
    const auto placeAt = [this, beatsPerSample](int position) {
        return songPlace ? std::optional(*songPlace + position * beatsPerSample) : std::nullopt;
    };
    silencedSamples = 0;
    for (int position = 0; position < count;) {
        const auto due = dueAt(position, events);
        events = events.subspan(due.size());
        const auto notes = follow(due);
        if (renderer.cellIsOver())
            beginCell(placeAt(position));
        strike(notes);

        int until = std::min(count, position + renderer.samplesLeft());
        if (!events.empty())
            until = std::min(until, events.front().sampleOffset);
        renderer.copyOut(outputs, static_cast<std::size_t>(position),
                         static_cast<std::size_t>(until), input, scheduler);
        position = until;
        if (renderer.isSilenced())
            silencedSamples = static_cast<std::size_t>(position);
    }
    songPlace = placeAt(count);
    // Notes at or beyond the end, also those of an empty block, strike at the first sample of the
    // next block.
    while (!events.empty()) {
        const auto due = dueAt(events.front().sampleOffset, events);
        events = events.subspan(due.size());
        for (const auto& event : follow(due))
            if (event.isNoteOn() && lateNotes.size() < lateCapacity)
                lateNotes.push_back(event);
    }
}

/// Returns the events whose notes strike: those after the last All Sound Off.
std::span<const MidiEvent> Player::follow(std::span<const MidiEvent> eventsOfOneSample) {
    keys.beginSample(eventsOfOneSample);
    auto striking = eventsOfOneSample;
    for (std::size_t k = 0; k < eventsOfOneSample.size(); ++k) {
        follow(eventsOfOneSample[k]);
        if (midi::isAllSoundOff(eventsOfOneSample[k].bytes))
            striking = eventsOfOneSample.subspan(k + 1);
    }
    keys.endSample(eventsOfOneSample);
    return striking;
}

void Player::follow(const MidiEvent& event) {
    const int note = event.first();
    if (event.isNoteOn() && !slotTuning.sounds(note))
        return;
    keys.follow(event);
    if (event.isNoteOff())
        for (const Key& key : playedInstrument->keysOf(note))
            if (key.slot >= 0)
                renderer.dampers().release(static_cast<std::size_t>(key.slot), event.second());
    if (event.isNoteOn()) {
        slotTuning.noteOn(note);
        beginNote(note, event.second());
        playedResizedKeys = playedResizedKeys || !playedInstrument->hasOwn(note);
        renderer.endSilence(modulation.values(), keys);
        inputForce.choose(note);
        if (!performance && !strikes(glide.values()))
            held.press(event.channel(), note, keys.softness() * event.second() / 127.0);
    }
    if (midi::isChannelMode(event.bytes) && midi::releasesAllNotes(event.first()))
        liftHands();
    if (midi::isAllSoundOff(event.bytes)) {
        allSoundOffCame = true;
        renderer.silence();
        stage().clear();
        scheduler.clear();
        lateNotes.clear();
    }
}

/// The note chokes other keys of its groups, but not the second layer of its own key.
void Player::beginNote(int note, int velocity) {
    modulation.noteOn(note, velocity);
    const auto struck = playedInstrument->keysOf(note);
    for (const Key& key : struck)
        if (key.takes(velocity) && key.part != nullptr && key.part->chokeGroup > 0)
            renderer.dampers().choke(key.part->chokeGroup);
    for (auto key = struck.rbegin(); key != struck.rend(); ++key) // the first one was played last
        if (key->takes(velocity))
            beginOn(static_cast<std::size_t>(key->slot), note);
}

void Player::beginOn(std::size_t slot, int note) {
    slotModulation.play(slot, note);
    renderer.dampers().strike(slot, glide.values());
    playedLast = slot;
}

void Player::beginCell(std::optional<double> beats) {
    glide.advance();
    modulation.beginCell(tempo, beats);
    slotModulation.apply(modulation, slotTuning, renderer.dampers());
    const auto& values = modulation.values();
    if (inputForce.slotPressed()) // as a strike does
        renderer.endSilence(values, keys);
    slotTuning.apply(keys.bend(), renderer.synthesiser());
    const auto turns = beats && tempo > 0 ? motorTurnsAt(values, *beats) : std::nullopt;
    renderer.turnMotor(values, tempo, turns, turns && silent());
    renderer.beginCell(values, keys, scheduler);
    const double matchedDb =
        loudness ? loudness->follow(glide.goalValues(), keys.modulationWheel(), mayWait) : 0;
    const double modulatedDb = values[ParameterId::level] - glide.values()[ParameterId::level];
    renderer.moveGain(static_cast<float>(std::pow(10, (matchedDb + modulatedDb) / 20)));
}

/// Strikes the notes that came between two blocks, then these notes.
void Player::strike(std::span<const MidiEvent> notes) {
    if (notes.empty() && lateNotes.empty() && !scheduler.hasSurfaceStrikes())
        return;
    if (renderer.isWithinCell() && !performance) {
        slotModulation.apply(modulation, slotTuning, renderer.dampers());
        slotTuning.applyToPlayed(keys.bend(), renderer.synthesiser());
        renderer.updateDampers(modulation.values(), keys);
    }
    const auto momentOf = [this](int note) {
        return renderer.moment(modulation.valuesOf(note), keys.softness());
    };
    const auto strikeNote = [&](const MidiEvent& event) {
        const int note = event.first(), velocity = event.second();
        if (!event.isNoteOn() || !slotTuning.sounds(note))
            return;
        if (performance)
            renderer.startNote(
                *performance, note,
                std::max(1, static_cast<int>(std::lround(keys.softness() * velocity))));
        else if (strikes(glide.values()))
            for (const Key& key : playedInstrument->keysOf(note))
                if (key.takes(velocity))
                    scheduler.strikeKey(key, velocity, held.controllers(event.channel()).place,
                                        momentOf(note));
    };
    std::ranges::for_each(lateNotes, strikeNote);
    lateNotes.clear();
    scheduler.strikeSurfaces(momentOf(Modulation::hand));
    std::ranges::for_each(notes, strikeNote);
}

void Player::strikeSurface(const SurfaceStrike& strike) {
    if (!playedInstrument->has(strike.slot, strike.point))
        return;
    inputForce.chooseSlot(strike.slot);
    const bool isStruck = strike.velocity > 0;
    renderer.dampers().touch(strike.slot, isStruck);
    playedLast = strike.slot;
    if (!isStruck)
        return modulation.liftHand();
    modulation.noteOn(Modulation::hand, strike.velocity);
    beginOn(strike.slot, Modulation::hand);
    if (scheduler.keep(strike))
        renderer.endSilence(modulation.values(), keys);
}

void Player::scrapeSurface(const SurfaceTouch& touch) {
    if (!playedInstrument->has(touch.slot, touch.point))
        return;
    playedLast = touch.slot;
    renderer.endSilence(modulation.values(), keys);
    hand.touch(touch);
}

void Player::takeControllersOf(const Player& former) noexcept {
    keys.takeControllersOf(former.keys);
    if (former.renderer.isSilenced()) // the room behind this player fades too
        renderer.silence();
}

bool Player::beginSong() {
    const bool beginsAnew = silent();
    const auto before = strikesBefore(songPlace.value_or(0));
    if (beginsAnew)
        restart();
    scheduler.countFrom(before);
    modulation.countFrom(before);
    if (performance)
        performance->countNotesFrom(before);
    return beginsAnew;
}

/// Resets the sound, the bodies and the grid, and keeps keys and controllers.
void Player::restart() {
    renderer.reset();
    glide.reset();
    modulation.reset();
    scheduler.reset();
    slotTuning.reset();
    if (performance)
        performance->reset();
}

void Player::reset() {
    restart();
    lateNotes.clear();
    keys.reset();
    renderer.liftHands();
    hand.reset();
    playedLast.reset();
    allSoundOffCame = false;
    silencedSamples = 0;
}

bool Player::silent() const {
    return renderer.silent() && (!performance || performance->silent()) && scheduler.silent() &&
           lateNotes.empty();
}

std::optional<std::size_t> Player::takeSilenced() {
    if (!std::exchange(allSoundOffCame, false) && silencedSamples == 0)
        return std::nullopt;
    return silencedSamples;
}

} // namespace idiophone
