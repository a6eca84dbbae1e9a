#include "Instrument/MalletStrike.h"

#include "Instrument/HertzContact.h"
#include "Instrument/Scatter.h"
#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using enum ParameterId;

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

Strike malletStrike(const StrikePoint& point,
                    int velocity,
                    double malletScale,
                    const ParameterValues& parameters,
                    double surfaceCompliance) {
    const double speed =
        parameters[malletSpeed] * std::pow(velocity / 127.0, parameters[velocityCurve]);
    const auto* racked = chosenMallet(parameters);
    const double massKg = racked != nullptr ? racked->massKg : parameters[malletMass] * 1e-3;
    const double radiusMetres =
        racked != nullptr ? racked->headRadiusMetres : parameters[malletRadius] * 1e-3;
    const double modulusPa = racked != nullptr ? contactModulusPa(*racked, surfaceCompliance)
                                               : parameters[malletHardness] * 1e6;
    const double contactSeconds = hertzContactSeconds(massKg, radiusMetres, modulusPa, speed);
    const auto impulse = static_cast<float>(massKg * speed * std::pow(malletScale, 3));
    return {.point = point,
            .impulseNewtonSeconds = {-impulse * point.normal[0], -impulse * point.normal[1],
                                     -impulse * point.normal[2]},
            .durationSeconds = contactSeconds * malletScale};
}

} // namespace idiophone
