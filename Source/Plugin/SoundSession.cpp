#include "Plugin/SoundSession.h"

#include "Instrument/SilencedModes.h"
#include "Object/OneLine.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/WithinMemory.h"

#include <cmath>
#include <utility>

namespace idiophone {
namespace {

/// [dB] A ringing sound ramps to the new level while a new strike starts at the former one. After a
/// larger change, one of the two could be a burst.
constexpr double maximumLevelChange = 12;

bool sharesObject(const std::shared_ptr<const Instrument>& one,
                  const std::shared_ptr<const Instrument>& other) {
    return one != nullptr && other != nullptr && !one->slots().empty() && !other->slots().empty() &&
           one->slots().front().object == other->slots().front().object;
}

SoundSession::PlayerResult playerAt(double rateHz,
                                    const std::shared_ptr<const Instrument>& instrument,
                                    const Preset& preset,
                                    const ModeSet& alone,
                                    const ParameterValues& values,
                                    int wheel) {
    if (instrument == nullptr || !(rateHz > 0))
        return nullptr;
    return withinMemory(
        [&]() -> SoundSession::PlayerResult {
            auto player = std::make_unique<Player>(instrument, rateHz, preset.surface, preset.seed,
                                                   preset.parameters);
            player->setSilencedModes(silencedModes(*instrument, preset.mutedModes, alone));
            player->prepare(values, wheel);
            return player;
        },
        preset.name.empty() ? "The sound" : oneLine(preset.name));
}

} // namespace

void SoundSession::prepare(double sampleRateHz,
                           const std::function<void(std::unique_ptr<Player>)>& install) {
    const auto held = lock();
    preparedRateHz = sampleRateHz;
    shared.report.modulationWheel = HeldContacts::controllerAtRest; // of an installed player
    auto player = newPlayer(current.instrument, current.preset, shared.parameters.values());
    if (!player)
        fail(player.error().message);
    playedGain = player && *player != nullptr ? (*player)->matchedGain() : nullptr;
    install(player ? std::move(*player) : nullptr);
    shared.messages.players.collect();
}

void SoundSession::poll() {
    if (const auto times = shared.report.notFinite.load();
        std::exchange(notFiniteShown, times) != times)
        reportError("The sound was not finite, and begins anew with the next note.");
    std::shared_ptr<MatchedGain> gain;
    if (const std::unique_lock held(mutex, std::try_to_lock); held) {
        shared.messages.players.collect();
        shared.report.capture.follow(current.instrument);
        gain = playedGain;
    }
    if (gain != nullptr)
        gain->answer(); // without the lock: a prediction takes some milliseconds
}

Sound SoundSession::loadedSound() const {
    const auto held = lock();
    return soundNow();
}

PlayingPreset SoundSession::playingPreset() const {
    const auto held = lock();
    return {.id = current.presetId,
            .details = detailsOf(current.preset),
            .isChanged = withSetupOf(current.stored, shared.parameters.values()) != current.stored};
}

ParameterValues SoundSession::presetValues() const {
    const auto held = lock();
    return current.stored;
}

Sound SoundSession::soundNow() const {
    auto sound = current;
    sound.parameters = shared.parameters.values();
    return sound;
}

SoundSession::Loaded SoundSession::loaded() const {
    const auto held = lock();
    return {.sound = soundNow(), .number = loads, .origin = loadOfObjects};
}

std::shared_ptr<const Instrument> SoundSession::instrument() const {
    const auto held = lock();
    return current.instrument;
}

double SoundSession::rateHz() const {
    const auto held = lock();
    return preparedRateHz > 0 ? preparedRateHz : 48000;
}

bool SoundSession::playSound(const Sound& wanted) {
    if (wanted.instrument == nullptr)
        return false;
    {
        const auto held = lock();
        const bool keepsObject = wanted.preset.name == current.preset.name &&
                                 sharesObject(wanted.instrument, current.instrument);
        const int origin = loadOfObjects;
        const bool goesOn = goesOnWith(wanted);
        const auto wantedNow = [&] {
            return withSetupOf(shared.parameters.values(), wanted.parameters);
        };
        auto player = goesOn ? playerForLevel(wanted.preset, wantedNow())
                             : newPlayer(wanted.instrument, wanted.preset, wantedNow());
        if (!player) {
            fail(player.error().message);
            return false;
        }
        if (goesOn) {
            const bool sameModes = wanted.preset.mutedModes == current.preset.mutedModes;
            current = wanted;
            playingProgram = factoryProgram(current.presetId);
            if (!sameModes && *player == nullptr) // a new player starts with its silenced modes
                sendSilences();
            goOn(std::move(*player), [&] {
                shared.parameters.load(wantedNow());
                shared.messages.soundChanges += 2; // another sound, even if the player goes on
            });
        } else {
            play(wanted, std::move(*player), [&] { shared.parameters.load(wantedNow()); });
            if (keepsObject)
                keepOrigin(origin);
        }
    }
    shared.reporter.reportSound();
    return true;
}

/// Returns whether the player of the current sound can play the wanted one, given its parameters
/// and muted modes.
bool SoundSession::goesOnWith(const Sound& wanted) const {
    const auto& now = current.preset;
    return wanted.instrument == current.instrument && wanted.preset.surface == now.surface &&
           wanted.preset.seed == now.seed && wanted.preset.parameters == now.parameters;
}

void SoundSession::relabel(const Sound& wanted) {
    {
        const auto held = lock();
        if (current.instrument != wanted.instrument)
            return;
        current.preset.name = wanted.preset.name;
        current.preset.author = wanted.preset.author;
        current.preset.description = wanted.preset.description;
        current.preset.tags = wanted.preset.tags;
        current.presetId = wanted.presetId;
        current.presetContent = wanted.presetContent;
        current.stored = wanted.stored;
        playingProgram = factoryProgram(current.presetId);
    }
    shared.reporter.reportProgram();
}

void SoundSession::changeParameters(const Sound& of, const ParameterValues& wanted) {
    {
        const auto held = lock();
        if (current.instrument != of.instrument)
            return;
        const auto values = shared.parameters.valuesAfter(of.parameters, wanted);
        auto player = playerForLevel(current.preset, values);
        if (!player)
            return fail(player.error().message);
        goOn(std::move(*player), [&] { shared.parameters.loadChanges(of.parameters, wanted); });
    }
    shared.reporter.reportSound();
}

StatusView::Status SoundSession::takeStatus() {
    Status status{.sentence = {},
                  .isError = false,
                  .modesMixed = shared.report.modesMixed,
                  .lateEvents = shared.report.lateEvents,
                  .peak = shared.report.peak.exchange(0)};
    const auto held = lock();
    if (current.instrument != nullptr && current.instrument->stage() != nullptr)
        status.delaySeconds = current.instrument->stage()->delaySeconds();
    status.isError = !lastError.empty();
    status.sentence = status.isError ? lastError : current.preset.description;
    return status;
}

void SoundSession::reportError(const std::string& sentence) {
    const auto held = lock();
    fail(sentence);
}

void SoundSession::takeBackError(const std::string& sentence) {
    const auto held = lock();
    if (lastError == sentence)
        lastError.clear();
}

SoundSession::PlayerResult SoundSession::newPlayer(const std::shared_ptr<const Instrument>& built,
                                                   const Preset& preset,
                                                   const ParameterValues& values) const {
    return playerAt(preparedRateHz, built, preset,
                    built == current.instrument ? heardAlone : ModeSet(), values,
                    shared.report.modulationWheel);
}

std::pair<SoundSession::PlayerResult, std::unique_lock<std::mutex>>
SoundSession::newPlayerThenLock(const std::shared_ptr<const Instrument>& built,
                                const Preset& preset,
                                const ParameterValues& values) const {
    auto held = lock();
    PlayerResult player;
    // Builds again if the host has prepared for another rate meanwhile.
    for (double rateHz = -1; rateHz != preparedRateHz;) {
        rateHz = preparedRateHz;
        held.unlock();
        player = playerAt(rateHz, built, preset, {}, values, shared.report.modulationWheel);
        held.lock();
    }
    return {std::move(player), std::move(held)};
}

/// Returns a new player for the same instrument at other values. Returns null if the current player
/// can go on: if the level changes little, or on a stage, whose bodies would start again.
SoundSession::PlayerResult SoundSession::playerForLevel(const Preset& preset,
                                                        const ParameterValues& values) const {
    using enum ParameterId;
    const bool isNear =
        std::abs(values[level] - shared.parameters[level].exactValue()) <= maximumLevelChange;
    if (isNear || current.instrument == nullptr || current.instrument->stage())
        return nullptr;
    return newPlayer(current.instrument, preset, values);
}

void SoundSession::play(Sound sound, std::unique_ptr<Player> player, const LoadValues& loadValues) {
    shared.tail.setInstrument(sound.instrument);
    shared.report.playedResizedKeys = false;
    if (current.instrument != sound.instrument)
        heardAlone = {};
    current = std::move(sound);
    playingProgram = factoryProgram(current.presetId);
    loadOfObjects = ++loads;
    lastError.clear();
    handOver(std::move(player), [&] {
        shared.messages.stagePaused = false;
        loadValues();
    });
}

/// Takes the player from `playerForLevel`.
void SoundSession::goOn(std::unique_ptr<Player> player, const LoadValues& loadValues) {
    if (player != nullptr)
        handOver(std::move(player), loadValues);
    else
        loadValues();
}

/// Call with an instrument, as the last step: until then callbacks play the former player
/// unchanged. Loads the values right before publishing the player, if there is one, so that a
/// callback takes both together.
void SoundSession::handOver(std::unique_ptr<Player> player, const LoadValues& loadValues) {
    if (player != nullptr) {
        player->setLabel(shared.programs.label());
        playedGain = player->matchedGain();
    }
    shared.messages.players.collect(); // it may take a while, so do it before changing anything
    // Send silences before the player: the player has its own and must not get older ones.
    sendSilences();
    ++shared.messages.soundChanges;
    loadValues();
    if (player != nullptr)
        shared.messages.players.publish(std::move(player));
    ++shared.messages.soundChanges;
}

void SoundSession::sendSilences() {
    shared.messages.silencer.send(
        *current.instrument,
        silencedModes(*current.instrument, current.preset.mutedModes, heardAlone));
}

} // namespace idiophone
