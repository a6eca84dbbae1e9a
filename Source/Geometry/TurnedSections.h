// The half sections of the factory's bells and bowls, for latheMesh: from the pole at the bottom or
// the lip, up. docs/instruments.md says whose measures they are.
#pragma once

#include "Geometry/LatheMesh.h"

namespace idiophone {

/// Mouth down: from the lip over a flaring side and a round shoulder to the crown.
struct BellMeasures {
    double lipRadiusMetres = 0;
    double heightMetres = 0;
    double shoulderRadiusMetres = 0; ///< of the side where the shoulder begins
    double shoulderCurveMetres = 0;  ///< how round the shoulder is; less than its radius
    double lipThicknessMetres = 0;   ///< thins to that of the side over a quarter of the height
    double sideThicknessMetres = 0;
    double crownThicknessMetres = 0;
};
std::vector<LathePoint> bellSection(const BellMeasures& bell);

/// A flat foot, then a quarter of an ellipse up to the rim.
struct BowlMeasures {
    double rimRadiusMetres = 0;
    double heightMetres = 0;
    double footRadiusMetres = 0; ///< less than the rim's
    double footThicknessMetres = 0;
    double rimThicknessMetres = 0;
};
std::vector<LathePoint> bowlSection(const BowlMeasures& bowl);

/// A part of a sphere, mouth up.
std::vector<LathePoint>
capSection(double rimRadiusMetres, double depthMetres, double thicknessMetres);

/// A case with a flat base and a slightly tapered wall that ends in a cylindrical mouth.
struct CaseMeasures {
    double baseRadiusMetres = 0;
    double mouthRadiusMetres = 0;
    double heightMetres = 0;
    double mouthHeightMetres = 0; ///< of the cylindrical part
    double cornerMetres = 0;      ///< how round the corner between base and wall is
    double baseThicknessMetres = 0;
    double wallThicknessMetres = 0; ///< above the corner; thins evenly to the mouth's
    double mouthThicknessMetres = 0;
};
std::vector<LathePoint> caseSection(const CaseMeasures& measures);

} // namespace idiophone
