// Takes and plays whole sounds, for the history and presets.
#include "Plugin/Processor.h"

#include "Instrument/SilencedModes.h"
#include "Plugin/FactoryPrograms.h"

#include <cmath>
#include <utility>

namespace idiophone {
namespace {

/// Returns whether a player of one preset can play the other, given its parameters and muted modes.
bool playsAlike(const Preset& a, const Preset& b) {
    return a.surface == b.surface && a.seed == b.seed && a.parameters == b.parameters;
}

/// [dB] A ringing sound ramps to the new level while a new strike starts at the former one. A
/// larger change could make either a burst.
constexpr double mostLevelChange = 12;

bool sharesObject(const std::shared_ptr<const Instrument>& one,
                  const std::shared_ptr<const Instrument>& other) {
    return other != nullptr && !one->slots().empty() && !other->slots().empty() &&
           one->slots().front().object == other->slots().front().object;
}

} // namespace

Sound Processor::loadedSound() const {
    const std::scoped_lock lock(soundMutex);
    return soundNow();
}

Processor::Loaded Processor::loaded() const {
    const std::scoped_lock lock(soundMutex);
    return {.sound = soundNow(), .number = loads};
}

/// Call under soundMutex.
Sound Processor::soundNow() const {
    return {.preset = loadedPreset,
            .instrument = instrument,
            .parameters = parameters.values(),
            .missing = missing,
            .presetId = presetId,
            .presetContent = presetContent,
            .stored = storedParameters};
}

std::optional<Sound> Processor::takeSoundBeforePrograms() {
    const std::scoped_lock lock(soundMutex);
    return std::exchange(soundBeforePrograms, std::nullopt);
}

/// Call under soundMutex.
void Processor::countHostLoad() {
    ++loadsByHost;
    soundBeforePrograms.reset();
}

SoundLabel Processor::loadedLabel() const {
    const std::scoped_lock lock(soundMutex);
    const auto now = withSetupOf(storedParameters, parameters.values());
    return {.name = loadedPreset.name,
            .author = loadedPreset.author,
            .description = loadedPreset.description,
            .tags = loadedPreset.tags,
            .presetId = presetId,
            .isChanged = now != storedParameters};
}

bool Processor::playSound(const Sound& wanted) {
    if (wanted.instrument == nullptr)
        return false;
    {
        const std::scoped_lock lock(soundMutex);
        // Undo steps between key layouts of one object keep its analysis running. Another preset of
        // the same object does not.
        const bool isImport = importLoads == loads && wanted.preset.name == loadedPreset.name &&
                              sharesObject(wanted.instrument, instrument);
        const bool playsOn =
            wanted.instrument == instrument && playsAlike(wanted.preset, loadedPreset);
        const auto wantedNow = [&] { return withSetupOf(parameters.values(), wanted.parameters); };
        auto player = playsOn ? playerForLevel(wanted.preset, wantedNow())
                              : newPlayer(wanted.instrument, wanted.preset, wantedNow());
        if (!player) {
            lastError = player.error().message;
            return false;
        }
        const auto loadValues = [&] {
            parameters.load(wantedNow());
            if (playsOn)
                soundChanges += 2; // counts as another sound, even if the player goes on
        };
        if (playsOn) {
            const bool sameModes = wanted.preset.mutedModes == loadedPreset.mutedModes;
            loadedPreset = wanted.preset; // a new player starts with its silences
            if (!sameModes && *player == nullptr)
                sendSilences();
            goOn(std::move(*player), loadValues);
        } else {
            play(wanted.preset, wanted.instrument, std::move(*player), loadValues);
        }
        if (isImport)
            importLoads = loads;
        missing = wanted.missing;
        presetId = wanted.presetId;
        presetContent = wanted.presetContent;
        storedParameters = wanted.stored;
        programIndex = factoryProgram(presetId);
    }
    tellOfSound();
    return true;
}

void Processor::relabel(const Sound& wanted) {
    {
        const std::scoped_lock lock(soundMutex);
        if (instrument != wanted.instrument)
            return;
        loadedPreset.name = wanted.preset.name;
        loadedPreset.author = wanted.preset.author;
        loadedPreset.description = wanted.preset.description;
        loadedPreset.tags = wanted.preset.tags;
        presetId = wanted.presetId;
        presetContent = wanted.presetContent;
        storedParameters = wanted.stored;
        programIndex = factoryProgram(presetId);
    }
    updateHostDisplay(ChangeDetails().withProgramChanged(true));
}

void Processor::changeParameters(const Sound& of, const ParameterValues& wanted) {
    {
        const std::scoped_lock lock(soundMutex);
        if (instrument != of.instrument)
            return;
        const auto values = parameters.valuesAfter(of.parameters, wanted);
        auto player = playerForLevel(loadedPreset, values);
        if (!player) {
            lastError = player.error().message;
            return;
        }
        goOn(std::move(*player), [&] { parameters.loadChanges(of.parameters, wanted); });
    }
    tellOfSound();
}

/// Call under soundMutex. Returns a new player for the same instrument at other values. Returns
/// null if the current player can go on: if the level changes little, or on a stage, whose bodies
/// would start again.
Result<std::unique_ptr<Player>> Processor::playerForLevel(const Preset& preset,
                                                          const ParameterValues& values) const {
    using enum ParameterId;
    const bool isNear = std::abs(values[level] - parameterValue(level)) <= mostLevelChange;
    if (isNear || instrument == nullptr || instrument->stage())
        return nullptr;
    return newPlayer(instrument, preset, values);
}

/// Call under soundMutex with the player from `playerForLevel`.
void Processor::goOn(std::unique_ptr<Player> player, const std::function<void()>& loadValues) {
    if (player != nullptr)
        handOver(std::move(player), loadValues);
    else
        loadValues();
}

void Processor::setValue(ParameterId parameter, double value) {
    auto& changed = parameters[parameter];
    const bool isInGesture = openGestures[static_cast<std::size_t>(parameter)] > 0;
    if (!isInGesture)
        changed.beginChangeGesture();
    changed.setExactValue(value);
    changed.tellListeners();
    if (!isInGesture)
        changed.endChangeGesture();
}

} // namespace idiophone
