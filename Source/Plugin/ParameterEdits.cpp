#include "Plugin/ParameterEdits.h"

#include "Instrument/SettingsOfParameters.h"

#include <array>

namespace idiophone {
namespace {

/// Returns the material of the playing instrument, or nullptr.
const Material* materialOf(const Instrument* playing) {
    return playing == nullptr || playing->slots().empty()
               ? nullptr
               : &playing->slots().front().object->material;
}

} // namespace

double ParameterEdits::effectiveValue(ParameterId parameter) const {
    if (choiceOfFigure(parameter) == nullptr)
        return value(parameter);
    const auto playing = session.instrument();
    return effectiveFigures(parameters.values(), materialOf(playing.get()))[parameter];
}

double ParameterEdits::presetValue(ParameterId parameter) const {
    const auto& info = parameterInfo(parameter);
    if (info.isSetup)
        return info.defaultValue;
    const auto playing = session.instrument();
    return effectiveFigures(session.presetValues(), materialOf(playing.get()))[parameter];
}

void ParameterEdits::makeCustom(ParameterId figure) {
    const auto* choice = choiceOfFigure(figure);
    if (choice == nullptr || value(choice->choice) == choice->custom)
        return;
    const auto playing = session.instrument();
    const auto wanted = withCustom(parameters.values(), *choice, materialOf(playing.get()));
    changeTo(wanted, choice->figures);
    // Change the choice last: until then the sound keeps its own figures.
    changeTo(wanted, std::array{choice->choice});
}

bool ParameterEdits::isLive(ParameterId parameter) const {
    if (parameter != ParameterId::thickness && parameter != ParameterId::keepPitch)
        return true;
    const auto playing = session.instrument();
    return playing != nullptr &&
           (parameter == ParameterId::thickness ? hasLiveThickness(playing->slots())
                                                : hasPitch(playing->slots()));
}

/// An effect's input is open from the start, and the side chain of an instrument is not.
bool ParameterEdits::isOffered(ParameterId parameter) const {
    using enum ParameterId;
    const auto* input = plugin.getBus(true, 0);
    if (parameter == dryWet)
        return input != nullptr && input->isEnabledByDefault();
    if (parameter == inputDrive || parameter == inputLowCut)
        return input != nullptr;
    return parameter != outputs || plugin.getBusCount(false) > 1;
}

// A figure that makes a material custom changes within a gesture of its own. Only the outer gesture
// counts.
void ParameterEdits::beginChange(ParameterId parameter) {
    if (!parameters[parameter].isInGesture())
        history.beginGesture(parameter);
    parameters[parameter].beginGesture();
}

void ParameterEdits::change(ParameterId parameter, double wanted) {
    history.willChange(parameter);
    parameters[parameter].setByHand(wanted);
}

void ParameterEdits::endChange(ParameterId parameter) {
    if (parameters[parameter].endGesture())
        history.endGesture(parameter);
}

void ParameterEdits::endAllChanges() {
    for (const auto& info : parameterTable())
        parameters[info.parameter].endAllGestures();
    history.endAllGestures();
}

void ParameterEdits::changeTo(const ParameterValues& wanted, std::span<const ParameterId> changed) {
    for (const auto parameter : changed) {
        beginChange(parameter);
        change(parameter, wanted[parameter]);
        endChange(parameter);
    }
}

} // namespace idiophone
