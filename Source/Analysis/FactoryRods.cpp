#include "Analysis/FactoryRods.h"

#include "Analysis/ModalAnalysis.h"
#include "Geometry/MeshBuilder.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/SpreadVertices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

struct Rod {
    std::string_view name, source;
    Mesh (*mesh)() = nullptr;
    std::string_view clamp;
    double resistanceNsPerM = 0, boardKgPerM2 = 0;
    double maxFrequencyHz = 0;
    std::size_t shapeVertexCount = 0;
};

/// A round rod along x, its middle at the origin. The radius changes evenly from the free end to
/// the root at +x. Every other ring is turned by half a spacing.
Mesh roundRod(double lengthMetres, double tipRadiusMetres, double rootRadiusMetres) {
    constexpr int around = 8;
    const double edge = std::numbers::pi * (tipRadiusMetres + rootRadiusMetres) / around;
    const int rows = static_cast<int>(std::lround(lengthMetres / (0.87 * edge)));
    MeshBuilder builder;
    for (int row = 0; row <= rows; ++row)
        for (int k = 0; k < around; ++k) {
            const double share = static_cast<double>(row) / rows;
            const double radius = std::lerp(tipRadiusMetres, rootRadiusMetres, share);
            const double angle = 2 * std::numbers::pi * (k + 0.5 * (row % 2)) / around;
            builder.add(lengthMetres * (share - 0.5), radius * std::cos(angle),
                        radius * std::sin(angle));
        }
    const auto at = [](int row, int k) { return row * around + k % around; };
    for (int row = 0; row < rows; ++row)
        for (int k = 0; k < around; ++k) {
            const int shift = row % 2; // of this row against the next
            builder.face(at(row, k), at(row, k + 1), at(row + 1, k + shift));
            builder.face(at(row, k + 1 - shift), at(row + 1, k + 1), at(row + 1, k));
        }
    const int tip = builder.add(-lengthMetres / 2, 0, 0),
              root = builder.add(lengthMetres / 2, 0, 0);
    for (int k = 0; k < around; ++k) {
        builder.face(at(0, k + 1), at(0, k), tip);
        builder.face(at(rows, k), at(rows, k + 1), root);
    }
    return builder.mesh();
}

/// A bar of rectangular section, bent to a U that opens upward. Its lowest points have
/// z = −(bend + height/2).
Mesh forkMesh() {
    constexpr double prongMetres = 0.0859, bendRadiusMetres = 0.008;
    constexpr double widthMetres = 0.006, heightMetres = 0.005;
    constexpr double bend = std::numbers::pi * bendRadiusMetres, whole = 2 * prongMetres + bend;
    Mesh mesh = boxMesh({whole, widthMetres, heightMetres}, {72, 2, 2});
    for (auto vertex : mesh.vertices.rowwise()) {
        const double along = vertex.x(), radius = bendRadiusMetres + vertex.z();
        const double angle = std::clamp(along, -bend / 2, bend / 2) / bendRadiusMetres;
        const double beyond = std::max(0.0, std::abs(along) - bend / 2);
        vertex << radius * std::sin(angle), -vertex.y(), beyond - radius * std::cos(angle);
    }
    return mesh;
}

constexpr Rod rods[] = {
    {.name = "tine",
     .source = "generated steel rod, 78 mm, 2.3 mm thick at the root and 1.9 mm at the tip, after "
               "the tines of electric pianos, without tone bar and tuning spring",
     .mesh = [] { return roundRod(0.078, 0.00095, 0.00115); },
     .clamp = "x>0.038999",
     .resistanceNsPerM = 2200,
     .boardKgPerM2 = 10,
     .maxFrequencyHz = 20000,
     .shapeVertexCount = 60},
    {.name = "toy-piano-rod",
     .source = "generated steel rod, 58 x 2.5 mm, after toy pianos, on a wooden board",
     .mesh = [] { return roundRod(0.058, 0.00125, 0.00125); },
     .clamp = "x>0.028999",
     .resistanceNsPerM = 1300,
     .boardKgPerM2 = 4,
     .maxFrequencyHz = 24000,
     .shapeVertexCount = 60},
    {.name = "tuning-fork",
     .source = "generated steel fork A4, prongs of 6 x 5 mm, held where the stem would begin",
     .mesh = forkMesh,
     .clamp = "z<-0.0095",
     .resistanceNsPerM = 500,
     .boardKgPerM2 = 4,
     .maxFrequencyHz = 16000,
     .shapeVertexCount = 90},
};

} // namespace

std::vector<std::string> factoryRodNames() {
    std::vector<std::string> names;
    for (const Rod& rod : rods)
        names.emplace_back(rod.name);
    return names;
}

std::optional<Result<ModalObject>> makeFactoryRod(std::string_view name,
                                                  const WorkControl& control) {
    const auto* rod = std::ranges::find(rods, name, &Rod::name);
    if (rod == std::end(rods))
        return std::nullopt;
    const Mesh mesh = rod->mesh();
    return analyse(mesh,
                   {.name = std::string(rod->name),
                    .source = std::string(rod->source),
                    .material = *findMaterial("Mild steel"),
                    .method = AnalysisMethod::tetrahedra,
                    .maxFrequencyHz = rod->maxFrequencyHz,
                    .elementBudget = 4000,
                    .support = {.clamps = {parseClamp(rod->clamp).value()},
                                .resistanceNsPerM = rod->resistanceNsPerM,
                                .boardKgPerM2 = rod->boardKgPerM2},
                    .shapeVertices = spreadVertices(mesh, allVertices(mesh), rod->shapeVertexCount),
                    .radiation = RadiationMethod::quick},
                   control);
}

} // namespace idiophone
