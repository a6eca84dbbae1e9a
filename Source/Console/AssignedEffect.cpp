#include "Console/AssignedEffect.h"

#include "Instrument/HeldContacts.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>

namespace idiophone {
namespace {

using enum ParameterId;

/// A parameter that acts only under a condition on other values or on the kind of playing.
struct Condition {
    ParameterId parameter;
    bool (*acts)(const ParameterValues&, const Played&);
    const char* saying; ///< why the parameter does not act, or which values it needs
};

bool isStruck(const ParameterValues& values, const Played&) {
    return strikes(values);
}
bool isHeld(const ParameterValues& values, const Played&) {
    return !strikes(values);
}
bool isRolled(const ParameterValues& values, const Played&) {
    return static_cast<int>(values[contact]) == rollContact;
}
bool hasTubes(const ParameterValues&, const Played& played) {
    return std::ranges::any_of(played.slots,
                               [](const auto& slot) { return !slot.object->gains.empty(); });
}
bool motorModulates(const ParameterValues& values, const Played&) {
    return values[motorDepth] > 0;
}
/// Returns whether the motor runs freely. All other settings follow the host's tempo.
bool isFree(const ParameterValues& values, const Played&) {
    return motorSyncBeats(static_cast<int>(values[motorSync])) == 0;
}
bool hasRoom(const ParameterValues& values, const Played&) {
    return values[room] > 0;
}
bool keysDamp(const ParameterValues& values, const Played& played) {
    return values[letRing] == 0 || (played.isPressed && strikes(values));
}
bool hasPath(const ParameterValues&, const Played& played) {
    return !played.isOnePoint;
}
bool hasShells(const ParameterValues&, const Played& played) {
    return hasLiveThickness(played.slots);
}
bool hasPitches(const ParameterValues&, const Played& played) {
    return hasPitch(played.slots);
}
bool hasRadiation(const ParameterValues&, const Played& played) {
    return std::ranges::any_of(played.slots,
                               [](const auto& slot) { return !slot.object->radiation.empty(); });
}
/// Scenes are heard by two ears.
bool isStereo(const ParameterValues& values, const Played& played) {
    return played.by == PlayedBy::stage || played.by == PlayedBy::scene || values[room] > 0 ||
           (values[radiation] > 0 && hasRadiation(values, played));
}

constexpr const char* whileStruck = "it needs contact=Strike";
constexpr const char* whileHeld = "it needs contact=Scrape or contact=Roll";
constexpr const char* overTubes = "no object is a bar over a tube";
constexpr const char* onPaths = "there is only one point to strike";

constexpr Condition conditions[]{
    {strikeSpread, isStruck, whileStruck},
    {malletHardness, isStruck, whileStruck},
    {malletMass, isStruck, whileStruck},
    {malletRadius, isStruck, whileStruck},
    {malletExponent, isStruck, whileStruck},
    {malletFollow, isStruck, whileStruck},
    {malletSpeed, isStruck, whileStruck},
    {velocityCurve, isStruck, whileStruck},
    {mallet, isStruck, whileStruck},
    {chatter, isStruck, whileStruck},
    {modalPulse, isStruck, whileStruck},
    {contactForce, isHeld, whileHeld},
    {contactSpeed, isHeld, whileHeld},
    {roughness, isHeld, whileHeld},
    {rollCoupling, isRolled, "it needs contact=Roll"},
    {strikeAlong, hasPath, onPaths},
    {strikeAcross, hasPath, onPaths},
    {strikeSpread, hasPath, onPaths},
    {releaseTime, keysDamp, "it needs let_ring=off, or strikes with pressure that damps keys"},
    {motorDepth, hasTubes, overTubes},
    {motorSpeed, hasTubes, overTubes},
    {motorSync, hasTubes, overTubes},
    {motorSpeed, motorModulates, "it needs motor_depth above 0"},
    {motorSync, isFree, "there is no host with a tempo; use motor_speed"},
    {roomDecay, hasRoom, "it needs room above 0"},
    {thickness, hasShells, "no object is a shell"},
    {keepPitch, hasPitches, "no key has a pitch of its own"},
    {radiation, hasRadiation, "no object was analysed with its radiation"},
    {width, isStereo, "both channels are equal; it needs radiation or room above 0"}};

/// Parameters without effect where no mallets play.
constexpr std::array ofMallets{
    strikeAlong,    strikeAcross,  strikeSpread, malletHardness, malletMass,    malletRadius,
    malletExponent, malletFollow,  malletSpeed,  mallet,         velocityCurve, chatter,
    modalPulse,     matchLoudness, contact,      contactForce,   contactSpeed,  roughness,
    rollCoupling,   letRing,       releaseTime};
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
        if (condition.parameter == parameter && !condition.acts(values, played))
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
