#include "Analysis/ModalAnalysis.h"

#include "Benchmarks/Benchmarks.h"
#include "Geometry/ParametricMesh.h"
#include "Object/Material.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <thread>

namespace idiophone {
namespace {

struct Body {
    std::string name;
    Mesh mesh;
    double highestHz = 0;
    double atLeast = 0; ///< bound on the wall time with one thread over that with two
};

/// Returns an open shell as a scanner leaves it: a bust of 25 cm with a rough surface, cut off at
/// the bottom.
Mesh scanLikeMesh() {
    Mesh mesh = icosphereMesh(1, 5);
    std::mt19937 generator(1);
    for (auto vertex : mesh.vertices.rowwise()) {
        const double x = vertex.x(), y = vertex.y(), z = vertex.z();
        const double noise = static_cast<double>(generator()) / 4294967296.0 - 0.5;
        const double features = 0.1 * std::sin(4 * x + 2 * z) * std::cos(3 * y) +
                                0.04 * std::sin(11 * y + 5 * x) + 0.02 * std::cos(17 * z - 9 * x);
        vertex *= 0.1 * (1 + features + 0.003 * noise);
        vertex.z() *= 1.25;
    }
    std::vector<int> kept;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        if (mesh.vertices(mesh.faces(face, 0), 2) > -0.1)
            kept.push_back(static_cast<int>(face));
    mesh.faces = mesh.faces(kept, Eigen::all).eval();
    return mesh;
}

struct TimedAnalysis {
    ModalObject object;
    double wallSeconds = 0, processorSeconds = 0;
};

Result<TimedAnalysis> timed(const Body& body, unsigned threads) {
    using Clock = std::chrono::steady_clock;
    const auto processorStart = std::clock();
    const auto start = Clock::now();
    auto object = analyse(body.mesh, {.name = body.name,
                                      .source = body.name,
                                      .material = *findMaterial("Steel"),
                                      .maxFrequencyHz = body.highestHz,
                                      .threads = threads});
    if (!object)
        return tl::unexpected(object.error());
    return TimedAnalysis{.object = std::move(*object),
                         .wallSeconds = std::chrono::duration<double>(Clock::now() - start).count(),
                         .processorSeconds =
                             static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC};
}

std::size_t differing(const auto& first, const auto& second) {
    std::size_t count =
        std::max(first.size(), second.size()) - std::min(first.size(), second.size());
    for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k)
        count += first[k] != second[k] ? 1 : 0;
    return count;
}

} // namespace

Result<BenchSection> benchAnalysis(const BenchContent&) {
    BenchSection section{.name = "analysis",
                         .title = "wall time of the analysis of steel bodies, with one thread and "
                                  "with two, on " +
                                  std::to_string(std::thread::hardware_concurrency()) + " cores"};
    std::size_t allDiffering = 0;
    for (const Body& body : {Body{"a ball of 20 cm", icosphereMesh(0.1, 4), 44000, 1.3},
                             Body{"a cube of 1 m", boxMesh({1, 1, 1}, {1, 1, 1}), 4000, 1.35},
                             Body{"a scan", scanLikeMesh(), 4000, 1.5}}) {
        const auto one = timed(body, 1), two = timed(body, 2);
        if (!one || !two)
            return tl::unexpected(one ? two.error() : one.error());
        const double ratio = one->wallSeconds / two->wallSeconds;
        const std::size_t differences =
            differing(one->object.eigenvalues, two->object.eigenvalues) +
            differing(one->object.shapes, two->object.shapes) +
            differing(one->object.radiation.weights, two->object.radiation.weights);
        allDiffering += differences;
        section.row(body.name, figure(one->wallSeconds) + " s with one thread, " +
                                   figure(two->wallSeconds) + " s with two; " +
                                   std::to_string(one->object.eigenvalues.size()) + " modes");
        section.figures["bodies"].push_back(
            {{"name", body.name},
             {"triangles", body.mesh.faceCount()},
             {"modes", one->object.eigenvalues.size()},
             {"one_thread_wall_s", one->wallSeconds},
             {"two_threads_wall_s", two->wallSeconds},
             {"one_over_two", ratio},
             {"processor_two_over_one", two->processorSeconds / one->processorSeconds},
             {"differing_figures", differences}});
        section.goals.push_back({"analysis: one thread over two cores, " + body.name, ratio,
                                 BenchGoal::Kind::atLeast, body.atLeast});
    }
    section.goals.push_back({"analysis: figures that differ between one thread and two",
                             static_cast<double>(allDiffering), BenchGoal::Kind::atMost, 0});
    return section;
}

} // namespace idiophone
