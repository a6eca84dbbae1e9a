#include "Plugin/HostSession.h"

#include "Instrument/FactoryContent.h"
#include "Object/OneLine.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/PresetSound.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <utility>

namespace idiophone {

std::string HostSession::save() {
    Sound sound;
    State state;
    {
        const auto held = session.lock();
        sound = session.soundNow();
        state.controllers = shared.messages.controllers.assignments();
        state.tuning = tuning.files();
    }
    // Pack without the lock: objects never saved before take a while to pack.
    state.parameters = sound.parameters;
    state.preset = std::move(sound.preset);
    state.origin = {std::move(sound.presetId), sound.presetContent, sound.stored};
    if (sound.missing != nullptr) {
        state.preset.keyMap = sound.missing->keyMap;
        state.preset.mutedModes = sound.missing->mutedModes;
        state.objects = sound.missing->objects;
    } else if (sound.instrument != nullptr) {
        state.objects = embeddedObjects(*sound.instrument);
    }
    return encodeState(state);
}

void HostSession::restore(std::string_view bytes) {
    const auto restored = withinMemory(
        [&] {
            const HostReporter::Restoring restoring(shared.reporter);
            return parseState(bytes).and_then([this](const State& state) { return play(state); });
        },
        "The saved state");
    if (restored)
        shared.reporter.reportSound();
    else
        session.reportError(restored.error().message);
}

Result<void> HostSession::play(const State& state) {
    const auto keys = keyTuning(state.tuning);
    if (!keys)
        return failure("The saved state has a fault in its tuning: " + keys.error().message);
    Sound sound{.preset = state.preset,
                .parameters = state.parameters,
                .presetId = state.origin.presetId,
                .presetContent = state.origin.presetContent,
                .stored =
                    state.origin.presetId.empty() ? state.preset.parameters : state.origin.stored};
    if (const auto* factory = findFactoryPreset(state.preset.name);
        factory != nullptr && factory->keyMap == state.preset.keyMap && sound.presetContent == 0)
        sound.presetId = factoryPresetId(factory->name);
    sound.missing = replaceMissing(sound.preset, state.objects);
    auto built = buildInstrument(sound.preset.keyMap, state.objects);
    if (!built)
        return failure("The saved state cannot be played: " + built.error().message);
    auto [player, held] = session.newPlayerThenLock(*built, sound.preset, state.parameters);
    if (!player)
        return tl::unexpected(player.error());
    shared.programs.cancel();
    sound.instrument = std::move(*built);
    auto files = state.tuning;
    const auto missing = sound.missing;
    session.play(std::move(sound), std::move(*player), [&] {
        tuning.tuneTo(std::move(files), *keys);
        shared.messages.tuner.forgetMessages(); // a state holds no tuning messages
        shared.messages.forgetsGivenBends = true;
        shared.messages.controllers.assign(state.controllers);
        shared.parameters.load(state.parameters);
    });
    shared.loads.count();
    if (missing != nullptr)
        session.fail((state.preset.name.empty() ? "" : oneLine(state.preset.name) + ": ") +
                     missing->first +
                     " is missing; until it is back a steel ring plays in its place.");
    return {};
}

void HostSession::followRequest() {
    if (const auto request = shared.programs.pending(); request != ProgramChanges::none)
        chooseProgram(ProgramChanges::programOf(request), request);
}

/// Loads a program for MIDI's request, or for the host if there is none.
void HostSession::chooseProgram(int index, ProgramChanges::Request request) {
    const bool isForMidi = request != ProgramChanges::none;
    if (index < 0 || index >= static_cast<int>(factoryPresets().size()))
        return;
    {
        const auto held = session.lock();
        if (isForMidi && shared.programs.pending() != request)
            return; // a state or a newer request has arrived
        const auto loaded = loadProgram(index, request);
        if (!loaded)
            session.fail(loaded.error().message);
        if (isForMidi) // before reporting, which may take long
            shared.programs.end(request, loaded.has_value());
        if (!loaded || !*loaded)
            return;
    }
    if (isForMidi)
        shared.reporter.reportSound();
    else
        shared.reporter.reportChosenProgram();
}

/// Call with the lock. Values moved since MIDI's request are kept, as in an offline render, where
/// the program loads at once. Returns false if MIDI has asked for another program meanwhile.
Result<bool> HostSession::loadProgram(int index, ProgramChanges::Request request) {
    const auto& preset = factoryPresets()[static_cast<std::size_t>(index)];
    auto sound = factorySound(preset);
    if (!sound)
        return tl::unexpected(sound.error());
    const auto* moment = shared.programs.momentOf(request);
    if (moment != nullptr && moment->soundChanges != shared.messages.soundChanges)
        moment = nullptr;
    const auto wanted = [&] {
        const auto values = withSetupOf(shared.parameters.values(), preset.parameters);
        return moment != nullptr ? shared.parameters.withMoved(moment->moves, values) : values;
    };
    auto player = session.newPlayer(sound->instrument, sound->preset, wanted());
    if (!player)
        return tl::unexpected(player.error());
    if (request == ProgramChanges::none) {
        shared.loads.count();
    } else {
        if (shared.programs.pending() != request)
            return false;
        shared.programs.answer(request);
        auto before = session.soundNow();
        if (moment != nullptr)
            before.parameters = moment->values;
        shared.loads.keepBeforePrograms(std::move(before));
    }
    session.play(std::move(*sound), std::move(*player), [&] { shared.parameters.load(wanted()); });
    return true;
}

} // namespace idiophone
