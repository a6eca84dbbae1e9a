#include "Instrument/HertzContact.h"

#include <cmath>

namespace idiophone {

double contactModulusPa(const Mallet& mallet, double surfaceCompliancePerPa) {
    return 1 / (1 / mallet.effectiveModulusPa + surfaceCompliancePerPa);
}

double elasticCompliancePerPa(double youngsModulusPa, double poissonRatio) {
    return (1 - poissonRatio * poissonRatio) / youngsModulusPa;
}

double hertzContactSeconds(double massKg,
                           double headRadiusMetres,
                           double modulusPa,
                           double speedMetresPerSecond) {
    return 2.87 * std::pow(massKg * massKg /
                               (headRadiusMetres * modulusPa * modulusPa * speedMetresPerSecond),
                           0.2);
}

} // namespace idiophone
