// Fuzzes the state that a host gives to the plugin when a project opens: reads, plays and saves it.
//
// Input: a saved state, then optionally a zero byte and the .modal file of the object that its keys
// play. Skips factory objects and scenes, because they take seconds to build here.
#include "Plugin/State.h"
#include "Fuzz/FuzzTarget.h"
#include "Object/ModalObjectFile.h"
#include "Plugin/Processor.h"
#include "Support/SyntheticObject.h"

#include <cstdlib>
#include <juce_events/juce_events.h>
#include <vector>

namespace idiophone::fuzz {
namespace {

constexpr int blockSamples = 512, blocks = 4;

void claimRead(const State& state) {
    for (const auto& info : parameterTable()) {
        const double value = state.parameters[info.parameter];
        claim(value == info.clamped(value), "parameters have values that they can take");
        const int controller = state.controllers[info.parameter];
        claim(controller == noController || isLearnable(controller), "controllers can be learned");
    }
    for (const auto& object : state.objects)
        claim(!object.modal.empty(), "objects have bytes");
    const auto written = encodeState(state);
    const auto again = parseState(written);
    claim(again && *again == state, "a state that was written reads back equal");
    claim(encodeState(*again) == written, "an equal state is written as the same bytes");
}

std::string saved(Processor& processor) {
    juce::MemoryBlock block;
    processor.getStateInformation(block);
    return {static_cast<const char*>(block.getData()), block.getSize()};
}

/// Claims that the saved state equals the given one; objects may be packed differently.
void claimKept(const State& given, const std::string& bytes) {
    const auto kept = parseState(bytes);
    claim(kept.has_value(), "what was saved can be read");
    claim(kept->parameters == given.parameters && kept->preset == given.preset &&
              kept->controllers == given.controllers && kept->tuning == given.tuning,
          "what was restored is saved as it was");
}

/// Restores a state and returns whether the processor took it. Claims that a refused state changes
/// nothing.
bool restored(Processor& processor, const std::string& bytes) {
    const auto before = saved(processor);
    processor.setStateInformation(bytes.data(), static_cast<int>(bytes.size()));
    const auto status = processor.view().status.takeStatus();
    if (!status.isError)
        return true;
    claimSentence({status.sentence});
    claim(saved(processor) == before, "a state that cannot be restored changes nothing");
    return false;
}

void claimPlays(Processor& processor) {
    const auto keys = processor.view().instrument.keyRange();
    juce::AudioBuffer<float> buffer(2, blockSamples);
    for (int block = 0; block < blocks; ++block) {
        juce::MidiBuffer midi;
        if (block == 0)
            for (const int note : {keys.lowest, (keys.lowest + keys.highest) / 2, keys.highest}) {
                midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{110}), note);
                midi.addEvent(juce::MidiMessage::controllerEvent(1, 1, 90), note);
                midi.addEvent(juce::MidiMessage::pitchWheel(1, 100 * note), note);
            }
        if (block == 2)
            midi.addEvent(juce::MidiMessage::noteOff(1, keys.highest), 7);
        processor.processBlock(buffer, midi);
        for (int channel = 0; channel < 2; ++channel)
            claimFinite(std::span(buffer.getReadPointer(channel), std::size_t{blockSamples}),
                        "what is restored sounds finite");
    }
}

EmbeddedObject object(std::vector<std::byte> modal) {
    return {.name = "own", .modal = std::move(modal)};
}

/// Returns the state with one object for all keys: from the bytes behind the state, else its first
/// object, else a small one. Limits the number of keys if each has an object.
State withOneObject(State state, std::string_view behind) {
    const auto given = asBytes(behind);
    if (!given.empty())
        state.objects = {object({given.begin(), given.end()})};
    else if (state.objects.empty())
        state.objects = {object(encodeModalObject(test::syntheticObject({440, 1000})))};
    state.objects.resize(1);
    auto& map = state.preset.keyMap;
    state.objects.front().name = map.object = "own";
    if (map.kind == KeyMapKind::bars)
        map.highestNote = std::min(map.highestNote, map.lowestNote + 7);
    map.resizedFrom = std::max(map.resizedFrom, map.lowestNote - 2);
    map.resizedTo = std::min(map.resizedTo, map.highestNote + 2);
    return state;
}

/// Returns one prepared processor for all inputs, like a host that opens one project after another.
/// The processor lives as long as the process.
Processor& sharedProcessor() {
    static Processor& processor = []() -> Processor& {
        // Read no files of the user.
        const auto settings = scratchFile({}, "settings").parent_path();
        claim(setenv("XDG_CONFIG_HOME", settings.c_str(), 1) == 0, "settings lie apart");
        [[maybe_unused]] static const auto* juce = new juce::ScopedJuceInitialiser_GUI;
        static auto* made = new Processor;
        made->prepareToPlay(24000, blockSamples);
        return *made;
    }();
    return processor;
}

} // namespace

void examine(std::string_view bytes) {
    const auto end = std::min(bytes.find('\0'), bytes.size());
    const auto read = parseState(bytes.substr(0, end));
    if (!read)
        return claimSentence(read.error());
    claimRead(*read);
    if (read->preset.keyMap.kind == KeyMapKind::scene)
        return;
    const auto state = withOneObject(*read, bytes.substr(std::min(end + 1, bytes.size())));

    auto& processor = sharedProcessor();
    processor.reset();
    if (!restored(processor, encodeState(state)))
        return;
    claimPlays(processor);
    const auto kept = saved(processor);
    claimKept(state, kept);
    claim(restored(processor, kept) && saved(processor) == kept,
          "what was saved is restored and saved as it was");
}

} // namespace idiophone::fuzz
