#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/TextColumns.h"
#include "Object/NumberText.h"
#include "Parameters/ParameterTable.h"
#include "Scene/FactoryScenes.h"

#include <algorithm>
#include <iostream>
#include <string>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

std::string rangeOf(const ParameterInfo& info) {
    if (info.scale == ParameterScale::onOff)
        return "Off, On";
    if (!choiceNames(info.parameter).empty())
        return "a name";
    return formatParameter(info, info.minimum) + " to " + formatParameter(info, info.maximum);
}

ordered_json describe(const ParameterInfo& info) {
    ordered_json result{{"id", info.id},
                        {"name", info.name},
                        {"group", info.group},
                        {"unit", info.unit},
                        {"physical", info.isPhysical},
                        {"scale", scaleName(info.scale)},
                        {"minimum", info.minimum},
                        {"maximum", info.maximum},
                        {"default", info.defaultValue},
                        {"range_text", rangeOf(info)},
                        {"default_text", formatParameter(info, info.defaultValue)},
                        {"description", info.description}};
    if (const auto names = choiceNames(info.parameter); !names.empty())
        result["choices"] = names;
    if (info.minimumName != nullptr)
        result["minimum_name"] = info.minimumName;
    if (info.maximumName != nullptr)
        result["maximum_name"] = info.maximumName;
    return result;
}

ordered_json describeParameters() {
    ordered_json list = ordered_json::array();
    for (const auto& info : parameterTable())
        list.push_back(describe(info));
    return list;
}

/// Returns the range for people, without repeating the unit.
std::string shortRange(const ParameterInfo& info) {
    if (info.scale == ParameterScale::onOff)
        return "On or Off";
    if (const auto names = choiceNames(info.parameter); !names.empty())
        return "one of " + std::to_string(names.size()) + " below";
    const auto most = info.maximumName != nullptr ? info.maximumName : numberText(info.maximum);
    const auto least = info.minimumName != nullptr ? info.minimumName : numberText(info.minimum);
    const std::string unit = info.unit;
    return least + " to " + most + (unit.empty() ? "" : " " + unit);
}

std::string shortDefault(const ParameterInfo& info) {
    const bool isName = info.scale == ParameterScale::onOff || info.scale == ParameterScale::choice;
    return isName ? formatParameter(info, info.defaultValue) : numberText(info.defaultValue);
}

/// Returns the first parameter with the same choices.
const ParameterInfo& firstWithChoicesOf(const ParameterInfo& info) {
    return *std::ranges::find_if(parameterTable(), [&](const ParameterInfo& other) {
        return choiceNames(other.parameter).data() == choiceNames(info.parameter).data();
    });
}

void printParameters() {
    const auto print = [](std::string_view id, std::string_view range, std::string_view value,
                          std::string_view description) {
        const auto figures = leftColumn(id, 16) + leftColumn(range, 20) + leftColumn(value, 9);
        std::cout << figures << paragraph(description, 45);
    };
    print("id", "range", "default", "effect");
    for (const auto& info : parameterTable())
        print(info.id, shortRange(info), shortDefault(info), info.description);
    for (const auto& info : parameterTable()) {
        if (info.scale != ParameterScale::choice)
            continue;
        if (const auto& first = firstWithChoicesOf(info); first.parameter != info.parameter) {
            std::cout << leftColumn(info.id, 16) << "as " << first.id << '\n';
            continue;
        }
        std::string names;
        for (const auto name : choiceNames(info.parameter)) // some names contain commas
            names += (names.empty() ? "" : "; ") + std::string(name);
        std::cout << '\n' << leftColumn(info.id, 16) << paragraph(names, 16);
    }
}

ordered_json describeScenes() {
    ordered_json list = ordered_json::array();
    for (const auto& scene : factoryScenes())
        list.push_back({{"name", scene.name},
                        {"description", scene.description},
                        {"seconds", scene.seconds},
                        {"takes_midi", scene.noteDrop.has_value()}});
    return list;
}

void printScenes() {
    for (const auto& scene : factoryScenes())
        std::cout << leftColumn(scene.name, 22) << paragraph(scene.description, 22);
}

struct ListOptions {
    bool json = false;
};

template <ordered_json (*describeAll)(), void (*printAll)()>
void addList(CLI::App& program, Action& chosen, const char* name, const char* description) {
    const auto [command, options] = addCommand<ListOptions>(
        program, chosen, name, description, [](const ListOptions& wanted) -> Result<void> {
            if (wanted.json)
                std::cout << jsonText(describeAll());
            else
                printAll();
            return {};
        });
    command->add_flag("--json", options->json, "Writes the list as JSON");
}

} // namespace

void addLists(CLI::App& program, Action& chosen) {
    addList<describeParameters, printParameters>(program, chosen, "parameters",
                                                 "Lists the parameters that --set takes");
    addList<describeScenes, printScenes>(program, chosen, "scenes", "Lists the factory scenes");
}

} // namespace idiophone
