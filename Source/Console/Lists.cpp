#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Parameters/ParameterTable.h"
#include "Scene/FactoryScenes.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>

namespace idiophone {
namespace {

using nlohmann::ordered_json;

constexpr std::array<const char*, 6> scaleNames{"linear", "logarithmic", "steps",
                                                "on-off", "choice",      "cubic"};

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
                        {"scale", scaleNames[static_cast<std::size_t>(info.scale)]},
                        {"minimum", info.minimum},
                        {"maximum", info.maximum},
                        {"default", info.defaultValue},
                        {"range_text", rangeOf(info)},
                        {"default_text", formatParameter(info, info.defaultValue)},
                        {"version_added", info.versionAdded},
                        {"description", info.description}};
    if (const auto names = choiceNames(info.parameter); !names.empty())
        result["choices"] = names;
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

/// A column that wide, of UTF-8 text.
std::string column(const std::string& text, std::size_t width) {
    const auto characters = static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
    return text + std::string(width > characters ? width - characters : 0, ' ');
}

void printParameters() {
    for (const auto& info : parameterTable())
        std::cout << column(info.id, 16) << column(rangeOf(info), 30)
                  << column(formatParameter(info, info.defaultValue), 14) << info.description
                  << '\n';
    for (const auto& info : parameterTable()) {
        if (info.scale != ParameterScale::choice)
            continue;
        std::cout << info.id << " is one of";
        const char* separator = " ";
        for (const auto name : choiceNames(info.parameter))
            std::cout << std::exchange(separator, ", ") << name;
        std::cout << '\n';
    }
}

void addList(CLI::App& program,
             Action& chosen,
             const char* name,
             const char* description,
             ordered_json (*describeAll)(),
             void (*printAll)()) {
    auto* command = program.add_subcommand(name, description);
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "The list as JSON");
    command->final_callback([=, &chosen] {
        chosen = [=]() -> Result<void> {
            if (*json)
                std::cout << jsonText(describeAll());
            else
                printAll();
            return {};
        };
    });
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
        std::cout << column(scene.name, 22) << scene.description << '\n';
}

} // namespace

void addLists(CLI::App& program, Action& chosen) {
    addList(program, chosen, "parameters", "Lists the parameters that --set takes",
            describeParameters, printParameters);
    addList(program, chosen, "scenes", "Lists the factory scenes", describeScenes, printScenes);
}

} // namespace idiophone
