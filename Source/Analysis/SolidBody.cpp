#include "Analysis/SolidBody.h"

#include "Analysis/ElementSize.h"
#include "Analysis/QuadraticTetrahedra.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/Remesh.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

/// Elements of edge e in a volume V: TetGen's fill about 0.11 e³ each.
constexpr double elementVolumeShare = 0.11;
/// Between these shares of the edge wanted a surface is left as it is.
constexpr double finestShare = 0.4, coarsestShare = 1.6;
constexpr double coarsestElementsPerWavelength = 3;

/// The least edge that the budget allows: of a thin wall the elements are as flat as it is thin.
double budgetEdgeMetres(const MeshCheck& check, int elementBudget) {
    const double edge =
        std::cbrt(check.volumeM3 / elementVolumeShare / static_cast<double>(elementBudget));
    const double wall = check.meanThicknessMetres;
    if (edge <= wall)
        return edge;
    // One layer of prisms over half of the surface, three tetrahedra each.
    return std::max(wall,
                    std::sqrt(check.areaM2 / 2 * 3 / 0.433 / static_cast<double>(elementBudget)));
}

} // namespace

Result<SolidBody>
solidBody(const Mesh& surface, const SolidBodySettings& settings, const AnalysisControl& control) {
    const MeshCheck check = checkMesh(surface, control.cancelled);
    const double wall = check.meanThicknessMetres;
    const double wanted = targetEdgeMetres(settings.law, settings.material.densityKgPerM3,
                                           settings.maxFrequencyHz, wall);
    const double edge = std::max(wanted, budgetEdgeMetres(check, settings.elementBudget));
    const double given = meanEdgeLengthMetres(surface);
    SolidBody result;
    Mesh& mesh = result.body.surface;
    mesh = surface;
    bool keepSurface = true;
    if (given < finestShare * edge || given > coarsestShare * edge) {
        const double diagonal = boundingDiagonalMetres(surface);
        auto remeshed = remesh(surface, {.edgeLengthMetres = std::min(edge, diagonal / 4)},
                               {.progress = {}, .cancelled = control.cancelled});
        if (!remeshed)
            return failure(remeshed.error().message);
        const MeshCheck after = checkMesh(*remeshed, control.cancelled);
        // A wall thinner than the edges may have been pierced, or its curves flattened.
        if (after.isSolid() && std::abs(after.volumeM3 / check.volumeM3 - 1) < 0.02) {
            mesh = std::move(*remeshed);
            result.body.notes = "The surface was remeshed to edges of " +
                                std::to_string(std::lround(1000 * edge)) + " mm.";
        } else {
            keepSurface = given < edge;
        }
    }
    if (control.isCancelled())
        return failure(std::string(cancelledMessage));
    control.report(0, "Filling the body with tetrahedra");
    const auto elements =
        tetrahedralise(mesh, {.targetEdgeMetres = edge, .keepSurface = keepSurface});
    if (!elements)
        return failure(elements.error().message);
    result.body.model =
        quadraticTetrahedra(*elements, settings.law, settings.material.densityKgPerM3);
    result.body.pointsMetres = elements->nodes;
    result.body.body = BodyKind::solid;
    result.body.material = settings.material;
    result.maxFrequencyHz = servedFrequencyHz(
        settings.law, settings.material.densityKgPerM3, settings.maxFrequencyHz, wall,
        coarsestElementsPerWavelength * std::max(edge, meanEdgeLengthMetres(*elements)));
    return result;
}

} // namespace idiophone
