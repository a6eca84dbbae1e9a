#include "Instrument/Mallet.h"

#include <array>
#include <cmath>

namespace idiophone {
namespace {

// Masses and radii are those of mallets in use. The moduli of the heads are set so that contact
// times on rosewood (brass: on steel) at 1 m/s are those of docs/decisions/0012. They are below
// those of the bulk materials, as heads are: wound, across the grain, flattened by use.
constexpr std::array rack{
    Mallet{.name = "Yarn",
           .source = "A wound vibraphone mallet; contact time 5.1 ms on wood at 1 m/s",
           .massKg = 0.040,
           .headRadiusMetres = 0.022,
           .effectiveModulusPa = 2.068e6},
    Mallet{.name = "Soft rubber",
           .source = "Contact modulus 2 MPa; contact time 5.1 ms on wood at 1 m/s",
           .massKg = 0.035,
           .headRadiusMetres = 0.018,
           .effectiveModulusPa = 2.0e6},
    Mallet{.name = "Medium rubber",
           .source = "Contact modulus 20 MPa; contact time 1.9 ms on wood at 1 m/s",
           .massKg = 0.030,
           .headRadiusMetres = 0.016,
           .effectiveModulusPa = 2.0e7},
    Mallet{.name = "Hard rubber",
           .source = "Contact modulus 100 MPa; contact time 1.0 ms on wood at 1 m/s",
           .massKg = 0.025,
           .headRadiusMetres = 0.0125,
           .effectiveModulusPa = 1.01e8},
    Mallet{.name = "Wood",
           .source = "A light head, about 0.85 GPa across the grain; 0.36 ms on wood at 1 m/s",
           .massKg = 0.016,
           .headRadiusMetres = 0.0125,
           .effectiveModulusPa = 8.5e8},
    Mallet{.name = "Hard plastic",
           .source = "Contact modulus 1 GPa on wood; contact time 0.36 ms on wood at 1 m/s",
           .massKg = 0.020,
           .headRadiusMetres = 0.0125,
           .effectiveModulusPa = 1.08e9},
    Mallet{.name = "Brass",
           .source = "Contact modulus 60 GPa on steel; contact time 0.09 ms on steel at 1 m/s",
           .massKg = 0.030,
           .headRadiusMetres = 0.010,
           .effectiveModulusPa = 8.27e10},
};

} // namespace

std::span<const Mallet> malletRack() {
    return rack;
}

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
