// The shape of a mallet instrument's bar: flat on top, with an arch cut into its underside. The
// arch tunes the second and third partials. BarTuning finds its dimensions.
#pragma once

#include "Analysis/TimoshenkoBeam.h"
#include "Object/Result.h"

#include <vector>

namespace idiophone {

/// One half of the bar in side view, from its middle. Up to `archHalfLengthShare` of the length,
/// the height is
///
///     centre + (height − centre) (|x| / (share · length))^exponent.
///
/// The arch's edge has the full height. A straight line leads from there to `endHeight` at the end.
struct UndercutBar {
    double lengthMetres = 0.3;
    double widthMetres = 0.04;
    double heightMetres = 0.02;       ///< at the arch's edge
    double centreHeightMetres = 0.02; ///< in the middle of the arch; ≤ height
    double endHeightMetres = 0.02;    ///< at both ends
    double archHalfLengthShare = 0.3; ///< of the length, 0.1 to 0.49
    double archExponent = 2;          ///< ≥ 1; 2 is a parabola; higher is steeper at the edges

    bool operator==(const UndercutBar&) const = default;
};

/// Returns the height in metres at x from the middle, |x| ≤ length/2.
double heightMetresAt(const UndercutBar& bar, double xMetres);

/// The material constants for bending along a bar.
struct BeamMaterial {
    double youngsModulusPa = 0; ///< along the bar
    double shearModulusPa = 0;  ///< in the plane of length and height
    double shearCoefficient = rectangularShearCoefficient(0.25);
    double densityKgPerM3 = 0;
};

/// Returns the `count` lowest undamped bending frequencies in Hz by Timoshenko's theory.
std::vector<double>
bendingFrequenciesHz(const UndercutBar& bar, const BeamMaterial& material, int count);

/// The target partials. A ratio of 0 leaves that partial untuned.
struct PartialTargets {
    double fundamentalHz = 440;
    double secondRatio = 0; ///< 3 for a xylophone, 4 for marimba and vibraphone
    double thirdRatio = 0;  ///< 6 and 10; needs a second ratio

    /// Returns the number of tuned partials, 1 to 3.
    int count() const { return thirdRatio > 0 ? 3 : secondRatio > 0 ? 2 : 1; }
};

/// Changes the length, the centre height and the arch's exponent, as far as the targets need. By
/// Timoshenko's theory, the partials then lie within a hundredth of a cent of the targets. All
/// other dimensions are kept, and without a second ratio the arch's exponent too. Errors: targets
/// or dimensions out of range, a ratio that no arch reaches.
Result<UndercutBar>
tunedArch(const UndercutBar& start, const BeamMaterial& material, const PartialTargets& targets);

} // namespace idiophone
