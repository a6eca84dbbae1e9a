#include "Plugin/AudioEngine.h"

#include <algorithm>

namespace idiophone {

void AudioEngine::process(const HostBuffer& buffer,
                          juce::MidiBuffer& midi,
                          const juce::AudioPlayHead* playHead,
                          bool isOffline) noexcept {
    const int samples = buffer.samples.getNumSamples();
    const SoundMonitor::Callback watched(report.monitor, sound, samples);
    ++report.callbacks;
    takeReset();
    const Player* const next = takeSound(midi);
    takeSettings(isOffline);
    followTransport(playHead, samples);
    pieces.begin(midi, samples);
    takeWindowEvents();
    strikeKeysHeldFor(next);
    while (const auto piece = pieces.next()) {
        const auto length = static_cast<std::size_t>(piece->length);
        const auto rendered = output.memory(length);
        const auto channels = channelsFrom(buffer, piece->start);
        takeInput(buffer, *piece);
        takeEvents(*piece);
        render(rendered, piece->events);
        write(rendered, channels);
        if (buffer.isEffect)
            dryWet.process(std::span(heardChannels).first(heardCount), channels.front(), values);
        sendReport(channels, piece->length);
        if (!isOffline) // it would replace what was played
            report.lastSound.write(output.sum(channels, length), length);
    }
    midi.clear(); // some wrappers would send the remaining events on
}

void AudioEngine::takeReset() noexcept {
    if (!messages.reset.exchange(false))
        return;
    forgetEvents();
    sound.reset();
    output.reset();
    dryWet.reset();
    transport.forgetPlace();
}

/// Discards pending notes and strikes, also those queued while the host did not process. Call when
/// all keys are up.
void AudioEngine::forgetEvents() noexcept {
    pieces.reset();
    programs.forgetKeys();
    messages.window.clear();
}

/// Takes the values of this callback and the new player, which it returns, or nullptr. Takes the
/// player before the values, so that it never sees older ones. Until a pending player arrives,
/// keeps the previous values.
Player* AudioEngine::takeSound(const juce::MidiBuffer& midi) noexcept {
    const auto changesBefore = messages.soundChanges.load();
    Player* const next = messages.players.take();
    followControllers(midi);
    auto newest = values;
    parameters.read(newest);
    if (next != nullptr)
        sound.changeTo(next, std::exchange(values, newest),
                       output.changeSound(newest, PlayerCrossfade::fadeSeconds));
    else if (changesBefore % 2 == 0 && messages.soundChanges == changesBefore)
        values = newest;
    return next;
}

/// Follows learned controllers. A controller after the block's last program change counts as set
/// after that change.
void AudioEngine::followControllers(const juce::MidiBuffer& midi) noexcept {
    const auto behind = programs.behindLast(midi);
    messages.controllers.follow(midi.begin(), behind, parameters);
    if (behind != midi.begin())
        programs.keepMoment(parameters, messages.soundChanges);
    messages.controllers.follow(behind, midi.end(), parameters);
}

void AudioEngine::takeSettings(bool isOffline) noexcept {
    auto* const player = sound.player();
    messages.silencer.silence(player);
    messages.tuner.tune(player);
    if (player == nullptr)
        return;
    if (messages.forgetsGivenBends.exchange(false))
        player->bend().forgetGiven();
    player->setOffline(isOffline);
    player->follow(shifts);
    auto& stage = player->stage();
    stage.pause(messages.stagePaused);
    if (messages.stageReset.exchange(false))
        stage.clear();
}

void AudioEngine::followTransport(const juce::AudioPlayHead* playHead, int blockSamples) noexcept {
    auto* const player = sound.player();
    if (player == nullptr)
        return;
    transport.follow(playHead, blockSamples, player->synthesiser().sampleRateHz());
    report.tempo = transport.tempo();
    report.songPlays = transport.songPlace().has_value();
    player->setSong(transport.tempo(), transport.songPlace());
    if (transport.begins() && player->beginSong() && output.silent())
        output.reset();
}

/// Takes the window's events. If blocks without samples keep too many events, leaves them in the
/// queue.
void AudioEngine::takeWindowEvents() noexcept {
    if (pieces.room() >= WindowEvents::maximumNotes)
        messages.window.read(sound.player(), [this](const MidiEvent& note) { pieces.add(note); });
}

/// Strikes keys pressed before the requested program could play, at the first sample.
void AudioEngine::strikeKeysHeldFor(const Player* next) noexcept {
    if (const auto keys = programs.takeKeys(next); !keys.empty())
        sound.process(StereoSpan{}, keys, values);
}

void AudioEngine::takeEvents(const BlockPieces::Piece& piece) noexcept {
    if (!piece.systemExclusive.empty()) {
        messages.tuner.retune(piece.systemExclusive);
        // An empty piece is followed by another message, which tunes for both, or by a callback.
        if (piece.length > 0 || !piece.events.empty())
            messages.tuner.tune(sound.player());
    }
    programs.follow(piece.events);
}

/// Copies the input, which the output may overwrite.
void AudioEngine::takeInput(const HostBuffer& buffer, const BlockPieces::Piece& piece) noexcept {
    const auto length = static_cast<std::size_t>(piece.length);
    heardCount = static_cast<std::size_t>(buffer.inputs);
    for (std::size_t c = 0; c < heardCount; ++c) {
        const auto* from = buffer.samples.getReadPointer(static_cast<int>(c), piece.start);
        std::copy_n(from, length, heard[c].begin());
        heardChannels[c] = std::span(heard[c]).first(length);
    }
    const auto& second = heard[heardCount == 2 ? 1 : 0];
    for (std::size_t k = 0; k < length; ++k)
        pressing[k] = (heard[0][k] + second[k]) / 2;
}

void AudioEngine::render(std::span<const StereoSpan> rendered,
                         std::span<const MidiEvent> events) noexcept {
    sound.process(rendered, events, values,
                  std::span(pressing).first(heardCount > 0 ? rendered.front().size() : 0));
    if (auto* player = sound.player()) {
        followGivenBends(*player);
        if (const auto silenced = player->takeSilenced())
            output.hush(*silenced);
    }
}

/// Moves the parameters of the MPE zones and bend ranges that MIDI sets, as learned controllers do.
/// The window shows these values, and the project keeps them.
void AudioEngine::followGivenBends(Player& player) noexcept {
    using enum ParameterId;
    const auto given = player.bend().takeGiven();
    const auto move = [this](ParameterId id, std::optional<double> value) {
        auto& parameter = parameters[id];
        if (value && parameter.info().clamped(*value) != parameter.exactValue())
            parameter.moveByController(*value);
    };
    move(mpe, given.mpe);
    move(mpeBendRange, given.memberRange);
}

/// Resets a player whose output is not finite, because it would not recover. The next note then
/// starts from silence.
void AudioEngine::write(std::span<const StereoSpan> rendered,
                        const OutputBuses::Channels& channels) noexcept {
    if (output.process(rendered, channels, values))
        return;
    sound.reset();
    ++report.notFinite;
}

void AudioEngine::sendReport(const OutputBuses::Channels& channels, int count) noexcept {
    for (const auto& ofOutput : channels)
        for (std::size_t channel = 0; channel < ofOutput.size(); ++channel) {
            const auto range = juce::FloatVectorOperations::findMinAndMax(ofOutput[channel], count);
            const float highest = std::max(-range.getStart(), range.getEnd());
            report.monitor.addPeak(channel, highest);
            if (highest > report.peak.load())
                report.peak = highest;
        }
    if (auto* player = sound.player()) {
        report.modulationWheel = player->modulationWheel();
        report.modesMixed = player->synthesiser().modesMixed();
        report.lateEvents = player->stage().lateEvents();
        report.semitonesBelowEqual = player->semitonesBelowEqual();
        report.playedResizedKeys = player->hasPlayedResizedKeys();
        report.capture.take(*player);
    }
}

OutputBuses::Channels AudioEngine::channelsFrom(const HostBuffer& buffer, int start) noexcept {
    OutputBuses::Channels channels;
    std::size_t first = 0;
    for (std::size_t bus = 0; bus < maximumOutputs; ++bus) {
        const auto count = static_cast<std::size_t>(buffer.outputs[bus]);
        for (std::size_t i = first; i < first + count; ++i)
            channelPointers[i] = buffer.samples.getWritePointer(static_cast<int>(i), start);
        channels[bus] = std::span(channelPointers).subspan(first, count);
        first += count;
    }
    return channels;
}

AudioEngine::AudioEngine(HostParameters& hostParameters,
                         EngineMessages& engineMessages,
                         ProgramChanges& programChanges,
                         EngineReport& engineReport)
    : parameters(hostParameters), messages(engineMessages), programs(programChanges),
      report(engineReport), sound(engineMessages.players) {}

void AudioEngine::prepare(double sampleRateHz, std::unique_ptr<Player> player, OutputSet outputs) {
    output.prepare(sampleRateHz, outputs);
    dryWet.prepare(sampleRateHz, OutputStage::rampSeconds);
    report.monitor.prepare(sampleRateHz);
    report.lastSound.prepare(sampleRateHz);
    delete messages.players.take();
    sound.install(std::move(player));
    forgetEvents();
    programs.prepare();
    transport.forget();
    report.tempo = 0;
    report.songPlays = false;
    messages.reset = false;
    ++report.callbacks; // the first callback, counted in advance
    values = parameters.values();
    prepared = true;
}

} // namespace idiophone
