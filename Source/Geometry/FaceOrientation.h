// Turns faces over until neighbours agree and closed surfaces look outward. Internal to Geometry.
#pragma once

#include "Geometry/EdgePairing.h"
#include "Mesh/Mesh.h"

#include <atomic>

namespace idiophone {

struct OrientationReport {
    int flippedFaces = 0;
    int hollows = 0;        ///< closed surfaces inside another, turned towards the hollow
    bool isTangled = false; ///< the search for hollows was given up and turned none
    int oneSidedEdges = 0;  ///< edges whose faces cannot agree, as on a Möbius strip
};

/// Turns faces so that they agree with their partners. A closed surface looks outward; inside an
/// odd number of others it bounds a hollow and looks inward. An open surface keeps the side that
/// most of its faces show.
/// Searches for hollows among the 1,000 closed surfaces with the most faces. Turns none if the
/// search takes more than a second or two, or if cancelled.
/// `pairing` must belong to the mesh and is updated with it. Pairs at one-sided edges are
/// separated; afterwards no partners run in the same direction.
OrientationReport
orientFaces(Mesh& mesh, EdgePairing& pairing, const std::atomic<bool>* cancelled = nullptr);

} // namespace idiophone
