#include "Instrument/MalletStrike.h"

#include "Instrument/Scatter.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using enum ParameterId;

/// Restitution of every head on a rigid, heavy object. Estimated: wound and solid balls rebound at
/// 0.5 to 0.9 of their speed, which changes (1 + e) by 1 dB either way.
constexpr double headRestitution = 0.7;

/// The factor of the contact's modulus at full hardness: from wood to brass, or to rubber.
constexpr double hardest = 60;

StrikePlace placeBeside(double keyAlong, double along, double across) {
    along = std::clamp(along, -1.0, 1.0);
    return {.along = keyAlong + along * (along > 0 ? 1 - keyAlong : keyAlong),
            .across = std::clamp(across, -1.0, 1.0)};
}

} // namespace

StrikePlace aimedPlace(double keyAlong, const ParameterValues& parameters) {
    return placeBeside(keyAlong, parameters[strikeAlong] / 100, parameters[strikeAcross] / 100);
}

StrikePlace
strikePlace(double keyAlong, const ParameterValues& parameters, std::uint32_t strikeNumber) {
    const double spread = parameters[strikeSpread] / 100;
    return placeBeside(keyAlong, parameters[strikeAlong] / 100 + spread * scatter(2 * strikeNumber),
                       parameters[strikeAcross] / 100 + spread * scatter(2 * strikeNumber + 1));
}

double surfaceCompliancePerPa(const Material& own, const ParameterValues& parameters) {
    if (const auto* chosen = chosenLibraryMaterial(parameters))
        return elasticCompliancePerPa(chosen->youngsModulusPa, chosen->poissonRatio);
    if (static_cast<int>(parameters[material]) == customMaterial)
        return elasticCompliancePerPa(parameters[youngsModulus] * 1e9, own.poissonRatio);
    return elasticCompliancePerPa(own.youngsModulusPa, own.poissonRatio);
}

Striker striker(const KeyMallet& key, const ParameterValues& parameters, double surfaceCompliance) {
    const auto* racked = chosenMallet(parameters);
    const Mallet custom{.massKg = parameters[malletMass] * 1e-3,
                        .headRadiusMetres = parameters[malletRadius] * 1e-3,
                        .effectiveModulusPa = parameters[malletHardness] * 1e6,
                        .forceExponent = parameters[malletExponent]};
    const Mallet& head = racked != nullptr ? *racked : custom;
    const double followed =
        std::pow(key.pitchRatio, parameters[malletFollow] / 100 * (head.forceExponent + 1));
    const double hardened = std::pow(hardest, parameters[hardness] / 100);
    const double modulusPa =
        hardened * followed * contactModulusPa(head, racked != nullptr ? surfaceCompliance : 0);
    return {.massKg = head.massKg * std::pow(key.scale, 3),
            .restitution = headRestitution,
            .law = contactLaw(head.headRadiusMetres * key.scale, modulusPa, head.forceExponent)};
}

Strike malletStrike(const StrikePoint& point,
                    int velocity,
                    const KeyMallet& key,
                    const ParameterValues& parameters,
                    const SynthesiserSlot& struck) {
    const auto& object = *struck.object;
    const DrivingPoint driven(object, point, synthesisSettings(parameters), struck.sizeRatio,
                              struck.pitch ? &*struck.pitch : nullptr);
    const auto collision = driven.struckBy(
        striker(key, parameters, surfaceCompliancePerPa(object.material, parameters)),
        parameters[malletSpeed] * std::pow(velocity / 127.0, parameters[velocityCurve]));
    Strike strike{.point = point, .durationSeconds = collision.contactSeconds};
    for (std::size_t axis = 0; axis < 3; ++axis)
        strike.impulseNewtonSeconds[axis] = -static_cast<float>(collision.impulseNewtonSeconds) *
                                            point.normal[axis] * static_cast<float>(key.gain);
    return strike;
}

} // namespace idiophone
