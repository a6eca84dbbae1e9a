// Objects without modes: bodies that fall, strike and are struck, and make no sound themselves.
#pragma once

#include "Object/ModalObject.h"

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <vector>

namespace idiophone {

/// A solid ball about the origin, 0.1 mm to 10 m, so small that its lowest mode is beyond hearing.
std::shared_ptr<const ModalObject> silentBall(double radiusMetres, const Material& material);

/// A body of given points, at least one, and faces between them, with the mass of the box around
/// them if `mass` has none. Moments of inertia of 0 become those of that box.
std::shared_ptr<const ModalObject> silentBody(const std::vector<Eigen::Vector3d>& pointsMetres,
                                              const std::vector<std::array<int, 3>>& faces,
                                              const Material& material,
                                              const MassProperties& mass);

/// Returns the mass with the moments of inertia of a box, if it has none. `box` is not empty.
MassProperties withInertia(MassProperties mass, const Eigen::AlignedBox3d& box);

} // namespace idiophone
