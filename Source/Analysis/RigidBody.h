// The mass properties of a vibration model as a rigid body.
#pragma once

#include "Analysis/VibrationModel.h"
#include "Object/ModalObject.h"

namespace idiophone {

/// Returns the mass properties from the kinetic energy of unit motions, exact for the model's mass.
/// Rows 3p, 3p + 1 and 3p + 2 of the model are the displacement of the point in row p of
/// `pointsMetres` [P×3].
MassProperties massPropertiesOf(const VibrationModel& model, const Eigen::MatrixXd& pointsMetres);

} // namespace idiophone
