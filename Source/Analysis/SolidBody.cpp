#include "Analysis/SolidBody.h"

#include "Analysis/CurvedEdges.h"
#include "Analysis/ElementSize.h"
#include "Analysis/QuadraticTetrahedra.h"
#include "Geometry/Decimation.h"
#include "Geometry/LengthUnit.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/Remesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace idiophone {
namespace {

/// The volume of a TetGen element of edge e is about 0.11 e³.
constexpr double elementVolumeShare = 0.11;
constexpr double coarsestElementsPerWavelength = 3;
constexpr double longBodySlenderness = 30; ///< of a square rod 55 times as long as wide

/// Returns the minimum edge within the budget. In a thin wall, elements are as flat as the wall. A
/// long rod may take twice the budget, because its factors are sparse.
double budgetEdgeMetres(const MeshCheck& check, int elementBudget) {
    const double edge =
        std::cbrt(check.volumeM3 / elementVolumeShare / static_cast<double>(elementBudget));
    const double wall = check.meanThicknessMetres, twisting = twistingElement * wall;
    if (edge <= twisting)
        return edge;
    if (edge <= std::cbrt(2) * twisting && check.slenderness > longBodySlenderness)
        return twisting;
    if (edge <= wall)
        return edge;
    // One layer of prisms over half of the surface, three tetrahedra each.
    return std::max(wall,
                    std::sqrt(check.areaM2 / 2 * 3 / 0.433 / static_cast<double>(elementBudget)));
}

/// Returns whether another surface of a body is solid and encloses the same volume.
bool keepsBody(const Mesh& surface, const MeshCheck& check, const WorkControl& control) {
    const MeshCheck after = checkMesh(surface, control.cancelled);
    return after.isSolid() && std::abs(after.volumeM3 / check.volumeM3 - 1) < 0.02;
}

struct CoveredSurface {
    std::optional<Mesh> mesh; ///< empty if no edge length preserved the body
    double edgeMetres = 0;
};

/// Remeshes the surface to edges of about this length. Long edges may pierce a thin wall or flatten
/// its curves. Then tries finer edges, down to the finest that need no remeshing.
Result<CoveredSurface> coveredAnew(const Mesh& surface,
                                   const MeshCheck& check,
                                   double edgeMetres,
                                   const WorkControl& control) {
    const double longest = std::min(edgeMetres, boundingDiagonalMetres(surface) / 4);
    for (const double share : {1.0, 0.63, finestEdgeShare}) {
        const double edge = share * longest;
        if (remeshedTriangles(surface, edge) >
            maximumNewTriangles + static_cast<double>(surface.faceCount())) {
            if (share < 1)
                break;
            return failure("The mesh is too long and thin to be covered with triangles of " +
                           millimetresText(edge) +
                           ", as a solid needs them; check its proportions and its unit.");
        }
        control.report(0, "Remeshing");
        auto remeshed = remesh(surface, edge, control.quiet());
        if (!remeshed)
            return tl::unexpected(remeshed.error());
        if (keepsBody(*remeshed, check, control))
            return CoveredSurface{std::move(*remeshed), edge};
    }
    return CoveredSurface{};
}

/// Decimates a surface that could not be remeshed, such as a thin tube's, and keeps its volume. If
/// that fails, returns the surface unchanged.
Mesh lightened(const Mesh& surface,
               const MeshCheck& check,
               double edgeMetres,
               const WorkControl& control) {
    for (const double share : {1.0, 0.63, finestEdgeShare}) {
        const double wanted = check.areaM2 / (0.866 * std::pow(share * edgeMetres, 2));
        if (!(wanted < static_cast<double>(surface.vertexCount())))
            break;
        auto lighter = decimate(surface, std::max(4, static_cast<int>(wanted)), control.quiet());
        if (lighter && keepsBody(*lighter, check, control))
            return std::move(*lighter);
    }
    return surface;
}

} // namespace

GrainAxes grainAlong(const Mesh& mesh) {
    Eigen::Index longest = 0;
    (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).maxCoeff(&longest);
    return {.grain = Eigen::Vector3d::Unit(longest)};
}

Result<BodyModel>
solidBody(const Mesh& surface, const SolidBodySettings& settings, const WorkControl& control) {
    const MeshCheck check = checkMesh(surface, control.cancelled);
    const double wall = check.meanThicknessMetres;
    // A narrower band would get elements as long as its waves, which bend well but twist stiffly.
    const double wanted =
        targetEdgeMetres(settings.law, settings.material.densityKgPerM3,
                         std::max(settings.maxFrequencyHz, highestAnalysedHz), wall);
    const double edge = std::max(wanted, budgetEdgeMetres(check, settings.elementBudget));
    const double given = meanEdgeLengthMetres(surface);
    BodyModel body;
    Mesh& mesh = body.surface;
    mesh = surface;
    bool keepSurface = true, isCoveredAnew = false;
    if (given < finestEdgeShare * edge || given > coarsestEdgeShare * edge) {
        const auto covered = coveredAnew(surface, check, edge, control);
        if (!covered)
            return failure(covered.error().message);
        if (covered->mesh) {
            mesh = *covered->mesh;
            isCoveredAnew = true;
            body.notes = "The surface was remeshed to edges of " +
                         millimetresText(covered->edgeMetres) + ".";
        } else {
            keepSurface = given < edge;
            if (keepSurface)
                mesh = lightened(surface, check, edge, control);
        }
    }
    if (control.isCancelled())
        return cancellation();
    control.report(0, "Filling the solid");
    auto elements = tetrahedralise(
        mesh,
        {.targetEdgeMetres = edge, .keepSurface = keepSurface, .cancelled = control.cancelled});
    if (!elements)
        return failure(elements.error().message);
    if (isCoveredAnew)
        curveEdges(*elements, mesh, SurfaceQuery(surface));
    body.model = quadraticTetrahedra(*elements, settings.law, settings.material.densityKgPerM3);
    body.pointsMetres = elements->nodes;
    body.body = BodyKind::solid;
    body.material = settings.material;
    body.servedBandHz = servedFrequencyHz(
        settings.law, settings.material.densityKgPerM3, settings.maxFrequencyHz, wall,
        coarsestElementsPerWavelength * std::max(edge, meanEdgeLengthMetres(*elements)));
    return body;
}

} // namespace idiophone
