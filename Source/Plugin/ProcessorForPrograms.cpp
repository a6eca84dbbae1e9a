// Which preset is the program, as hosts and MIDI ask for it, and that hosts hear of another sound.
#include "Editor/Utf8.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/Processor.h"

#include <utility>

namespace idiophone {

// To a VST3 host a program is a share of their number, and one that is current cannot be chosen: so
// that number never changes, and the last program is any sound that is none of the factory's.

int Processor::getNumPrograms() {
    return isVst3() ? vst3Programs : static_cast<int>(factoryPresets().size());
}

int Processor::getCurrentProgram() {
    const int index = programIndex;
    return index >= 0 ? index : isVst3() ? vst3Programs - 1 : 0;
}

const juce::String Processor::getProgramName(int index) {
    const auto presets = factoryPresets();
    if (index < 0 || index >= getNumPrograms())
        return {};
    if (index < static_cast<int>(presets.size()))
        return fromUtf8(presets[static_cast<std::size_t>(index)].name);
    return index == vst3Programs - 1 ? juce::String("Own sound")
                                     : fromUtf8("\xe2\x80\x93 unused " + std::to_string(index));
}

void Processor::setCurrentProgram(int index) {
    chooseProgram(index, noRequest);
}

/// For MIDI's request of that number, or the host's own.
void Processor::chooseProgram(int index, std::int64_t request) {
    if (index < 0 || index >= static_cast<int>(factoryPresets().size()))
        return;
    {
        const std::scoped_lock lock(soundMutex);
        if (request != noRequest && requestedProgram != request)
            return; // a state or another request has come since
        const auto loaded = loadProgram(index, request);
        if (!loaded)
            lastError = loaded.error().message;
        if (request != noRequest) {
            if (!loaded)
                refusedRequest = request; // for the audio thread, which forgets the keys that wait
            // Before anybody is told, which may take long; unless another came meanwhile.
            requestedProgram.compare_exchange_strong(request, noRequest);
        }
        if (!loaded || !*loaded)
            return;
    }
    tellOfSound();
}

/// The host of all values and of the program. On a thread that is not the message thread JUCE's
/// VST3 keeps the values for the next callback's output, but asks the host on the message thread to
/// read all values anew. Where that comes second, it finds the former ones in the controller, and
/// Ardour sends them back as changes: so there they are told again, before the program. And a host
/// that reads them anew while another of its threads moves them may keep what it read, as JUCE's
/// does: so what has moved by one of the next looks is told.
void Processor::tellOfSound() {
    const bool isMessageThread = juce::MessageManager::existsAndIsCurrentThread();
    parameters.notifyListeners();
    if (isNonRealtime() || !isMessageThread)
        parameters.forgetTold(); // in an offline render nothing is an echo
    if (isMessageThread) {
        updateHostDisplay(ChangeDetails().withProgramChanged(true));
        movedToTell = isNonRealtime() ? 0 : 2; // looks, the first of which may come at once
        return;
    }
    if (wrapperType == wrapperType_LV2)
        return; // which has but one way to its host, and hears of no program
    // Twice: the wrapper passes nothing on until some time after a state is restored.
    soundToTell = 2;
    if (looks)
        looks->callSoon();
}

/// Under soundMutex. What has moved since MIDI asked for it is the program's: so it is offline,
/// where it is there at once. False where MIDI has asked for another meanwhile, which comes
/// instead.
Result<bool> Processor::loadProgram(int index, std::int64_t request) {
    const auto& preset = factoryPresets()[static_cast<std::size_t>(index)];
    auto built = buildInstrument(preset.keyMap, {});
    if (!built)
        return failure(preset.name + " cannot be played: " + built.error().message);
    if (const auto* newest = movesAtRequest.take())
        atLastRequest = *newest;
    const bool keepsMoved = request != noRequest && atLastRequest.request == request &&
                            atLastRequest.soundChanges == soundChanges;
    const auto wanted = [&] {
        const auto values = withSetupOf(parameters.values(), preset.parameters);
        return keepsMoved ? parameters.withMoved(atLastRequest.moves, values) : values;
    };
    auto player = newPlayer(*built, preset, wanted());
    if (!player)
        return tl::unexpected(player.error());
    if (request != noRequest && requestedProgram != request)
        return false;
    if (request == noRequest) {
        countHostLoad();
    } else {
        answeredRequest = request;
        if (!soundBeforePrograms) {
            soundBeforePrograms = soundNow();
            if (keepsMoved)
                soundBeforePrograms->parameters = atLastRequest.values;
        }
    }
    play(preset, std::move(*built), std::move(*player), [&] { parameters.load(wanted()); });
    programIndex = index;
    presetId = factoryPresetId(preset.name);
    return true;
}

void Processor::followProgramChange() {
    if (const auto request = requestedProgram.load(); request != noRequest)
        chooseProgram(static_cast<int>(request % programsOfMidi), request);
}

} // namespace idiophone
