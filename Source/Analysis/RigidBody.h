// The mass properties of a vibration model: what it weighs as a rigid body.
#pragma once

#include "Analysis/VibrationModel.h"
#include "Object/ModalObject.h"

namespace idiophone {

/// Of a model whose rows 3p, 3p + 1 and 3p + 2 are the displacement of the point in row p of
/// `pointsMetres` [P×3]: the kinetic energy of unit motions, exact for the model's own mass.
MassProperties massPropertiesOf(const VibrationModel& model, const Eigen::MatrixXd& pointsMetres);

} // namespace idiophone
