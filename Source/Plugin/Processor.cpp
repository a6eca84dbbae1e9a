#include "Plugin/Processor.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/SettingsOfParameters.h"
#include "Object/OneLine.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {

// The audio thread.

void Processor::processBlock(juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) {
    const juce::ScopedNoDenormals noDenormals;
    if (!isPrepared) { // some hosts process all the same
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
    // The player before the values: a new one never plays values older than its own. Nor does the
    // former one play those of the next, at a level that is none of its own: while values and their
    // player are handed over, and it has not come yet, the values stay what they were.
    const auto changesBefore = soundChanges.load();
    Player* const next = handoff.take();
    // It says itself what it answers: from the callback that takes it on, keys are its own.
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
        const auto keys = awaitingKeys.take();
        if (isAnswer && !keys.empty())       // or else they sound where they are
            sound.process({}, keys, values); // they strike with the first sample there is
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
        awaitingKeys.follow(piece->events);
        if (const auto program = awaitingKeys.takeProgram())
            requestProgram(*program);
        sound.process(rendered, piece->events, values);
        if (auto* player = sound.player()) {
            followGivenBends(*player);
            if (const auto silenced = player->takeSilenced())
                output.hush(*silenced);
        }
        if (!output.process(rendered.left, rendered.right, channels, values)) {
            // Or else it would stay so, and the instrument silent: the next note begins anew.
            sound.reset();
            ++notFinite;
        }
        report(channels, piece->length);
    }
    midi.clear(); // what is left in it some wrappers send on
    if (isNonRealtime())
        followProgramChange();
}

/// [audio thread] Notes and blows that wait, as those do that came while the host did not process:
/// for when all keys are up. A program that was asked for is still awaited.
void Processor::forgetEvents() noexcept {
    pieces.reset();
    awaitingKeys.forgetKeys();
    editorNotes.clear();
    hand.clear();
}

/// [audio thread] Those behind the block's last program change count as set since.
void Processor::followControllers(const juce::MidiBuffer& midi) noexcept {
    auto behind = midi.begin();
    for (auto message = midi.begin(); message != midi.end();) {
        const auto metadata = *message;
        ++message;
        if (awaitingKeys.isAwaited(std::span(metadata.data, std::size_t(metadata.numBytes))))
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

/// [audio thread]
void Processor::requestProgram(int program) noexcept {
    const auto request = programsOfMidi * ++programRequests + program;
    atProgramChange.request = awaitedRequest = request;
    movesAtRequest.next() = atProgramChange;
    movesAtRequest.publish(); // before it is asked for
    requestedProgram = request;
}

/// [audio thread] Before anything of the callback is played.
void Processor::followTransport(Player& player, int blockSamples) noexcept {
    transport.follow(getPlayHead(), blockSamples, player.synthesiser().sampleRateHz());
    tempo = transport.tempo();
    player.setTempo(tempo);
    player.setSongPlace(transport.songPlace());
    if (transport.begins() && player.beginSong() && output.silent())
        output.reset();
}

/// [audio thread] Zones and bend ranges that MIDI gives move their parameters as learned
/// controllers do: they are shown and saved.
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
        lateBlows = player->lateBlows();
        semitonesBelowPlayed = player->semitonesBelowEqual();
        playedResizedKeys = player->hasPlayedResizedKeys();
        capture.take(*player);
    }
}

// Everybody else.

Processor::Processor()
    : AudioProcessor(BusesProperties().withOutput("Output", juce::AudioChannelSet::stereo(), true)),
      parameters(*this), awaitingKeys(static_cast<int>(factoryPresets().size())) {
    setCurrentProgram(0);
    soundToTell = movedToTell = 0; // the host has yet to ask
    looks.emplace(lookMilliseconds, [this] { look(); });
}

Processor::~Processor() {
    looks.reset(); // before anything that it looks at
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
    // Blocks are rendered in pieces of our own size: the host's may be of any.
    output.prepare(preparedRateHz, BlockPieces::maximumSamples);
    monitor.prepare(preparedRateHz);
    delete handoff.take();
    modulationWheel = HeldContacts::controllerAtRest; // of what is installed
    auto player = newPlayer(instrument, loadedPreset, parameters.values());
    if (!player)
        lastError = player.error().message;
    sound.install(player ? std::move(*player) : nullptr);
    handoff.collect();
    forgetEvents();
    if (requestedProgram == noRequest) // no player comes that would answer it
        awaitingKeys.take();
    transport.forget();
    tempo = 0;
    resetRequested = false;
    ++callbacks; // the first will come
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

/// Some wrappers call it with every block. Offline the host is told of no controller, and so does
/// not echo.
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
    // Before the first callback the player knows neither tunings nor ranges.
    const double bends = values[bendRange] + (values[mpe] != 0 ? values[mpeBendRange] : 0);
    const double semitonesBelow =
        std::max(bends + semitonesBelowTuned.load(), semitonesBelowPlayed.load());
    const double slowest = slowestDecay((playedResizedKeys ? allDecays : ownDecays).load(),
                                        synthesisSettings(values), semitonesBelow);
    const double inRoom = values[room] > 0 ? values[roomDecay] * std::log10(65536) / 3 : 0;
    return std::min(stageSeconds + std::log(65536) / slowest + inRoom, longestTailSeconds);
}

/// Under soundMutex, with what `newPlayer` has made of them, and what loads their values.
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

/// Under soundMutex, with an instrument: the last thing, as callbacks until then play the former
/// player as it was. The values come right before the player, if there is one, and for the callback
/// hold with it.
void Processor::handOver(std::unique_ptr<Player> player, const std::function<void()>& loadValues) {
    if (player != nullptr)
        player->setLabel(answeredRequest);
    handoff.collect(); // which may take a while, and not between what follows
    // Before the player, which has its own: an older message never comes to it.
    sendSilences();
    ++soundChanges;
    loadValues();
    if (player != nullptr)
        handoff.publish(std::move(player));
    ++soundChanges;
}

/// Under soundMutex: the first thing where another sound is to play, since all stays as it was
/// where memory or threads do not suffice for it, and as it takes its time, in which the former
/// player sounds on with its own values. Complete, for the values with which it is to play. Null
/// without a sample rate or an instrument.
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

void Processor::look() {
    lookForCallbacks();
    if (const auto times = notFinite.load(); std::exchange(notFiniteShown, times) != times)
        reportError("The sound was not finite, and begins anew with the next note.");
    followWorkshop();
    if (!isNonRealtime()) { // or else the callback follows
        followProgramChange();
        controllers.tellHost(parameters, openGestures);
        if (controllers.takeReassigned())
            updateHostDisplay(ChangeDetails().withNonParameterStateChanged(true));
        if (statesComing == 0 && soundToTell > 0) {
            --soundToTell; // first: another sound may have come
            tellOfSound();
        } else if (statesComing == 0 && movedToTell > 0) {
            --movedToTell;
            parameters.notifyListenersOfMoved();
        }
    }
    // Players that faded out are destroyed here at the latest. Whoever holds the mutex does it too.
    if (const std::unique_lock lock(soundMutex, std::try_to_lock); lock) {
        handoff.collect();
        capture.follow(instrument);
    }
}

} // namespace idiophone
