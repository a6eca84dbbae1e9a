#include "Geometry/MeshCheck.h"

#include "Geometry/EdgePairing.h"
#include "Geometry/SelfIntersection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace idiophone {

MeshCheck checkMesh(const Mesh& mesh, const std::atomic<bool>* cancelled) {
    MeshCheck check;
    const auto pairing = pairEdges(mesh);
    check.boundaryEdges = pairing.boundaryEdges;
    check.nonManifoldEdges = pairing.nonManifoldEdges;
    check.isClosed =
        mesh.faceCount() > 0 && pairing.boundaryEdges == 0 && pairing.nonManifoldEdges == 0;
    check.isOriented =
        check.isClosed && std::ranges::none_of(pairing.partners, [](const auto& partners) {
            return std::ranges::any_of(partners, &EdgePartner::sameDirection);
        });
    check.intersectsItself = intersectsItself(mesh, cancelled);
    check.areaM2 = faceAreas(mesh).sum();
    check.volumeM3 = check.isOriented ? std::max(0.0, signedVolumeM3(mesh)) : 0;
    check.meanThicknessMetres = wallThicknessMetres(check.areaM2, check.volumeM3);
    check.slenderness = check.meanThicknessMetres > 0
                            ? std::sqrt(check.areaM2) / check.meanThicknessMetres
                            : std::numeric_limits<double>::infinity();
    return check;
}

} // namespace idiophone
