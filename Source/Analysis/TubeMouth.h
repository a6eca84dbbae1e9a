// The mouth of the tube under a bar: where it is, and what pressure the bar makes there.
#pragma once

#include "Analysis/Tube.h"
#include "Analysis/UndercutBar.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace idiophone {

/// Returns the centre of the tube's mouth; the bar's top is z = 0.
Eigen::Vector3d mouthMetres(const UndercutBar& shape, const Tube& tube);

/// Returns quadrature points on a disc, exact to the fifth degree (Abramowitz & Stegun 1964,
/// 25.4.61). The centre has weight 1/4 and each of the six points around it 1/8.
std::vector<Eigen::Vector3d> mouthPoints(const Eigen::Vector3d& centre, double radiusMetres);

/// Returns the ratio by which a closed tube raises the mean pressure over its mouth. It is a fit to
/// boundary elements of bar and tube together, incompressible, for bars of 15 to 39 cm and gaps of
/// 10 to 30 mm. The error is within 7 % for radius/gap of 0.6 to 1.9 (docs/decisions/0019).
double blockedOverFree(const UndercutBar& shape, const Tube& tube);

/// Returns [M] the blocked pressure of each mode, averaged over the mouth, per acceleration.
/// `pressures` [7×M] are those at the mouth's points for unit modal velocities.
std::vector<double> mouthKgPerM2(double blockedOverFree,
                                 const Eigen::MatrixXcd& pressures,
                                 const std::vector<double>& eigenvalues);

} // namespace idiophone
