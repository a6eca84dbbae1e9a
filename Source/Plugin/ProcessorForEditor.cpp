// What the processor is to the window.
#include "Editor/EditorWindow.h"
#include "Plugin/Processor.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/SettingsOfParameters.h"
#include "Object/MaterialFile.h"

#include <algorithm>

namespace idiophone {

juce::AudioProcessorEditor* Processor::createEditor() {
    history.endAllGestures();
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

bool Processor::isLive(ParameterId parameter) const {
    if (parameter != ParameterId::thickness)
        return true;
    const auto playing = loadedInstrument();
    return playing != nullptr && std::ranges::any_of(playing->slots(), [](const auto& slot) {
               return slot.object->hasLiveThickness();
           });
}

void Processor::beginParameterChange(ParameterId parameter) {
    history.beginGesture(parameter);
    parameters[parameter].beginChangeGesture();
}

void Processor::changeParameter(ParameterId parameter, double value) {
    history.willChange(parameter);
    auto& changed = parameters[parameter];
    changed.setExactValue(value);
    changed.sendValueChangedMessageToListeners(changed.getValue());
}

void Processor::endParameterChange(ParameterId parameter) {
    parameters[parameter].endChangeGesture();
    history.endGesture(parameter);
}

std::vector<std::string> Processor::readUserMaterials() {
    auto found = readMaterialFolder(userMaterialFolder());
    userMaterials = std::move(found.materials);
    if (!found.faults.empty()) {
        const std::scoped_lock lock(soundMutex);
        lastError = found.faults.front().message;
    }
    std::vector<std::string> names;
    for (const auto& material : userMaterials)
        names.push_back(material.name);
    return names;
}

int Processor::userMaterialIndex() const {
    if (userMaterials.empty())
        return -1;
    const auto now = parameters.values();
    const auto played = std::ranges::find_if(userMaterials, [&](const Material& material) {
        return withCustomMaterial(now, material) == now;
    });
    return played == userMaterials.end()
               ? -1
               : static_cast<int>(std::distance(userMaterials.begin(), played));
}

void Processor::chooseUserMaterial(int index) {
    if (index < 0 || index >= static_cast<int>(userMaterials.size()))
        return;
    const auto& chosen = userMaterials[static_cast<std::size_t>(index)];
    const auto wanted = withCustomMaterial(parameters.values(), chosen);
    const auto change = [&](ParameterId parameter) {
        beginParameterChange(parameter);
        changeParameter(parameter, wanted[parameter]);
        endParameterChange(parameter);
    };
    history.beginEdit(chosen.name);
    std::ranges::for_each(materialFigures, change);
    change(ParameterId::material); // last: what plays up to here keeps its own figures
    history.endEdit();
}

void Processor::playNote(int midiNote, int velocity) {
    editorNotes.push(midiNote, velocity);
}

ProcessorView::KeyRange Processor::keyRange() const {
    const std::scoped_lock lock(soundMutex);
    return {.lowest = loadedPreset.keyMap.lowestNote, .highest = loadedPreset.keyMap.highestNote};
}

std::vector<ProcessorView::PlayedObject> Processor::playedObjects() const {
    std::vector<PlayedObject> objects;
    const auto playing = loadedInstrument();
    if (playing == nullptr)
        return objects;
    for (const auto own : ownSlots(*playing)) {
        const auto& slot = playing->slots()[own];
        PlayedObject played{.object = slot.object,
                            .sizeRatio = slot.sizeRatio,
                            .lowestNote = 127,
                            .highestNote = 0};
        for (int note = 0; note < 128; ++note)
            if (const int index = playing->key(note).slot;
                index >= 0 &&
                playing->slots()[static_cast<std::size_t>(index)].object == slot.object) {
                played.lowestNote = std::min(played.lowestNote, note);
                played.highestNote = std::max(played.highestNote, note);
            }
        objects.push_back(std::move(played));
    }
    return objects;
}

void Processor::strikeObject(std::size_t index,
                             const std::array<double, 3>& pointMetres,
                             int velocity) {
    const auto playing = loadedInstrument();
    if (playing == nullptr)
        return;
    if (const auto slots = ownSlots(*playing); index < slots.size())
        hand.strike(playing, slots[index], pointMetres, velocity);
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
