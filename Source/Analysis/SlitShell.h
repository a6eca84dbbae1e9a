// A hollow body with a slit, such as a temple block: its wall vibrates, and the air in it
// resonates.
#pragma once

#include "Analysis/BodyModel.h"
#include "Analysis/Cavity.h"
#include "Geometry/LatheMesh.h"

#include <functional>

namespace idiophone {

struct SlitShell {
    LatheMesh closed; ///< the wall with the slit closed; the middle surface encloses the cavity
    Mesh open;        ///< the same vertices, without the faces of the slit
    Cavity cavity;    ///< between the inner sides of the wall
    Eigen::Vector3d mouthMetres; ///< the middle of the slit
};

/// Opens a slit in a closed wall: the faces whose middle satisfies `isSlit`. The slit is one row of
/// faces, so that all of its vertices lie on the lips.
SlitShell slitShell(const LatheMesh& closed,
                    const std::function<bool(const Eigen::RowVector3d& middleMetres)>& isSlit);

/// Solves the open wall as solveBody does, and adds its cavity. `settings.shapeVertices` are
/// vertices of the wall. The radiation is that of the wall with a lid that moves with the lips, and
/// of the flow through the slit. The model leaves out that pressure outside drives the slit: it is
/// some twentieth of the cavity's. Errors: those of solveBody and radiationOf.
Result<ModalObject> solveSlitShell(const SlitShell& shell,
                                   const Material& material,
                                   const SolveSettings& settings,
                                   const WorkControl& control = {});

} // namespace idiophone
