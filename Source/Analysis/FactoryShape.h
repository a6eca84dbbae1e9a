// One object of the factory that is analysed from a generated shape: a sheet, a solid, or a wall.
#pragma once

#include "Geometry/LatheMesh.h"
#include "Object/ModalObject.h"
#include "Object/WorkControl.h"

#include <array>
#include <string_view>
#include <vector>

namespace idiophone {

/// `inFront` is above the front edge, `beside` 20° above the horizon of a hanging or standing body.
enum class Listeners { inFront, beside, allAround };

/// Has one of `mesh`, `section` and `wall`.
struct FactoryShape {
    std::string_view name, source, material;
    Mesh (*mesh)() = nullptr;                       ///< of a sheet or a solid
    double thicknessMetres = 0;                     ///< of a sheet; 0 for a solid
    std::vector<LathePoint> (*section)() = nullptr; ///< of a turned wall
    double edgeMetres = 0;                          ///< of a turned wall's triangles
    LatheMesh (*wall)() = nullptr;                  ///< a wall of any shape
    /// Whether a face with this middle is open, in a closed wall whose air resonates (SlitShell.h).
    bool (*isSlit)(const Eigen::RowVector3d& middleMetres) = nullptr;
    double maxFrequencyHz = 0;
    std::size_t shapeVertexCount = 0; ///< 0: all; on the outside of a wall
    Listeners listeners = Listeners::inFront;
    /// A post, strap or hand resists the motion of this place, which damps the modes that move it.
    std::array<double, 3> heldAtMetres = {};
    double heldResistanceNsPerM = 0; ///< 0: it is free
};

/// Analyses the object, which takes seconds. Error: `cancelledMessage`.
Result<ModalObject> analysedShape(const FactoryShape& shape, const WorkControl& control = {});

} // namespace idiophone
