// Turns faces over until neighbours agree and closed surfaces look outward. Internal to Geometry.
#pragma once

#include "Geometry/EdgePairing.h"
#include "Geometry/Mesh.h"

#include <atomic>

namespace idiophone {

struct OrientationReport {
    int flippedFaces = 0;
    int hollows = 0;        ///< closed surfaces inside another, which look into the hollow
    bool isTangled = false; ///< closed surfaces are inside each other in too many ways to find out
    int oneSidedEdges = 0;  ///< where no turning makes neighbours agree, as on a Möbius strip
};

/// Turns faces so that they agree with their partners. A closed surface looks outward; one that
/// lies inside an odd number of others looks inward, for it bounds a hollow (looked for among the
/// 1,000 closed surfaces with the most faces, and none turned where that takes more than a second
/// or two, or once cancelled). An open one keeps the side that most of its faces show. `pairing` is
/// that of the mesh and stays so; at one-sided edges its pairs are parted, and no partners of the
/// same direction are left.
OrientationReport
orientFaces(Mesh& mesh, EdgePairing& pairing, const std::atomic<bool>* cancelled = nullptr);

} // namespace idiophone
