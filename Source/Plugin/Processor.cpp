#include "Plugin/Processor.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/SettingsOfParameters.h"
#include "Object/OneLine.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {

// Audio thread.

void Processor::processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) {
    const juce::ScopedNoDenormals noDenormals;
    if (!isPrepared) { // some hosts process unprepared plugins
        buffer.clear();
        midi.clear();
        return;
    }
    const SoundMonitor::Callback watchedCallback(monitor, sound, buffer.getNumSamples());
    ++callbacks;
    if (resetRequested.exchange(false)) {
        forgetEvents();
        sound.reset();
        output.reset();
        transport.forgetPlace();
    }
    // Take the new player before the parameter snapshot, so that it never sees older values. Until
    // a pending player arrives, keep the previous values.
    const auto changesBefore = soundChanges.load();
    Player* const next = handoff.take();
    // A player's label names the request that it answers. It plays all keys from this callback on.
    const bool isAnswer = next != nullptr && next->label() == awaitedRequest;
    followControllers(midi);
    const ParameterValues& newest = parameters.snapshot();
    if (next != nullptr || (changesBefore % 2 == 0 && soundChanges == changesBefore))
        playedValues = newest;
    const ParameterValues& values = playedValues;
    if (next != nullptr)
        sound.changeTo(next, output.changeSound(values, PlayerCrossfade::fadeSeconds));
    silencer.silence(sound.player());
    tuner.tune(sound.player());
    if (auto* player = sound.player()) {
        if (forgetsGivenBends.exchange(false))
            player->forgetGivenBends();
        followTransport(*player, buffer.getNumSamples());
        player->setOffline(isNonRealtime());
        player->pauseStage(stagePaused);
        if (stageResetRequested.exchange(false))
            player->resetStage();
    }
    hand.playOn(sound.player());
    if (isAnswer || refusedRequest == awaitedRequest) {
        const auto keys = pendingKeys.take();
        if (isAnswer && !keys.empty())       // otherwise they sound at their own samples
            sound.process({}, keys, values); // struck at the first sample
    }

    pieces.begin(midi, editorNotes, buffer.getNumSamples());
    while (const auto piece = pieces.next()) {
        const auto length = static_cast<std::size_t>(piece->length);
        const StereoSpan rendered{std::span(left).first(length), std::span(right).first(length)};
        const auto channels = channelsFrom(buffer, piece->start);
        if (!piece->systemExclusive.empty()) {
            tuner.retune(piece->systemExclusive);
            tuner.tune(sound.player());
        }
        pendingKeys.follow(piece->events);
        if (const auto program = pendingKeys.takeProgram())
            requestProgram(*program);
        sound.process(rendered, piece->events, values);
        if (auto* player = sound.player()) {
            followGivenBends(*player);
            if (const auto silenced = player->takeSilenced())
                output.hush(*silenced);
        }
        if (!output.process(rendered.left, rendered.right, channels, values)) {
            // The player would stay non-finite: reset it, so that the next note starts from
            // silence.
            sound.reset();
            ++notFinite;
        }
        report(channels, piece->length);
    }
    midi.clear(); // some wrappers send on the events left in it
    if (isNonRealtime())
        followProgramChange();
}

/// [audio thread] Discards pending notes and strikes, also those queued while the host did not
/// process. Call when all keys are up. A requested program stays pending.
void Processor::forgetEvents() noexcept {
    pieces.reset();
    pendingKeys.forgetKeys();
    editorNotes.clear();
    hand.clear();
}

/// [audio thread] Follows learned controllers. Those after the block's last program change count as
/// set after it.
void Processor::followControllers(const juce::MidiBuffer& midi) noexcept {
    auto behind = midi.begin();
    for (auto message = midi.begin(); message != midi.end();) {
        const auto metadata = *message;
        ++message;
        if (pendingKeys.isAwaited(std::span(metadata.data, std::size_t(metadata.numBytes))))
            behind = message;
    }
    controllers.follow(midi.begin(), behind, parameters);
    if (behind != midi.begin()) {
        atProgramChange.soundChanges = soundChanges;
        atProgramChange.moves = parameters.moves();
        atProgramChange.values = parameters.values();
    }
    controllers.follow(behind, midi.end(), parameters);
}

/// [audio thread] Asks the message thread for a program.
void Processor::requestProgram(int program) noexcept {
    const auto request = programsOfMidi * ++programRequests + program;
    atProgramChange.request = awaitedRequest = request;
    movesAtRequest.next() = atProgramChange;
    movesAtRequest.publish(); // before the request is visible
    requestedProgram = request;
}

/// [audio thread] Call before rendering anything of the callback.
void Processor::followTransport(Player& player, int blockSamples) noexcept {
    transport.follow(getPlayHead(), blockSamples, player.synthesiser().sampleRateHz());
    tempo = transport.tempo();
    player.setTempo(tempo);
    player.setSongPlace(transport.songPlace());
    if (transport.begins() && player.beginSong() && output.silent())
        output.reset();
}

/// [audio thread] Moves the parameters of the MPE zones and bend ranges that MIDI sets, as learned
/// controllers do. They are shown and saved.
void Processor::followGivenBends(Player& player) noexcept {
    using enum ParameterId;
    const auto given = player.takeGivenBends();
    const auto move = [this](ParameterId id, std::optional<double> value) {
        auto& parameter = parameters[id];
        if (value && parameter.info().clamped(*value) != parameter.exactValue())
            parameter.moveByController(*value);
    };
    move(mpe, given.mpe);
    move(mpeBendRange, given.memberRange);
}

std::span<float* const> Processor::channelsFrom(juce::AudioBuffer<float>& buffer,
                                                int start) noexcept {
    const auto count = std::min<std::size_t>(static_cast<std::size_t>(buffer.getNumChannels()),
                                             channelPointers.size());
    for (std::size_t i = 0; i < count; ++i)
        channelPointers[i] = buffer.getWritePointer(static_cast<int>(i), start);
    return std::span(channelPointers).first(count);
}

void Processor::report(std::span<float* const> channels, int count) noexcept {
    for (std::size_t channel = 0; channel < channels.size(); ++channel) {
        const auto range = juce::FloatVectorOperations::findMinAndMax(channels[channel], count);
        const float highest = std::max(-range.getStart(), range.getEnd());
        monitor.hear(channel, highest);
        if (highest > peak.load())
            peak = highest;
    }
    if (auto* player = sound.player()) {
        modulationWheel = player->modulationWheel();
        modesMixed = player->synthesiser().modesMixed();
        lateEvents = player->lateEvents();
        semitonesBelowPlayed = player->semitonesBelowEqual();
        playedResizedKeys = player->hasPlayedResizedKeys();
        capture.take(*player);
    }
}

// Other threads.

Processor::Processor()
    : AudioProcessor(BusesProperties().withOutput("Output", juce::AudioChannelSet::stereo(), true)),
      parameters(*this), pendingKeys(static_cast<int>(factoryPresets().size())) {
    setCurrentProgram(0);
    soundToTell = movedToTell = 0; // the host has not asked yet
    looks.emplace(pollMilliseconds, [this] { poll(); });
}

Processor::~Processor() {
    looks.reset(); // before everything it polls
}

bool Processor::isBusesLayoutSupported(const BusesLayout& layouts) const {
    if (!layouts.inputBuses.isEmpty() || layouts.outputBuses.size() != 1)
        return false;
    const auto& main = layouts.outputBuses.getReference(0);
    return main == juce::AudioChannelSet::mono() || main == juce::AudioChannelSet::stereo();
}

void Processor::prepareToPlay(double sampleRateHz, int) {
    const std::scoped_lock lock(soundMutex);
    preparedRateHz = std::isfinite(sampleRateHz) && sampleRateHz > 0 ? sampleRateHz : 44100;
    // Blocks are rendered in pieces of our own size, because the host's blocks may have any size.
    output.prepare(preparedRateHz, BlockPieces::maximumSamples);
    monitor.prepare(preparedRateHz);
    delete handoff.take();
    modulationWheel = HeldContacts::controllerAtRest; // wheel of the installed player
    auto player = newPlayer(instrument, loadedPreset, parameters.values());
    if (!player)
        lastError = player.error().message;
    sound.install(player ? std::move(*player) : nullptr);
    handoff.collect();
    forgetEvents();
    if (requestedProgram == noRequest) // no pending player would answer it
        pendingKeys.take();
    transport.forget();
    tempo = 0;
    resetRequested = false;
    ++callbacks; // counts the first callback in advance
    playedValues = parameters.values();
    isPrepared = true;
}

void Processor::releaseResources() {
    const std::scoped_lock lock(soundMutex);
    handoff.collect();
}

void Processor::reset() {
    resetRequested = true;
}

/// Some wrappers call it with every block. Offline, the host hears of no controller and so sends no
/// echo.
void Processor::setNonRealtime(bool isOffline) noexcept {
    if (isOffline != isNonRealtime())
        parameters.forgetTold();
    AudioProcessor::setNonRealtime(isOffline);
}

juce::AudioProcessorParameter* Processor::getBypassParameter() const {
    return &parameters[ParameterId::bypass];
}

double Processor::getTailLengthSeconds() const {
    using enum ParameterId;
    const auto values = parameters.values();
    // Before the first callback the player does not know tunings and bend ranges.
    const double bends = values[bendRange] + (values[mpe] != 0 ? values[mpeBendRange] : 0);
    const double semitonesBelow =
        std::max(bends + semitonesBelowTuned.load(), semitonesBelowPlayed.load());
    const double slowest = slowestDecay((playedResizedKeys ? allDecays : ownDecays).load(),
                                        synthesisSettings(values), semitonesBelow);
    const double inRoom = values[room] > 0 ? values[roomDecay] * std::log10(65536) / 3 : 0;
    return std::min(stageSeconds + std::log(65536) / slowest + inRoom, longestTailSeconds);
}

/// Call under soundMutex. Plays a preset with its instrument and the player from `newPlayer`.
/// `loadValues` sets the parameter values.
void Processor::play(Preset preset,
                     std::shared_ptr<const Instrument> built,
                     std::unique_ptr<Player> player,
                     const std::function<void()>& loadValues) {
    ownDecays.store(decayBounds(*built, RingingKeys::own));
    allDecays.store(decayBounds(*built));
    playedResizedKeys = false;
    semitonesBelowTuned = semitonesBelowEqual(*built, ownKeys);
    stageSeconds = built->stage() ? built->stage()->lengthSeconds() : 0;
    loadedPreset = std::move(preset);
    if (instrument != built)
        modesHeardAlone = {};
    storedParameters = loadedPreset.parameters;
    presetId.clear();
    presetContent = 0;
    missing.reset();
    instrument = std::move(built);
    ++loads;
    lastError.clear();
    handOver(std::move(player), [&] {
        stagePaused = false;
        loadValues();
    });
}

/// Call under soundMutex with an instrument, as the last step: until then callbacks play the former
/// player unchanged. Loads the values right before publishing the player, if there is one, so that
/// a callback takes both together.
void Processor::handOver(std::unique_ptr<Player> player, const std::function<void()>& loadValues) {
    if (player != nullptr)
        player->setLabel(answeredRequest);
    handoff.collect(); // it may take a while, so do it before changing anything
    // Send silences before the player: the player has its own and must not get older ones.
    sendSilences();
    ++soundChanges;
    loadValues();
    if (player != nullptr)
        handoff.publish(std::move(player));
    ++soundChanges;
}

/// Call under soundMutex as the first step of a change: if memory or threads do not suffice,
/// nothing has changed. The former player sounds on meanwhile with its own values. Returns a player
/// prepared for `values`, or null without a sample rate or an instrument.
Result<std::unique_ptr<Player>> Processor::newPlayer(const std::shared_ptr<const Instrument>& built,
                                                     const Preset& preset,
                                                     const ParameterValues& values) const {
    if (built == nullptr || !(preparedRateHz > 0))
        return nullptr;
    return withinMemory(
        [&]() -> Result<std::unique_ptr<Player>> {
            auto player = std::make_unique<Player>(built, preparedRateHz, preset.surface,
                                                   preset.seed, preset.parameters);
            player->setSilencedModes(silencedModes(
                *built, preset.mutedModes, built == instrument ? modesHeardAlone : ModeSet()));
            player->prepare(values, modulationWheel);
            return player;
        },
        preset.name.empty() ? "The sound" : oneLine(preset.name));
}

void Processor::waitForSimulation() {
    if (auto* player = sound.player())
        player->waitForSimulation();
}

void Processor::poll() {
    lookForCallbacks();
    if (const auto times = notFinite.load(); std::exchange(notFiniteShown, times) != times)
        reportError("The sound was not finite, and begins anew with the next note.");
    followWorkshop();
    if (!isNonRealtime()) { // offline the callback does this
        followProgramChange();
        controllers.tellHost(parameters, openGestures);
        if (controllers.takeReassigned())
            updateHostDisplay(ChangeDetails().withNonParameterStateChanged(true));
        if (statesComing == 0 && soundToTell > 0) {
            --soundToTell; // first: another sound may arrive meanwhile
            tellOfSound();
        } else if (statesComing == 0 && movedToTell > 0) {
            --movedToTell;
            parameters.notifyListenersOfMoved();
        }
    }
    // Destroy players that faded out. If another thread holds the mutex, it does so.
    if (const std::unique_lock lock(soundMutex, std::try_to_lock); lock) {
        handoff.collect();
        capture.follow(instrument);
    }
}

} // namespace idiophone
