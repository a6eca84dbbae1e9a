#include "Instrument/ContactLaw.h"

#include <cmath>
#include <numbers>

namespace idiophone {

double contactModulusPa(const Mallet& mallet, double surfaceCompliancePerPa) {
    return 1 / (1 / mallet.effectiveModulusPa + surfaceCompliancePerPa);
}

double elasticCompliancePerPa(double youngsModulusPa, double poissonRatio) {
    return (1 - poissonRatio * poissonRatio) / youngsModulusPa;
}

ContactLaw contactLaw(double headRadiusMetres, double modulusPa, double exponent) noexcept {
    return {.stiffness = 4.0 / 3.0 * modulusPa * std::pow(headRadiusMetres, 2 - exponent),
            .exponent = exponent};
}

double contactSeconds(const ContactLaw& law, double massKg, double speedMetresPerSecond) noexcept {
    const double share = 1 / (law.exponent + 1);
    const double speed = speedMetresPerSecond;
    const double compression =
        std::pow(massKg * speed * speed / (2 * share * law.stiffness), share);
    return 2 * compression / speed * std::sqrt(std::numbers::pi) * std::tgamma(1 + share) /
           std::tgamma(0.5 + share);
}

} // namespace idiophone
