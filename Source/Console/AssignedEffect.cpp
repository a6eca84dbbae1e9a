#include "Console/AssignedEffect.h"

#include "Instrument/HeldContacts.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>
#include <vector>

namespace idiophone {
namespace {

using enum ParameterId;

bool hasRadiation(const Played& played) {
    return std::ranges::any_of(played.slots,
                               [](const auto& slot) { return !slot.object->radiation.empty(); });
}

/// Parameters that act only under a condition on other values or on what is played.
struct Condition {
    std::vector<ParameterId> parameters;
    const char* saying; ///< why they do not act, or which values they need
    bool (*isMet)(const ParameterValues&, const Played&);
};

const Condition conditions[]{
    {{hardness, strikeSpread, malletHardness, malletMass, malletRadius, malletExponent,
      malletFollow, malletSpeed, velocityCurve, mallet, chatter, modalPulse},
     "it needs contact=Strike",
     [](const auto& values, const auto&) { return strikes(values); }},
    {{contactForce, contactSpeed, roughness},
     "it needs contact=Scrape, Roll, Bow or Rub",
     [](const auto& values, const auto&) { return !strikes(values); }},
    {{rollCoupling},
     "it needs contact=Roll",
     [](const auto& values, const auto&) {
         return static_cast<int>(values[contact]) == rollContact;
     }},
    {{strikeAlong, strikeAcross, strikeSpread},
     "there is only one point to strike",
     [](const auto&, const auto& played) { return !played.isOnePoint; }},
    {{releaseTime},
     "it needs let_ring=off, or strikes with pressure that damps keys",
     [](const auto& values, const auto& played) {
         return values[letRing] == 0 || (played.isPressed && strikes(values));
     }},
    {{motorDepth, motorSpeed, motorSync},
     "no object is a bar over a tube",
     [](const auto&, const auto& played) {
         return std::ranges::any_of(played.slots,
                                    [](const auto& slot) { return !slot.object->gains.empty(); });
     }},
    {{motorSpeed},
     "it needs motor_depth above 0",
     [](const auto& values, const auto&) { return values[motorDepth] > 0; }},
    {{motorSync}, // all settings but the free one follow the host's tempo
     "there is no host with a tempo; use motor_speed",
     [](const auto& values, const auto&) {
         return motorSyncBeats(static_cast<int>(values[motorSync])) == 0;
     }},
    {{outputs},
     "there is one output only",
     [](const auto& values, const auto&) {
         return static_cast<int>(values[outputs]) == mainOutput;
     }},
    {{roomDecay},
     "it needs room above 0",
     [](const auto& values, const auto&) { return values[room] > 0; }},
    {{thickness},
     "no object is a shell",
     [](const auto&, const auto& played) { return hasLiveThickness(played.slots); }},
    {{keepPitch},
     "no key has a pitch of its own",
     [](const auto&, const auto& played) { return hasPitch(played.slots); }},
    {{radiation},
     "no object was analysed with its radiation",
     [](const auto&, const auto& played) { return hasRadiation(played); }},
    {{width}, // scenes are heard by two ears
     "both channels are equal; it needs radiation or room above 0",
     [](const auto& values, const auto& played) {
         return played.by == PlayedBy::stage || played.by == PlayedBy::scene || values[room] > 0 ||
                (values[radiation] > 0 && hasRadiation(played));
     }}};

/// Parameters without effect where no mallets play.
constexpr std::array ofMallets{
    hardness,     strikeAlong,    strikeAcross,  strikeSpread, malletHardness, malletMass,
    malletRadius, malletExponent, malletFollow,  malletSpeed,  mallet,         velocityCurve,
    chatter,      modalPulse,     matchLoudness, contact,      contactForce,   contactSpeed,
    roughness,    rollCoupling,   letRing,       releaseTime};
/// Parameters without effect where no keys play.
constexpr std::array ofKeys{bendRange, mpe, mpeBendRange, motorSpeed, motorDepth, motorSync};

bool isAmong(std::span<const ParameterId> list, ParameterId parameter) {
    return std::ranges::find(list, parameter) != list.end();
}

/// Returns why the parameter has no effect, or an empty text.
std::string_view
whyIdle(ParameterId parameter, const ParameterValues& values, const Played& played) {
    if (played.by == PlayedBy::stage && isAmong(ofMallets, parameter))
        return "the keys move bodies instead of mallets";
    if ((played.by == PlayedBy::scene || played.by == PlayedBy::impulses) &&
        (isAmong(ofMallets, parameter) || isAmong(ofKeys, parameter)))
        return "it needs keys";
    for (const auto& condition : conditions)
        if (isAmong(condition.parameters, parameter) && !condition.isMet(values, played))
            return condition.saying;
    return {};
}

bool areOfSeveralMaterials(std::span<const SynthesiserSlot> slots) {
    return std::ranges::any_of(slots, [&](const auto& slot) {
        return liveMaterial(slot.object->material) != liveMaterial(slots.front().object->material);
    });
}

/// Replaces the figures of the selected material or mallet by the assigned ones.
ParameterValues withAssignedFigures(ParameterValues values,
                                    const FigureChoice& choice,
                                    std::span<const ParameterId> assigned,
                                    std::span<const SynthesiserSlot> slots) {
    const auto isAssigned = [&](ParameterId figure) { return isAmong(assigned, figure); };
    if (static_cast<int>(values[choice.choice]) == choice.custom ||
        std::ranges::none_of(choice.figures, isAssigned))
        return values;
    auto custom =
        withCustom(values, choice, slots.empty() ? nullptr : &slots.front().object->material);
    for (const auto figure : choice.figures)
        if (isAssigned(figure))
            custom.set(figure, values[figure]);
    return custom;
}

} // namespace

AssignedEffect assignedEffect(ParameterValues values,
                              std::span<const ParameterId> assigned,
                              const Played& played) {
    const bool keepMaterials =
        static_cast<int>(values[material]) == ownMaterial && areOfSeveralMaterials(played.slots);
    for (const auto& choice : figureChoices)
        if (choice.choice != material || !keepMaterials)
            values = withAssignedFigures(values, choice, assigned, played.slots);
    AssignedEffect effect{.values = values, .warnings = {}};
    for (const auto& info : parameterTable()) {
        if (!isAmong(assigned, info.parameter))
            continue;
        auto why = whyIdle(info.parameter, values, played);
        if (keepMaterials && isAmong(materialFigures, info.parameter))
            why = "the objects have several materials; choose one with --set material=...";
        if (!why.empty())
            effect.warnings.push_back(std::string("--set ") + info.id +
                                      " has no effect: " + std::string(why));
    }
    return effect;
}

void print(std::span<const std::string> warnings) {
    for (const auto& warning : warnings)
        std::cerr << "warning: " << warning << std::endl;
}

} // namespace idiophone
