// Implements the window's view of the processor.
#include "Editor/EditorWindow.h"
#include "Plugin/OwnSlots.h"
#include "Plugin/Processor.h"

#include "Instrument/SettingsOfParameters.h"
#include "Instrument/StrikePointMetres.h"
#include "Object/MaterialFile.h"

#include <algorithm>
#include <utility>

namespace idiophone {
namespace {

/// Returns the material of the playing instrument, or nullptr.
const Material* materialOf(const Instrument* playing) {
    return playing == nullptr || playing->slots().empty()
               ? nullptr
               : &playing->slots().front().object->material;
}

} // namespace

juce::AudioProcessorEditor* Processor::createEditor() {
    return new EditorWindow(*this, *this);
}

void Processor::windowClosed() {
    for (std::size_t i = 0; i < openGestures.size(); ++i)
        if (std::exchange(openGestures[i], 0) > 0)
            parameters[static_cast<ParameterId>(i)].endChangeGesture();
    history.endAllGestures();
}

double Processor::parameterValue(ParameterId parameter) const {
    return parameters[parameter].exactValue();
}

double Processor::effectiveValue(ParameterId parameter) const {
    if (choiceOfFigure(parameter) == nullptr)
        return parameterValue(parameter);
    const auto playing = loadedInstrument();
    return effectiveFigures(parameters.values(), materialOf(playing.get()))[parameter];
}

void Processor::makeCustom(ParameterId figure) {
    const auto* choice = choiceOfFigure(figure);
    if (choice == nullptr || parameterValue(choice->choice) == choice->custom)
        return;
    const auto playing = loadedInstrument();
    const auto wanted = withCustom(parameters.values(), *choice, materialOf(playing.get()));
    changeByHand(wanted, choice->figures);
    // Change the choice last: until then the sound keeps its own figures.
    changeByHand(wanted, std::array{choice->choice});
}

bool Processor::isLive(ParameterId parameter) const {
    if (parameter != ParameterId::thickness && parameter != ParameterId::keepPitch)
        return true;
    const auto playing = loadedInstrument();
    return playing != nullptr &&
           (parameter == ParameterId::thickness ? hasLiveThickness(playing->slots())
                                                : hasPitch(playing->slots()));
}

// A figure that makes a material custom changes within a gesture of its own. Only the outer gesture
// counts.
void Processor::beginParameterChange(ParameterId parameter) {
    if (openGestures[static_cast<std::size_t>(parameter)]++ > 0)
        return;
    history.beginGesture(parameter);
    parameters[parameter].beginChangeGesture();
}

void Processor::changeParameter(ParameterId parameter, double value) {
    history.willChange(parameter);
    auto& changed = parameters[parameter];
    changed.setExactValue(value);
    changed.tellListeners();
}

void Processor::endParameterChange(ParameterId parameter) {
    auto& open = openGestures[static_cast<std::size_t>(parameter)];
    if (open == 0 || --open > 0)
        return;
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
    return userMaterialNames();
}

std::vector<std::string> Processor::userMaterialNames() const {
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
    history.beginEdit(chosen.name);
    changeByHand(wanted, materialFigures);
    changeByHand(wanted, std::array{ParameterId::material}); // last, as in `makeCustom`
    history.endEdit();
}

void Processor::changeByHand(const ParameterValues& wanted, std::span<const ParameterId> changed) {
    for (const auto parameter : changed) {
        beginParameterChange(parameter);
        changeParameter(parameter, wanted[parameter]);
        endParameterChange(parameter);
    }
}

void Processor::lookForCallbacks() {
    if (const auto count = callbacks.load(); std::exchange(callbacksSeen, count) != count)
        lastCallbackMilliseconds = juce::Time::getMillisecondCounter();
}

bool Processor::isProcessing() const {
    // Twice the length of 8192 samples at 44.1 kHz.
    constexpr std::uint32_t longestPauseMilliseconds = 400;
    return callbacks != callbacksSeen ||
           juce::Time::getMillisecondCounter() - lastCallbackMilliseconds <
               longestPauseMilliseconds;
}

void Processor::playNote(int midiNote, int velocity) {
    if (velocity <= 0 || isProcessing())
        editorNotes.push(midiNote, velocity);
}

ProcessorView::KeyRange Processor::keyRange() const {
    const std::scoped_lock lock(soundMutex);
    return {.lowest = loadedPreset.keyMap.lowestNote, .highest = loadedPreset.keyMap.highestNote};
}

std::array<ProcessorView::KeySound, 128> Processor::keySounds() const {
    std::array<KeySound, 128> sounds{};
    if (const auto playing = loadedInstrument())
        for (int note = 0; note < 128; ++note)
            if (playing->key(note).slot >= 0)
                sounds[static_cast<std::size_t>(note)] =
                    playing->hasOwn(note) ? KeySound::own : KeySound::resized;
    return sounds;
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
            if (playing->hasOwn(note) &&
                playing->slots()[static_cast<std::size_t>(playing->key(note).slot)].object ==
                    slot.object) {
                played.lowestNote = std::min(played.lowestNote, note);
                played.highestNote = std::max(played.highestNote, note);
            }
        objects.push_back(std::move(played));
    }
    return objects;
}

bool Processor::hasStage() const {
    const auto playing = loadedInstrument();
    return playing != nullptr && playing->stage() != nullptr;
}

std::vector<BodyNow> Processor::stageBodies() const {
    std::vector<BodyNow> bodies;
    const auto playing = loadedInstrument();
    if (playing == nullptr || !playing->stage())
        return bodies;
    const auto objects = objectsOfSlots(*playing);
    const auto poses = playing->stage()->firstPoses();
    for (std::size_t slot = 0; slot < poses.size(); ++slot)
        if (poses[slot].isThere)
            bodies.push_back({.object = objects[slot],
                              .originMetres = poses[slot].originMetres,
                              .turn = poses[slot].turn});
    return bodies;
}

void Processor::resetStage() {
    stageResetRequested = true;
    capture.follow(loadedInstrument());
    capture.clear();
}

bool Processor::hasCaptured() {
    capture.follow(loadedInstrument());
    return capture.count() > 0;
}

bool Processor::writeCapture(CaptureKind kind, const std::filesystem::path& file) {
    constexpr double usualTempo = 120;
    capture.follow(loadedInstrument());
    const double beatsPerMinute = tempo > 0 ? tempo.load() : usualTempo;
    const auto written = kind == CaptureKind::midi ? capture.writeMidi(file, beatsPerMinute)
                                                   : capture.writeImpulses(file);
    if (!written)
        reportError("The capture was not written: " + written.error().message);
    return written.has_value();
}

std::vector<std::array<double, 3>> Processor::struckPlaces(std::size_t index) const {
    std::vector<std::array<double, 3>> places;
    const auto playing = loadedInstrument();
    if (playing == nullptr)
        return places;
    const auto slots = ownSlots(*playing);
    if (index >= slots.size())
        return places;
    const auto& object = *playing->slots()[slots[index]].object;
    for (int note = 0; note < 128; ++note) {
        const auto& key = playing->key(note);
        if (key.slot != static_cast<int>(slots[index]))
            continue;
        const auto& strip = playing->strip(key);
        for (int along = 0; along < strip.alongCount; ++along)
            places.push_back(strikePointMetres(
                object,
                strip.at(static_cast<double>(along) / std::max(strip.alongCount - 1, 1), 0)));
        break; // the keys of one object share its path
    }
    return places;
}

void Processor::strikeObject(std::size_t index,
                             const std::array<double, 3>& pointMetres,
                             int velocity) {
    const auto playing = loadedInstrument();
    if (playing == nullptr || (velocity > 0 && !isProcessing()))
        return;
    if (const auto slots = ownSlots(*playing); index < slots.size())
        hand.strike(playing, slots[index], pointMetres, velocity);
}

void Processor::scrapeObject(std::size_t index,
                             const std::array<double, 3>& pointMetres,
                             double pressure) {
    const auto playing = loadedInstrument();
    if (playing == nullptr || (pressure > 0 && !isProcessing()))
        return;
    if (const auto slots = ownSlots(*playing); index < slots.size())
        hand.scrape(playing, slots[index], pointMetres, pressure);
}

ProcessorView::Status Processor::takeStatus() {
    Status status{.sentence = {},
                  .isError = false,
                  .modesMixed = modesMixed,
                  .lateEvents = lateEvents,
                  .peak = peak.exchange(0)};
    const std::scoped_lock lock(soundMutex);
    if (instrument != nullptr && instrument->stage() != nullptr)
        status.delaySeconds = instrument->stage()->delaySeconds();
    status.isError = !lastError.empty();
    status.sentence = status.isError ? lastError : loadedPreset.description;
    return status;
}

void Processor::reportError(const std::string& sentence) {
    const std::scoped_lock lock(soundMutex);
    lastError = sentence;
}

std::shared_ptr<const Instrument> Processor::loadedInstrument() const {
    const std::scoped_lock lock(soundMutex);
    return instrument;
}

} // namespace idiophone
