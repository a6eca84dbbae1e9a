#include "Instrument/MalletStrike.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr double headRadiusMetres = 0.0125; // of the hard mallets in use

/// −1 to 1, evenly spread, from an integer (the finaliser of MurmurHash3).
double scatter(std::uint32_t number) {
    number ^= number >> 16;
    number *= 0x85ebca6bu;
    number ^= number >> 13;
    number *= 0xc2b2ae35u;
    number ^= number >> 16;
    return number / 2147483647.5 - 1;
}

} // namespace

StrikePlace
strikePlace(double keyAlong, const ParameterValues& parameters, std::uint32_t strikeNumber) {
    const double spread = parameters[strikeSpread] / 100;
    const double along =
        std::clamp(parameters[strikeAlong] / 100 + spread * scatter(2 * strikeNumber), -1.0, 1.0);
    const double across = std::clamp(
        parameters[strikeAcross] / 100 + spread * scatter(2 * strikeNumber + 1), -1.0, 1.0);
    return {.along = keyAlong + along * (along > 0 ? 1 - keyAlong : keyAlong), .across = across};
}

Strike malletStrike(const StrikePoint& point,
                    int velocity,
                    double malletScale,
                    const ParameterValues& parameters) {
    const double speed =
        parameters[malletSpeed] * std::pow(velocity / 127.0, parameters[velocityCurve]);
    const double massKg = parameters[malletMass] * 1e-3;
    const double modulusPa = parameters[malletHardness] * 1e6;
    const double contactSeconds =
        2.87 * std::pow(massKg * massKg / (headRadiusMetres * modulusPa * modulusPa * speed), 0.2);
    const auto impulse = static_cast<float>(massKg * speed * std::pow(malletScale, 3));
    return {.point = point,
            .impulseNewtonSeconds = {-impulse * point.normal[0], -impulse * point.normal[1],
                                     -impulse * point.normal[2]},
            .durationSeconds = contactSeconds * malletScale};
}

} // namespace idiophone
