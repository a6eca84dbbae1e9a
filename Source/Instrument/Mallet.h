// What strikes: the rack of mallets, and how long a head touches what it meets (Hertz). Knows
// nothing of keys, velocities or parameters.
#pragma once

#include <span>
#include <string_view>

namespace idiophone {

struct Mallet {
    std::string_view name;
    std::string_view source; ///< where the figures come from
    double massKg;
    double headRadiusMetres;
    double effectiveModulusPa; ///< E/(1 − ν²) of the head by itself
};

/// The named mallets, in a fixed order: parameters and presets count on it, so append only.
std::span<const Mallet> malletRack();

/// The modulus of the contact, 1/E* = 1/E*_head + c, where c = (1 − ν²)/E of what is struck [1/Pa];
/// 0 is rigid.
double contactModulusPa(const Mallet& mallet, double surfaceCompliancePerPa);

/// (1 − ν²)/E [1/Pa] of something elastic.
double elasticCompliancePerPa(double youngsModulusPa, double poissonRatio);

/// T = 2.87 (m²/(R E*² v))^(1/5): the time of contact of a sphere with something flat and heavy, at
/// a speed v > 0 [m/s].
double hertzContactSeconds(double massKg,
                           double headRadiusMetres,
                           double modulusPa,
                           double speedMetresPerSecond);

} // namespace idiophone
