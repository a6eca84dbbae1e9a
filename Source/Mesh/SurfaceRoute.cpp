// SPDX-License-Identifier: Apache-2.0
#include "Mesh/SurfaceRoute.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace idiophone {
namespace {

struct Neighbour {
    int vertex;
    double metres;
};
using Graph = std::vector<std::vector<Neighbour>>; // neighbours of each vertex

/// Returns the edges of faces whose unit normal has at least the component `minimumCosine` along
/// `facing`.
Graph edgesFacing(const Mesh& mesh, const Eigen::Vector3d& facing, double minimumCosine) {
    Graph graph(mesh.vertexCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        if (doubleAreaVector(mesh, face).normalized().dot(facing) < minimumCosine)
            continue;
        for (int corner = 0; corner < 3; ++corner) {
            const int one = mesh.faces(face, corner), other = mesh.faces(face, (corner + 1) % 3);
            const double metres = (mesh.vertices.row(one) - mesh.vertices.row(other)).norm();
            graph[one].push_back({other, metres});
            graph[other].push_back({one, metres});
        }
    }
    return graph;
}

int nearestOf(const Graph& graph, const Mesh& mesh, const Eigen::Vector3d& point) {
    int nearest = -1;
    double nearestSquared = std::numeric_limits<double>::infinity();
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (const double away = (mesh.vertices.row(v).transpose() - point).squaredNorm();
            away < nearestSquared && !graph[v].empty()) {
            nearestSquared = away;
            nearest = v;
        }
    return nearest;
}

/// Dijkstra's algorithm. Returns the path from `to` back to `from`; empty if there is none.
std::vector<int> shortestPath(const Graph& graph, int from, int to) {
    std::vector<double> metres(graph.size(), std::numeric_limits<double>::infinity());
    std::vector<int> previous(graph.size(), -1);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    metres[from] = 0;
    open.emplace(0, from);
    while (!open.empty() && open.top().second != to) {
        const auto [reached, vertex] = open.top();
        open.pop();
        if (reached > metres[vertex])
            continue;
        for (const auto& next : graph[vertex])
            if (const double through = reached + next.metres; through < metres[next.vertex]) {
                metres[next.vertex] = through;
                previous[next.vertex] = vertex;
                open.emplace(through, next.vertex);
            }
    }
    if (open.empty())
        return {};
    std::vector<int> path;
    for (int vertex = to; vertex >= 0; vertex = previous[vertex])
        path.push_back(vertex);
    return path;
}

/// Averages every point with its neighbours a few times. The ends stay in place.
void roundOff(std::vector<Eigen::Vector3d>& route) {
    constexpr int passes = 8;
    for (int pass = 0; pass < passes; ++pass) {
        const auto before = route;
        for (std::size_t i = 1; i + 1 < route.size(); ++i)
            route[i] = (before[i - 1] + 2 * before[i] + before[i + 1]) / 4;
    }
}

} // namespace

std::vector<Eigen::Vector3d> surfaceRoute(const Mesh& mesh,
                                          const Eigen::Vector3d& from,
                                          const Eigen::Vector3d& to,
                                          const Eigen::Vector3d& facing) {
    for (const double minimumCosine : {0.5, -2.0}) {
        const auto graph = edgesFacing(mesh, facing, minimumCosine);
        const int start = nearestOf(graph, mesh, from), end = nearestOf(graph, mesh, to);
        if (start < 0 || end < 0)
            continue;
        const auto path = shortestPath(graph, end, start);
        std::vector<Eigen::Vector3d> route;
        for (const int vertex : path)
            route.emplace_back(mesh.vertices.row(vertex));
        if (route.empty())
            continue;
        roundOff(route);
        return route;
    }
    return {};
}

} // namespace idiophone
