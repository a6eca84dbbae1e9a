#include "Parameters/EmbeddedNames.h"
#include "Parameters/ModulationTable.h"
#include "Parameters/ParameterTable.h"

#include <algorithm>
#include <vector>

namespace idiophone {
namespace {

using enum ParameterId;
using enum ParameterScale;

constexpr std::array<ParameterInfo, parameterCount> rows{{
#define PARAMETER(symbol, ...) {.parameter = symbol, __VA_ARGS__},
#include "Parameters/ParameterRows.def"
#undef PARAMETER
}};

constexpr std::array<std::string_view, 5> contactNames{"Strike", "Scrape", "Roll", "Bow", "Rub"};

constexpr std::array<std::string_view, outputChoices> outputsNames{"Main only", "Kit parts",
                                                                   "Octaves", "Keys"};

// Append only: hosts store the position.
constexpr std::array<std::string_view, 9> motorSyncNames{"Free",  "1/1", "1/2",   "1/2 T", "1/4",
                                                         "1/4 T", "1/8", "1/8 T", "1/16"};
constexpr std::array<double, motorSyncNames.size()> motorSyncLengths{
    0, 4, 2, 4.0 / 3, 1, 2.0 / 3, 0.5, 1.0 / 3, 0.25};

// The same order as in ModulationTable.
constexpr std::array<std::string_view, 11> lfoSyncNames{
    "Free", "4/1", "2/1", "1/1", "1/2", "1/2 T", "1/4", "1/4 T", "1/8", "1/8 T", "1/16"};
constexpr std::array<std::string_view, 6> lfoShapeNames{"Sine",   "Triangle", "Square",
                                                        "Rising", "Falling",  "Random"};
constexpr std::array<std::string_view, static_cast<std::size_t>(ModulationSource::count)>
    sourceNames{"None", "LFO 1",    "LFO 2", "Envelope", "Velocity",
                "Key",  "Pressure", "Wheel", "Random"};

std::vector<std::string_view> targetNames() {
    std::vector<std::string_view> names{"None"};
    for (const auto target : modulationTargets())
        names.emplace_back(rows[static_cast<std::size_t>(target)].name);
    return names;
}

/// Returns the names of a choice of modulation, or nothing for other parameters.
std::span<const std::string_view> modulationNames(ParameterId parameter) {
    static const auto namesOfTargets = targetNames();
    for (const auto& lfo : lfoParameters) {
        if (parameter == lfo.sync)
            return lfoSyncNames;
        if (parameter == lfo.shape)
            return lfoShapeNames;
    }
    for (const auto& route : modulationRoutes) {
        if (parameter == route.source)
            return sourceNames;
        if (parameter == route.target)
            return namesOfTargets;
    }
    return {};
}

std::vector<std::string_view> with(std::vector<std::string_view> names,
                                   std::span<const std::string_view> ofLibrary) {
    names.insert(names.end(), ofLibrary.begin(), ofLibrary.end());
    return names;
}

} // namespace

std::span<const ParameterInfo> parameterTable() {
    static const auto table = [] {
        auto counted = rows;
        for (auto& row : counted)
            if (row.scale == choice)
                row.maximum = static_cast<double>(choiceNames(row.parameter).size() - 1);
        return counted;
    }();
    return table;
}

std::span<const std::string_view> choiceNames(ParameterId parameter) {
    static const auto materialNames = with({"Own", "Custom"}, embeddedMaterialsNames());
    static const auto malletNames = with({"Custom"}, embeddedMalletsNames());
    if (parameter == material)
        return materialNames;
    if (parameter == mallet)
        return malletNames;
    if (parameter == contact)
        return contactNames;
    if (parameter == motorSync)
        return motorSyncNames;
    if (parameter == outputs)
        return outputsNames;
    return modulationNames(parameter);
}

double motorSyncBeats(int choice) {
    const auto index = static_cast<std::size_t>(std::max(choice, 0));
    return index < motorSyncLengths.size() ? motorSyncLengths[index] : 0;
}

} // namespace idiophone
