#include "Analysis/TetMesh.h"

#include "Analysis/TetGenMesher.h"
#include "Geometry/LengthUnit.h"
#include "Geometry/MeshCheck.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <igl/winding_number.h>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

namespace idiophone {
namespace {

/// Maximum circumradius over shortest edge if no flat elements are wanted. TetGen is proved to
/// terminate from 2 on, and in practice terminates far below 2.
constexpr double thickRatio = 1.6;

/// The volume bound over the volume of a regular tetrahedron of the target edge. It makes the mean
/// edge about the target; found by trials on bars, spheres and blocks.
constexpr double volumeShare = 1.4;

std::string faultOf(const Mesh& surface, const TetMeshSettings& settings) {
    if (!(settings.targetEdgeMetres > 0) || !std::isfinite(settings.targetEdgeMetres))
        return "The edge length of tetrahedra must be a positive number of metres.";
    if (surface.vertexCount() > settings.maximumNodes)
        return "The surface alone has " + std::to_string(surface.vertexCount()) +
               " points, and a solid takes at most " + std::to_string(settings.maximumNodes) +
               "; simplify the mesh first.";
    if (!isClosed(uniqueEdges(surface)))
        return "The surface is not closed, so that it encloses no volume.";
    return {};
}

/// Thin walls keep flat elements. A prism of the surface's triangles and a wall of thickness h =
/// 2V/A has R/h = √(e²/3 + h²/4)/h. With a lower bound, TetGen would cut it into cubes.
double radiusEdgeRatio(const Mesh& surface, const TetMeshSettings& settings) {
    if (!settings.keepSurface)
        return thickRatio;
    const double area = faceAreas(surface).sum();
    const double wall = wallThicknessMetres(area, std::abs(signedVolumeM3(surface)));
    const double edge = meanEdgeLengthMetres(surface) / std::max(wall, 1e-12 * std::sqrt(area));
    return std::max(thickRatio, 1.5 * std::sqrt(edge * edge / 3 + 0.25));
}

double sixVolumes(const Eigen::MatrixXd& points, const Eigen::RowVectorXi& corners) {
    const Eigen::Vector3d a = points.row(corners(0));
    const Eigen::Vector3d u = points.row(corners(1)).transpose() - a,
                          v = points.row(corners(2)).transpose() - a,
                          w = points.row(corners(3)).transpose() - a;
    return u.cross(v).dot(w);
}

/// Returns true for regions that an odd number of the surface's sheets encloses.
std::vector<bool> solidRegions(const Mesh& surface, const LinearTetrahedra& filled) {
    std::vector<bool> solid(static_cast<std::size_t>(filled.regions.maxCoeff()) + 1, true);
    if (connectedComponents(surface).count == 1)
        return solid;
    std::map<int, std::pair<double, Eigen::Index>> largest; // volume and element of each region
    for (Eigen::Index t = 0; t < filled.tetrahedra.rows(); ++t) {
        const double volume = std::abs(sixVolumes(filled.points, filled.tetrahedra.row(t)));
        auto& best = largest[filled.regions(t)];
        if (volume > best.first)
            best = {volume, t};
    }
    for (const auto& [region, element] : largest) {
        Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
        for (int k = 0; k < 4; ++k)
            middle += filled.points.row(filled.tetrahedra(element.second, k)) / 4;
        const double turns = igl::winding_number(surface.vertices, surface.faces, middle);
        solid[region] = std::lround(turns) % 2 != 0;
    }
    return solid;
}

/// Returns the used elements and points. The surface's points stay first.
Result<LinearTetrahedra> withoutCavities(const Mesh& surface, LinearTetrahedra filled) {
    const auto solid = solidRegions(surface, filled);
    std::vector<int> newIndex(filled.points.rows(), -1);
    LinearTetrahedra kept;
    kept.tetrahedra.resize(filled.tetrahedra.rows(), 4);
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < filled.tetrahedra.rows(); ++t) {
        if (!solid[filled.regions(t)])
            continue;
        kept.tetrahedra.row(count++) = filled.tetrahedra.row(t);
        for (int k = 0; k < 4; ++k)
            newIndex[filled.tetrahedra(t, k)] = 0;
    }
    kept.tetrahedra.conservativeResize(count, 4);
    int next = 0;
    for (std::size_t p = 0; p < newIndex.size(); ++p) {
        if (newIndex[p] < 0 && static_cast<Eigen::Index>(p) < surface.vertexCount())
            return failure("Points of the surface lie too close together to be filled as a solid; "
                           "simplify the mesh.");
        if (newIndex[p] == 0) {
            filled.points.row(next) = filled.points.row(p).eval();
            newIndex[p] = next++;
        }
    }
    kept.points = filled.points.topRows(next);
    for (int& corner : kept.tetrahedra.reshaped())
        corner = newIndex[corner];
    return kept;
}

} // namespace

TetMesh withMidEdgeNodes(const Eigen::MatrixXd& points,
                         const Eigen::MatrixXi& tetrahedra,
                         int surfaceVertexCount) {
    TetMesh mesh{.nodes = {},
                 .tetrahedra = Eigen::MatrixXi(tetrahedra.rows(), 10),
                 .surfaceVertexCount = surfaceVertexCount};
    std::unordered_map<std::uint64_t, int> middles;
    std::vector<std::pair<int, int>> edges;
    const auto corners = static_cast<int>(points.rows());
    for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t) {
        Eigen::RowVectorXi element = tetrahedra.row(t);
        if (sixVolumes(points, element) < 0)
            std::swap(element(2), element(3));
        mesh.tetrahedra.row(t).head<4>() = element;
        for (int e = 0; e < 6; ++e) {
            const auto [a, b] = std::minmax(
                {element(tetrahedronEdges[e].first), element(tetrahedronEdges[e].second)});
            const auto [place, isNew] =
                middles.try_emplace(static_cast<std::uint64_t>(a) << 32 | static_cast<unsigned>(b),
                                    corners + static_cast<int>(edges.size()));
            if (isNew)
                edges.emplace_back(a, b);
            mesh.tetrahedra(t, 4 + e) = place->second;
        }
    }
    mesh.nodes.resize(corners + static_cast<Eigen::Index>(edges.size()), 3);
    mesh.nodes.topRows(corners) = points;
    for (std::size_t e = 0; e < edges.size(); ++e)
        mesh.nodes.row(corners + static_cast<Eigen::Index>(e)) =
            (points.row(edges[e].first) + points.row(edges[e].second)) / 2;
    return mesh;
}

Result<TetMesh> tetrahedralise(const Mesh& closedSurface, const TetMeshSettings& settings) {
    if (const auto fault = faultOf(closedSurface, settings); !fault.empty())
        return failure(fault);
    const auto tooMany = [&] {
        return failure("The solid needs more than " + std::to_string(settings.maximumNodes) +
                       " points, " + millimetresText(settings.targetEdgeMetres) +
                       " apart; simplify the mesh or lower the highest frequency.");
    };
    const double regular = std::pow(settings.targetEdgeMetres, 3) / (6 * std::sqrt(2.0));
    const int maximumAdded = settings.maximumNodes - static_cast<int>(closedSurface.vertexCount());
    auto filled =
        runTetGen(closedSurface, {.keepSurface = settings.keepSurface,
                                  .radiusEdgeRatio = radiusEdgeRatio(closedSurface, settings),
                                  .maximumVolumeM3 = volumeShare * regular,
                                  .maximumAddedPoints = maximumAdded,
                                  .cancelled = settings.cancelled});
    if (!filled)
        return failure(filled.error().message);
    if (filled->points.rows() >= settings.maximumNodes)
        return tooMany();
    const auto solid = withoutCavities(closedSurface, std::move(*filled));
    if (!solid)
        return failure(solid.error().message);
    auto mesh = withMidEdgeNodes(solid->points, solid->tetrahedra,
                                 static_cast<int>(closedSurface.vertexCount()));
    if (mesh.nodes.rows() > settings.maximumNodes)
        return tooMany();
    return mesh;
}

double volumeM3(const TetMesh& mesh) {
    double six = 0;
    for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
        six += sixVolumes(mesh.nodes, mesh.tetrahedra.row(t).head<4>());
    return six / 6;
}

double meanEdgeLengthMetres(const TetMesh& mesh) {
    // An edge is identified by its mid-edge node, which its elements share.
    std::unordered_map<int, double> lengths;
    for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
        for (int e = 0; e < 6; ++e) {
            const auto [a, b] = tetrahedronEdges[e];
            lengths[mesh.tetrahedra(t, 4 + e)] =
                (mesh.nodes.row(mesh.tetrahedra(t, a)) - mesh.nodes.row(mesh.tetrahedra(t, b)))
                    .norm();
        }
    double sum = 0;
    for (const auto& [node, length] : lengths)
        sum += length;
    return sum / static_cast<double>(std::max<std::size_t>(lengths.size(), 1));
}

} // namespace idiophone
