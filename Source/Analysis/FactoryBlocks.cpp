#include "Analysis/FactoryBlocks.h"

#include "Geometry/ParametricMesh.h"
#include "Geometry/SweptMesh.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

/// Hangs from its upper corner; the open one is at the lower right.
Mesh triangleMesh() {
    constexpr double side = 0.2, rod = 0.0048, gap = 0.025, bend = 0.016;
    const double height = side * std::sqrt(3.0) / 2;
    const Eigen::Vector3d top(0, 0, height), left(-side / 2, 0, 0), right(side / 2, 0, 0);
    const Eigen::Vector3d aboveGap = right + gap * (top - right).normalized();
    return rodMesh(roundedPath({right, left, top, aboveGap}, bend, 0.0045), rod, 8);
}

Mesh claveMesh() {
    constexpr double halfLength = 0.1, radius = 0.0125;
    return rodMesh(roundedPath({{-halfLength, 0, 0}, {halfLength, 0, 0}}, 0, 0.009), radius, 10);
}

double smoothStep(double from, double to, double at) {
    const double share = std::clamp((at - from) / (to - from), 0.0, 1.0);
    return share * share * (3 - 2 * share);
}

/// A block with a foot, a waist and a face, whose end at +x narrows into a horn.
Mesh anvilMesh() {
    const Eigen::Vector3d size(0.44, 0.1, 0.22);
    Mesh mesh = boxMesh(size, {18, 5, 9});
    for (auto vertex : mesh.vertices.rowwise()) {
        const double x = 2 * vertex.x() / size.x(), z = 2 * vertex.z() / size.z(); // −1 to 1
        const double face = smoothStep(-0.1, 0.45, z), foot = 1 - smoothStep(-0.75, -0.35, z);
        const double horn = smoothStep(0.4, 1, x) * face;
        vertex.x() *= std::max({0.34, face, 0.58 * foot});
        vertex.y() *= (0.72 + 0.28 * std::max(face, foot) + 0.35 * foot) * (1 - 0.72 * horn);
        vertex.z() += 0.6 * horn * (size.z() / 2 - vertex.z());
    }
    return mesh;
}

constexpr FactoryShape blocks[] = {
    {.name = "triangle",
     .source = "generated triangle, sides of 200 mm of a steel rod of 9.6 mm, an eight-inch one",
     .material = "Mild steel",
     .mesh = triangleMesh,
     .maxFrequencyHz = 18000,
     .shapeVertexCount = 120},
    {.name = "clave",
     .source = "generated clave, a rosewood rod of 200 x 25 mm",
     .material = "Rosewood",
     .mesh = claveMesh,
     .maxFrequencyHz = 18000,
     .shapeVertexCount = 80},
    {.name = "anvil",
     .source = "generated steel anvil, face and horn 440 mm long, 100 mm wide, 220 mm high",
     .material = "Mild steel",
     .mesh = anvilMesh,
     .maxFrequencyHz = 12000,
     .shapeVertexCount = 100},
};

} // namespace

std::span<const FactoryShape> factoryBlocks() {
    return blocks;
}

} // namespace idiophone
