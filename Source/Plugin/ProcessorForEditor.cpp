// What the processor is to the window.
#include "Editor/EditorWindow.h"
#include "Plugin/Processor.h"

#include "Instrument/FactoryContent.h"

namespace idiophone {

juce::AudioProcessorEditor* Processor::createEditor() {
    return new EditorWindow(*this, *this);
}

std::vector<std::string> Processor::presetNames() const {
    std::vector<std::string> names;
    for (const auto& preset : factoryPresets())
        names.push_back(preset.name);
    return names;
}

double Processor::parameterValue(ParameterId parameter) const {
    return parameters[parameter].exactValue();
}

void Processor::beginParameterChange(ParameterId parameter) {
    parameters[parameter].beginChangeGesture();
}

void Processor::changeParameter(ParameterId parameter, double value) {
    auto& changed = parameters[parameter];
    changed.setExactValue(value);
    changed.sendValueChangedMessageToListeners(changed.getValue());
}

void Processor::endParameterChange(ParameterId parameter) {
    parameters[parameter].endChangeGesture();
}

void Processor::playNote(int midiNote, int velocity) {
    editorNotes.push(midiNote, velocity);
}

ProcessorView::KeyRange Processor::keyRange() const {
    const std::scoped_lock lock(soundMutex);
    return {.lowest = loadedPreset.keyMap.lowestNote, .highest = loadedPreset.keyMap.highestNote};
}

ProcessorView::Status Processor::takeStatus() {
    Status status{
        .sentence = {}, .isError = false, .modesMixed = modesMixed, .peak = peak.exchange(0)};
    const std::scoped_lock lock(soundMutex);
    status.isError = !lastError.empty();
    status.sentence = status.isError ? lastError : loadedPreset.description;
    return status;
}

std::shared_ptr<const Instrument> Processor::loadedInstrument() const {
    const std::scoped_lock lock(soundMutex);
    return instrument;
}

} // namespace idiophone
