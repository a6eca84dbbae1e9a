// Saves and restores the processor's state.
#include "Plugin/Processor.h"

#include "Instrument/FactoryContent.h"
#include "Object/OneLine.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <utility>

namespace idiophone {

void Processor::getStateInformation(juce::MemoryBlock& destination) {
    State state;
    std::shared_ptr<const Instrument> playing;
    std::shared_ptr<const MissingObjects> absent;
    {
        const std::scoped_lock lock(soundMutex);
        state = {.parameters = parameters.values(),
                 .preset = loadedPreset,
                 .objects = {},
                 .controllers = controllers.assignments(),
                 .tuning = scala};
        playing = instrument;
        absent = missing;
    }
    // Pack without the lock: objects never saved before take a while.
    if (absent != nullptr) {
        state.preset.keyMap = absent->keyMap;
        state.preset.mutedModes = absent->mutedModes;
        state.objects = absent->objects;
    } else if (playing != nullptr) {
        state.objects = embeddedObjects(*playing);
    }
    const auto bytes = encodeState(state);
    destination.replaceAll(bytes.data(), bytes.size());
}

void Processor::setStateInformation(const void* bytes, int byteCount) {
    const std::string_view text(static_cast<const char*>(bytes),
                                static_cast<std::size_t>(std::max(byteCount, 0)));
    ++statesComing;
    const auto restored = withinMemory(
        [&] {
            return parseState(text).and_then([this](const State& state) { return restore(state); });
        },
        "The saved state");
    --statesComing;
    if (restored)
        tellOfSound();
    else
        reportError(restored.error().message);
}

Result<void> Processor::restore(const State& state) {
    const auto keys = keyTuning(state.tuning);
    if (!keys)
        return failure("The saved state has a fault in its tuning: " + keys.error().message);
    auto preset = state.preset;
    auto absent = replaceMissing(preset, state.objects);
    const std::scoped_lock lock(soundMutex);
    auto built = buildInstrument(preset.keyMap, state.objects);
    if (!built)
        return failure("The saved state cannot be played: " + built.error().message);
    auto player = newPlayer(*built, preset, state.parameters);
    if (!player)
        return tl::unexpected(player.error());
    // The state overrides a pending program change; forget the keys that wait for it.
    if (const auto request = requestedProgram.exchange(noRequest); request != noRequest)
        refusedRequest = request;
    auto tuning = state.tuning;
    play(std::move(preset), std::move(*built), std::move(*player), [&] {
        tuneTo(std::move(tuning), *keys);
        tuner.forgetMessages(); // a state holds no tuning messages
        forgetsGivenBends = true;
        controllers.assign(state.controllers);
        parameters.load(state.parameters);
    });
    countHostLoad();
    if (absent != nullptr) {
        missing = std::move(absent);
        lastError = state.preset.name.empty() ? "" : oneLine(state.preset.name) + ": ";
        lastError +=
            missing->first + " is missing; until it is back a steel ring plays in its place.";
    }
    const auto presets = factoryPresets();
    const auto factory = std::ranges::find_if(presets, [&](const Preset& own) {
        return own.name == state.preset.name && own.keyMap == state.preset.keyMap;
    });
    programIndex =
        factory == presets.end() ? -1 : static_cast<int>(std::distance(presets.begin(), factory));
    if (factory != presets.end())
        presetId = factoryPresetId(factory->name);
    return {};
}

} // namespace idiophone
