// The sound of the board that carries the clamps of a body: the box under the tines of a kalimba.
#pragma once

#include "Object/RadiationTable.h"

#include <Eigen/Core>

namespace idiophone {

/// Adds the sound of a large board to the radiation of [M] modes. A force F on a thin plate that
/// bends slower than sound radiates like the flow F/(jω m) of a plate of mass m per area, twice as
/// much in front of it: p = ρ0 F/(2π m r) (Fahy & Gardonio 2007, section 3.7). The edges and the
/// resonances of the board are left out.
///
/// `upwardForces` [M] are the forces of the board on the body, in N for a modal amplitude of
/// 1 m √kg. The board lies at right angles to z, at `placeMetres` from the centre of mass.
void addBoard(RadiationTable& table,
              const Eigen::VectorXd& eigenvalues,
              const Eigen::RowVectorXd& upwardForces,
              const Eigen::Vector3d& placeMetres,
              double boardKgPerM2);

} // namespace idiophone
