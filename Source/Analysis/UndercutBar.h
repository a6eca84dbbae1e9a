// The shape of a bar of a mallet instrument: flat on top, an arch cut into its underside, which
// brings the second and third partials where the ear wants them. Shape only: BarTuning finds it.
#pragma once

#include "Analysis/TimoshenkoBeam.h"
#include "Object/Result.h"

#include <vector>

namespace idiophone {

/// Half the bar, seen from the side, from its middle: up to `archHalfLengthShare` of the length the
/// height is
///
///     centre + (height − centre) (|x| / (share · length))^exponent,
///
/// the full height at the arch's edge, and from there to the end a straight line to `endHeight`.
struct UndercutBar {
    double lengthMetres = 0.3;
    double widthMetres = 0.04;
    double heightMetres = 0.02;       ///< where the arch begins
    double centreHeightMetres = 0.02; ///< in the middle of the arch; ≤ height
    double endHeightMetres = 0.02;    ///< at both ends
    double archHalfLengthShare = 0.3; ///< of the length, 0.1 to 0.49
    double archExponent = 2;          ///< 2 is a parabola; more is steeper at the edges. ≥ 1

    bool operator==(const UndercutBar&) const = default;
};

/// Height in metres at x from the middle, |x| ≤ length/2.
double heightMetresAt(const UndercutBar& bar, double xMetres);

/// What bending along a bar asks of its material.
struct BeamMaterial {
    double youngsModulusPa = 0; ///< along the bar
    double shearModulusPa = 0;  ///< in the plane of length and height
    double shearCoefficient = rectangularShearCoefficient(0.25);
    double densityKgPerM3 = 0;
};

/// Undamped bending frequencies in Hz after Timoshenko's theory, `count` from the lowest on.
std::vector<double>
bendingFrequenciesHz(const UndercutBar& bar, const BeamMaterial& material, int count);

/// What the partials should be. A ratio of 0 leaves that partial where it falls.
struct PartialTargets {
    double fundamentalHz = 440;
    double secondRatio = 0; ///< 3 for a xylophone, 4 for marimba and vibraphone
    double thirdRatio = 0;  ///< 6 and 10; needs a second ratio
};

/// The bar with the length, the height in the middle and the arch's exponent, each as far as the
/// targets ask, that brings its partials within a hundredth of a cent of them after Timoshenko; all
/// else is kept. Without a second ratio the arch is kept as it is. Errors: targets or measures out
/// of range, a ratio that no such arch reaches.
Result<UndercutBar>
tunedArch(const UndercutBar& start, const BeamMaterial& material, const PartialTargets& targets);

} // namespace idiophone
