#include "Plugin/HostSession.h"

#include "Instrument/FactoryContent.h"
#include "Object/OneLine.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/WithinMemory.h"

#include <algorithm>
#include <utility>

namespace idiophone {

HostSession::HostSession(HostParameters& hostParameters,
                         EngineMessages& engineMessages,
                         ProgramChanges& programChanges,
                         HostReporter& hostReporter,
                         HostLoads& hostLoads,
                         SoundSession& soundSession,
                         TuningSession& tuningSession)
    : parameters(hostParameters), messages(engineMessages), programs(programChanges),
      reporter(hostReporter), loads(hostLoads), session(soundSession), tuning(tuningSession) {}

std::string HostSession::save() {
    Sound sound;
    State state;
    {
        const auto held = session.lock();
        sound = session.soundNow();
        state.controllers = messages.controllers.assignments();
        state.tuning = tuning.files();
    }
    // Pack without the lock: objects never saved before take a while to pack.
    state.parameters = sound.parameters;
    state.preset = std::move(sound.preset);
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
    reporter.beginRestoring();
    const auto restored = withinMemory(
        [&] {
            return parseState(bytes).and_then([this](const State& state) { return play(state); });
        },
        "The saved state");
    reporter.endRestoring();
    if (restored)
        reporter.reportSound();
    else
        session.reportError(restored.error().message);
}

Result<void> HostSession::play(const State& state) {
    const auto keys = keyTuning(state.tuning);
    if (!keys)
        return failure("The saved state has a fault in its tuning: " + keys.error().message);
    Sound sound{.preset = state.preset,
                .instrument = nullptr,
                .parameters = state.parameters,
                .missing = nullptr,
                .presetId = {},
                .stored = state.preset.parameters};
    sound.missing = replaceMissing(sound.preset, state.objects);
    const auto held = session.lock();
    auto built = buildInstrument(sound.preset.keyMap, state.objects);
    if (!built)
        return failure("The saved state cannot be played: " + built.error().message);
    auto player = session.newPlayer(*built, sound.preset, state.parameters);
    if (!player)
        return tl::unexpected(player.error());
    programs.cancel();
    for (const auto& factory : factoryPresets())
        if (factory.name == state.preset.name && factory.keyMap == state.preset.keyMap)
            sound.presetId = factoryPresetId(factory.name);
    sound.instrument = std::move(*built);
    auto tuningFiles = state.tuning;
    const auto missing = sound.missing;
    session.play(std::move(sound), std::move(*player), [&] {
        tuning.tuneTo(std::move(tuningFiles), *keys);
        messages.tuner.forgetMessages(); // a state holds no tuning messages
        messages.forgetsGivenBends = true;
        messages.controllers.assign(state.controllers);
        parameters.load(state.parameters);
    });
    loads.count();
    if (missing != nullptr)
        session.fail((state.preset.name.empty() ? "" : oneLine(state.preset.name) + ": ") +
                     missing->first +
                     " is missing; until it is back a steel ring plays in its place.");
    return {};
}

void HostSession::followRequest() {
    if (const auto request = programs.pending(); request != ProgramChanges::none)
        chooseProgram(ProgramChanges::programOf(request), request);
}

/// Loads a program for MIDI's request, or for the host if there is none.
void HostSession::chooseProgram(int index, ProgramChanges::Request request) {
    const bool isForMidi = request != ProgramChanges::none;
    if (index < 0 || index >= static_cast<int>(factoryPresets().size()))
        return;
    {
        const auto held = session.lock();
        if (isForMidi && programs.pending() != request)
            return; // a state or a newer request has arrived
        const auto loaded = loadProgram(index, request);
        if (!loaded)
            session.fail(loaded.error().message);
        if (isForMidi) // before reporting, which may take long
            programs.end(request, loaded.has_value());
        if (!loaded || !*loaded)
            return;
    }
    reporter.reportSound();
}

/// Call with the lock. Values moved since MIDI's request are kept, as in an offline render, where
/// the program loads at once. Returns false if MIDI has asked for another program meanwhile.
Result<bool> HostSession::loadProgram(int index, ProgramChanges::Request request) {
    const auto& preset = factoryPresets()[static_cast<std::size_t>(index)];
    auto built = buildInstrument(preset.keyMap, {});
    if (!built)
        return failure(preset.name + " cannot be played: " + built.error().message);
    const auto* moment = programs.momentOf(request);
    if (moment != nullptr && moment->soundChanges != messages.soundChanges)
        moment = nullptr;
    const auto wanted = [&] {
        const auto values = withSetupOf(parameters.values(), preset.parameters);
        return moment != nullptr ? parameters.withMoved(moment->moves, values) : values;
    };
    auto player = session.newPlayer(*built, preset, wanted());
    if (!player)
        return tl::unexpected(player.error());
    if (request == ProgramChanges::none) {
        loads.count();
    } else {
        if (programs.pending() != request)
            return false;
        programs.answer(request);
        loads.keepBeforePrograms([&] {
            auto before = session.soundNow();
            if (moment != nullptr)
                before.parameters = moment->values;
            return before;
        });
    }
    session.play({.preset = preset,
                  .instrument = std::move(*built),
                  .parameters = preset.parameters,
                  .missing = nullptr,
                  .presetId = factoryPresetId(preset.name),
                  .stored = preset.parameters},
                 std::move(*player), [&] { parameters.load(wanted()); });
    return true;
}

} // namespace idiophone
