// The static potentials of a flat triangle with a uniform charge or dipole layer, in closed form.
// They are the singular part of the boundary integrals; BoundaryElements adds the waves.
#pragma once

#include <Eigen/Core>

namespace idiophone {

/// R = x − y, r = |R|, and n is the triangle's normal.
struct PanelPotentials {
    double singleLayer = 0;              ///< ∫ 1/(4πr) dS, in metres
    double doubleLayer = 0;              ///< ∫ n·R/(4πr³) dS, positive on the side of n
    Eigen::Vector3d singleLayerGradient; ///< by x, dimensionless
    Eigen::Vector3d doubleLayerGradient; ///< by x, in 1/m
};

/// Returns the potentials at a point that lies on no edge. In the triangle's plane, the double
/// layer is its principal value, 0. There the gradients are their mean over both sides, the finite
/// part of the hypersingular integral. `corners` are the columns, counter-clockwise about `normal`.
///
/// Single layer: Wilton et al. 1984, IEEE Trans. Antennas Propag. 32, eq. 5. Double layer: a solid
/// angle, van Oosterom & Strackee 1983, IEEE Trans. Biomed. Eng. 30, eq. 8. Its gradient is the
/// field of a current along the edges (Biot & Savart).
PanelPotentials panelPotentials(const Eigen::Matrix3d& corners,
                                const Eigen::Vector3d& normal,
                                const Eigen::Vector3d& point);

} // namespace idiophone
