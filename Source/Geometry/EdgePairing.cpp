#include "Geometry/EdgePairing.h"

#include "Mesh/FaceSides.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace idiophone {
namespace {

struct HalfEdge : FaceSide {
    bool ascending = false;  ///< the face runs from low to high
    double angleRadians = 0; ///< angle of the face around the edge; set by sortAboutEdge
};

std::vector<HalfEdge> sortedHalfEdges(const Mesh& mesh) {
    const auto sides = sortedFaceSides(mesh);
    std::vector<HalfEdge> halfEdges;
    halfEdges.reserve(sides.size());
    for (const auto& side : sides)
        halfEdges.push_back({side, mesh.faces(side.face, side.corner) == side.low, 0});
    return halfEdges;
}

void pair(EdgePairing& pairing, const HalfEdge& first, const HalfEdge& second) {
    const bool same = first.ascending == second.ascending;
    pairing.partners[first.face][first.corner] = {second.face, same};
    pairing.partners[second.face][second.corner] = {first.face, same};
}

void sortAboutEdge(const Mesh& mesh, std::span<HalfEdge> around) {
    const Eigen::RowVector3d origin = mesh.vertices.row(around.front().low);
    const Eigen::RowVector3d axis = (mesh.vertices.row(around.front().high) - origin).normalized();
    const Eigen::RowVector3d across = axis.unitOrthogonal(), up = axis.cross(across);
    for (auto& h : around) {
        const Eigen::RowVector3d apex =
            mesh.vertices.row(mesh.faces(h.face, (h.corner + 2) % 3)) - origin;
        h.angleRadians = std::atan2(apex.dot(up), apex.dot(across));
    }
    std::ranges::sort(around, {}, [](const HalfEdge& h) {
        return std::pair{h.angleRadians, h.face};
    });
}

/// Returns the angle from one face to the other, 0 to 2π.
double wedge(const HalfEdge& from, const HalfEdge& to) {
    const double angle = to.angleRadians - from.angleRadians;
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// Returns where the first pair begins in `around`: 0 or 1.
std::size_t firstPairOf(std::span<const HalfEdge> around) {
    const std::size_t n = around.size();
    bool alternate = true;
    double wedges[2] = {0, 0};
    for (std::size_t i = 0; i < n; ++i) {
        const auto& next = around[(i + 1) % n];
        alternate = alternate && around[i].ascending != next.ascending;
        wedges[i % 2] += wedge(around[i], next);
    }
    // Seen along the edge, the inside lies behind an ascending face, so that face ends a pair.
    if (alternate)
        return around[0].ascending ? 1 : 0;
    return wedges[1] < wedges[0] ? 1 : 0;
}

void pairStraightest(EdgePairing& pairing, std::vector<HalfEdge> around) {
    while (around.size() > 1) {
        std::size_t bestI = 0, bestJ = 1;
        double bestMiss = 2 * std::numbers::pi;
        for (std::size_t i = 0; i < around.size(); ++i)
            for (std::size_t j = i + 1; j < around.size(); ++j)
                if (const double miss = std::abs(wedge(around[i], around[j]) - std::numbers::pi);
                    miss < bestMiss) {
                    bestMiss = miss;
                    bestI = i;
                    bestJ = j;
                }
        pair(pairing, around[bestI], around[bestJ]);
        around.erase(around.begin() + static_cast<std::ptrdiff_t>(bestJ));
        around.erase(around.begin() + static_cast<std::ptrdiff_t>(bestI));
    }
}

void pairAbout(EdgePairing& pairing, const Mesh& mesh, std::span<HalfEdge> around) {
    // With more faces, no pairing is meaningful, and pairStraightest takes cubic time.
    constexpr std::size_t maximumFaces = 64;
    const std::size_t n = around.size();
    sortAboutEdge(mesh, around);
    if (n % 2 == 1 && n <= maximumFaces) {
        pairStraightest(pairing, {around.begin(), around.end()});
        return;
    }
    const std::size_t even = n - n % 2;
    const std::size_t first = n % 2 == 0 ? firstPairOf(around) : 0;
    for (std::size_t i = 0; i < even; i += 2)
        pair(pairing, around[(first + i) % n], around[(first + i + 1) % n]);
}

} // namespace

EdgePairing pairEdges(const Mesh& mesh) {
    auto halfEdges = sortedHalfEdges(mesh);
    EdgePairing result{.partners = std::vector<std::array<EdgePartner, 3>>(mesh.faceCount())};
    for (std::size_t i = 0, end = 0; i < halfEdges.size(); i = end) {
        while (end < halfEdges.size() && halfEdges[end].isAlong(halfEdges[i]))
            ++end;
        if (end - i == 2)
            pair(result, halfEdges[i], halfEdges[i + 1]);
        else if (end - i > 2)
            pairAbout(result, mesh, std::span(halfEdges).subspan(i, end - i));
        (end - i == 1 ? result.boundaryEdges : result.nonManifoldEdges) += end - i == 2 ? 0 : 1;
    }
    return result;
}

} // namespace idiophone
