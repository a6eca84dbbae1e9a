// The half sections of the factory's bells and bowls for latheMesh, upward from the pole at the
// bottom or from the lip. docs/instruments.md names the sources of the measures.
#pragma once

#include "Geometry/LatheMesh.h"

#include <span>
#include <vector>

namespace idiophone {

/// A bell, mouth down: from the lip over a flaring side and a round shoulder to the crown.
struct BellMeasures {
    double lipRadiusMetres = 0;
    double heightMetres = 0;
    double shoulderRadiusMetres = 0; ///< radius of the side where the shoulder begins
    double shoulderCurveMetres = 0;  ///< less than `shoulderRadiusMetres`
    double lipThicknessMetres = 0;   ///< thins to the side's thickness over a quarter of the height
    double sideThicknessMetres = 0;
    double crownThicknessMetres = 0;
};
std::vector<LathePoint> bellSection(const BellMeasures& bell);

/// A bowl: a flat foot, then a quarter of an ellipse up to the rim.
struct BowlMeasures {
    double rimRadiusMetres = 0;
    double heightMetres = 0;
    double footRadiusMetres = 0; ///< less than the rim's
    double footThicknessMetres = 0;
    double rimThicknessMetres = 0;
};
std::vector<LathePoint> bowlSection(const BowlMeasures& bowl);

/// A spherical cap, mouth up.
std::vector<LathePoint>
capSection(double rimRadiusMetres, double depthMetres, double thicknessMetres);

/// A case with a flat base and a slightly tapered wall that ends in a cylindrical mouth.
struct CaseMeasures {
    double baseRadiusMetres = 0;
    double mouthRadiusMetres = 0;
    double heightMetres = 0;
    double mouthHeightMetres = 0; ///< height of the cylindrical part
    double cornerMetres = 0;      ///< radius of the corner between base and wall
    double baseThicknessMetres = 0;
    double wallThicknessMetres = 0; ///< just above the corner; thins evenly towards the mouth
    double mouthThicknessMetres = 0;
};
std::vector<LathePoint> caseSection(const CaseMeasures& measures);

/// A smooth curve through at least two points, thickness included. A point that is given twice is a
/// corner.
std::vector<LathePoint> smoothSection(std::span<const LathePoint> points);

} // namespace idiophone
