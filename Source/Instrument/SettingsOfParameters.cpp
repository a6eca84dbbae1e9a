#include "Instrument/SettingsOfParameters.h"

#include "Instrument/ContactLaw.h"
#include "Instrument/MalletStrike.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double pascalsPerGigapascal = 1e9, pascalsPerMegapascal = 1e6;
constexpr double secondsPerMicrosecond = 1e-6;

std::optional<LiveMaterial> liveMaterial(const ParameterValues& values) {
    if (static_cast<int>(values[material]) == customMaterial)
        return LiveMaterial{
            .youngsModulusPa = values[youngsModulus] * pascalsPerGigapascal,
            .densityKgPerM3 = values[density],
            .damping = {.fluidPerSecond = values[fluidDamping],
                        .viscoelasticSeconds = values[viscoelasticDamping] * secondsPerMicrosecond,
                        .lossFactor = values[lossFactor]}};
    const auto* chosen = chosenLibraryMaterial(values);
    if (chosen == nullptr)
        return std::nullopt;
    return idiophone::liveMaterial(*chosen);
}

} // namespace

ParameterValues withCustomMaterial(ParameterValues values, const Material& own) {
    values.set(material, customMaterial);
    values.set(youngsModulus, own.youngsModulusPa / pascalsPerGigapascal);
    values.set(density, own.densityKgPerM3);
    values.set(fluidDamping, own.damping.fluidPerSecond);
    values.set(viscoelasticDamping, own.damping.viscoelasticSeconds / secondsPerMicrosecond);
    values.set(lossFactor, own.damping.lossFactor);
    return values;
}

const FigureChoice* choiceOfFigure(ParameterId parameter) {
    const auto found = std::ranges::find_if(figureChoices, [parameter](const auto& choice) {
        return std::ranges::find(choice.figures, parameter) != choice.figures.end();
    });
    return found == figureChoices.end() ? nullptr : &*found;
}

ParameterValues effectiveFigures(ParameterValues values, const Material* own) {
    const double choice = values[material];
    if (const auto* chosen = choice == double{ownMaterial} ? own : chosenLibraryMaterial(values)) {
        values = withCustomMaterial(values, *chosen);
        values.set(material, choice);
    }
    if (const auto* racked = chosenMallet(values)) {
        const double compliance = own != nullptr ? surfaceCompliancePerPa(*own, values) : 0;
        values.set(malletHardness, contactModulusPa(*racked, compliance) / pascalsPerMegapascal);
        values.set(malletMass, racked->massKg * 1e3);
        values.set(malletRadius, racked->headRadiusMetres * 1e3);
        values.set(malletExponent, racked->forceExponent);
    }
    return values;
}

ParameterValues
withCustom(ParameterValues values, const FigureChoice& choice, const Material* own) {
    const auto effective = effectiveFigures(values, own);
    for (const auto figure : choice.figures)
        values.set(figure, effective[figure]);
    values.set(choice.choice, choice.custom);
    return values;
}

ParameterValues withPart(ParameterValues values, const KitPart& part) {
    if (part.material)
        values.set(material, *part.material);
    if (part.mallet)
        values.set(mallet, *part.mallet);
    return values;
}

std::optional<LiveMaterial> materialOfPart(const KitPart& part, const ModalObject& object) {
    if (!part.material)
        return std::nullopt;
    ParameterValues values;
    values.set(material, *part.material);
    return liveMaterial(contactMaterial(values, object.material));
}

bool hasLiveThickness(std::span<const SynthesiserSlot> slots) {
    return std::ranges::any_of(slots,
                               [](const auto& slot) { return slot.object->hasLiveThickness(); });
}

bool hasPitch(std::span<const SynthesiserSlot> slots) {
    return std::ranges::any_of(slots, [](const auto& slot) { return slot.pitch.has_value(); });
}

double motorTurnsPerSecond(const ParameterValues& values, double beatsPerMinute) {
    const double beats = motorSyncBeats(static_cast<int>(values[motorSync]));
    if (beats == 0 || !(beatsPerMinute > 0))
        return values[motorSpeed];
    return beatsPerMinute / 60 / beats / 2;
}

std::optional<double> motorTurnsAt(const ParameterValues& values, double songBeats) {
    const double beats = motorSyncBeats(static_cast<int>(values[motorSync]));
    return beats == 0 ? std::nullopt : std::optional(songBeats / beats / 2);
}

SynthesisSettings synthesisSettings(const ParameterValues& values) {
    const double slope = values[qualitySlope];
    return {.tau = values[tau],
            .qualitySlope = slope == parameterInfo(qualitySlope).maximum ? greedySlope : slope,
            .modeBudget = values[modeBudget],
            .compression = values[compression],
            .sizeRatio = values[size],
            .thicknessRatio = values[thickness] / 100,
            .imperfection = values[imperfection] / 100,
            .frequencyRatio = values[concertPitch] / parameterInfo(concertPitch).defaultValue *
                              std::exp2(values[tune] / 100 / 12),
            .decayRatio = values[decay],
            .keepPitch = values[keepPitch] != 0,
            .radiation = values[radiation] / 100,
            .material = liveMaterial(values)};
}

const Material* chosenLibraryMaterial(const ParameterValues& values) {
    const int choice = static_cast<int>(values[material]);
    const auto library = materialLibrary();
    const auto index = static_cast<std::size_t>(choice - firstLibraryMaterial);
    return choice >= firstLibraryMaterial && index < library.size() ? &library[index] : nullptr;
}

const Material& contactMaterial(const ParameterValues& values, const Material& own) {
    const auto* chosen = chosenLibraryMaterial(values);
    return chosen != nullptr ? *chosen : own;
}

const Mallet* chosenMallet(const ParameterValues& values) {
    const auto index = static_cast<int>(values[mallet]) - firstRackMallet;
    const auto rack = malletRack();
    return index >= 0 && index < static_cast<int>(rack.size())
               ? &rack[static_cast<std::size_t>(index)]
               : nullptr;
}

} // namespace idiophone
