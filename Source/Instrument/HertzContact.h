// How long a head touches what it meets (Hertz).
#pragma once

#include "Object/Mallet.h"

namespace idiophone {

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
