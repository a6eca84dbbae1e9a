// Maps presets to programs for hosts and MIDI, and reports new sounds to the host.
#include "Editor/Utf8.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/ObjectEmbedding.h"
#include "Plugin/Processor.h"

#include <utility>

namespace idiophone {

// A VST3 host sees a program as a fraction of the number of programs, and cannot choose the current
// one again. So the number never changes, and the last program stands for any sound that is not a
// factory preset.

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

/// Loads a program for MIDI's request, or for the host if `request` is `noRequest`.
void Processor::chooseProgram(int index, std::int64_t request) {
    if (index < 0 || index >= static_cast<int>(factoryPresets().size()))
        return;
    {
        const std::scoped_lock lock(soundMutex);
        if (request != noRequest && requestedProgram != request)
            return; // a state or a newer request has arrived
        const auto loaded = loadProgram(index, request);
        if (!loaded)
            lastError = loaded.error().message;
        if (request != noRequest) {
            if (!loaded)
                refusedRequest = request; // the audio thread then forgets the pending keys
            // Clear the request before reporting, which may take long, unless a newer one has
            // arrived.
            requestedProgram.compare_exchange_strong(request, noRequest);
        }
        if (!loaded || !*loaded)
            return;
    }
    tellOfSound();
}

/// Reports all values and the program to the host.
/// Off the message thread, JUCE's VST3 keeps the values for the next callback's output, but asks
/// the host on the message thread to read all values anew. If the host reads first, it finds the
/// former values in the controller, and Ardour sends them back as changes. So the message thread
/// reports them again, before the program. A host that reads the values while another of its
/// threads moves them may keep the values read, as JUCE's does. So the next polls report the values
/// that moved.
void Processor::tellOfSound() {
    const bool isMessageThread = juce::MessageManager::existsAndIsCurrentThread();
    parameters.notifyListeners();
    if (isNonRealtime() || !isMessageThread)
        parameters.forgetTold(); // offline, no value from the host is an echo
    if (isMessageThread) {
        updateHostDisplay(ChangeDetails().withProgramChanged(true));
        movedToTell = isNonRealtime() ? 0 : 2; // polls; the first may follow at once
        return;
    }
    if (wrapperType == wrapperType_LV2)
        return; // LV2 reports values only this way, and no program
    // Report twice: the wrapper reports nothing until some time after a state is restored.
    soundToTell = 2;
    if (looks)
        looks->callSoon();
}

/// Call under soundMutex. Values moved since MIDI's request are kept, as in an offline render,
/// where the program is there at once. Returns false if MIDI has asked for another program
/// meanwhile.
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
