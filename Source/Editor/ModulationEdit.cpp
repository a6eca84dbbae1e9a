#include "Editor/ModulationEdit.h"

#include "Editor/NamedEdit.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <vector>

namespace idiophone {
namespace {

constexpr double firstAmountPercent = 25;
constexpr const char* stepName = "Modulation";

bool isFree(const ParameterView& parameters, const ModulationRoute& route) {
    return parameters.value(route.source) == 0 || parameters.value(route.target) == 0;
}

juce::String sourceName(const ParameterView& parameters, const ModulationRoute& route) {
    return fromUtf8(formatParameter(parameterInfo(route.source), parameters.value(route.source)));
}

std::vector<ModulationRoute> routesTo(const ParameterView& parameters, ParameterId target) {
    std::vector<ModulationRoute> found;
    const int choice = modulationTargetChoice(target);
    std::ranges::copy_if(modulationRoutes, std::back_inserter(found), [&](const auto& route) {
        return choice != 0 && !isFree(parameters, route) &&
               parameters.value(route.target) == choice;
    });
    return found;
}

void addRoute(ProcessorView& view, ParameterId target, int source) {
    auto& parameters = view.parameters;
    const auto route = std::ranges::find_if(
        modulationRoutes, [&](const auto& each) { return isFree(parameters, each); });
    if (route == modulationRoutes.end())
        return;
    const NamedEdit step(view.history, stepName);
    parameters.changeOnce(route->source, source);
    parameters.changeOnce(route->target, modulationTargetChoice(target));
    parameters.changeOnce(route->amount, firstAmountPercent);
    parameters.makeCustom(target); // else a figure would have no effect
}

} // namespace

std::optional<ModulatedRange> shownModulation(const ParameterView& parameters, ParameterId target) {
    if (routesTo(parameters, target).empty())
        return std::nullopt;
    ParameterValues values;
    for (const auto& route : modulationRoutes)
        for (const auto each : {route.source, route.target, route.amount})
            values.set(each, parameters.value(each));
    values.set(target, parameters.effectiveValue(target));
    return modulatedRange(values, target);
}

juce::String modulationSentence(const ParameterView& parameters, ParameterId target) {
    juce::StringArray names;
    for (const auto& route : routesTo(parameters, target))
        names.addIfNotAlreadyThere(sourceName(parameters, route));
    return names.isEmpty() ? juce::String() : "Modulated by " + names.joinIntoString(" and ");
}

void addModulationItems(juce::PopupMenu& menu, ParameterId target, ProcessorView& view) {
    if (modulationTargetChoice(target) == 0)
        return;
    menu.addSeparator();
    const auto names = choiceNames(modulationRoutes.front().source);
    juce::PopupMenu sources;
    for (std::size_t source = 1; source < names.size(); ++source)
        sources.addItem(fromUtf8(names[source]), [&view, target, source] {
            addRoute(view, target, static_cast<int>(source));
        });
    const bool hasRoom = std::ranges::any_of(
        modulationRoutes, [&](const auto& route) { return isFree(view.parameters, route); });
    if (hasRoom)
        menu.addSubMenu("Modulate by", sources);
    else
        menu.addItem("All eight modulations are in use", false, false, nullptr);
    for (const auto& route : routesTo(view.parameters, target))
        menu.addItem("Forget modulation by " + sourceName(view.parameters, route), [&view, route] {
            const NamedEdit step(view.history, stepName);
            for (const auto each : {route.source, route.target, route.amount})
                view.parameters.changeOnce(each, 0);
        });
}

} // namespace idiophone
