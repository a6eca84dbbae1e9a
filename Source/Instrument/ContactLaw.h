// The force between a head and a rigid surface, and how long a free mass stays in contact.
#pragma once

#include "Object/Mallet.h"

namespace idiophone {

/// Returns the modulus of the contact, 1/E* = 1/E*_head + c. c = (1 − ν²)/E is the compliance of
/// the struck material [1/Pa]; 0 is rigid.
double contactModulusPa(const Mallet& mallet, double surfaceCompliancePerPa);

/// Returns (1 − ν²)/E [1/Pa] of an elastic material.
double elasticCompliancePerPa(double youngsModulusPa, double poissonRatio);

/// F = K d^p over the compression d ≥ 0.
struct ContactLaw {
    double stiffness = 0; ///< K > 0 [N/m^p]
    double exponent = 0;  ///< p ≥ 1
};

/// The exponent p for two elastic bodies with round surfaces (Hertz).
inline constexpr double hertzExponent = 1.5;

/// Returns F = (4/3) E* R² (d/R)^p, the contact of Hertz at p = 3/2. Wound and felt heads stiffen
/// faster, p = 2 to 4. R is the law's only length: for any p, a head scaled by s has s times the
/// contact time at the same speed.
ContactLaw
contactLaw(double headRadiusMetres, double modulusPa, double exponent = hertzExponent) noexcept;

/// Returns T = 2 (δ/v) √π Γ(1 + 1/(p+1)) / Γ(1/2 + 1/(p+1)) from the conservation of energy. The
/// largest compression is δ = (m v² (p+1)/(2K))^(1/(p+1)), so T ∝ m^(1/(p+1)) v^((1−p)/(1+p)). For
/// two free bodies m is their reduced mass. Mass and speed are > 0.
double contactSeconds(const ContactLaw& law, double massKg, double speedMetresPerSecond) noexcept;

} // namespace idiophone
