#include "Analysis/FactoryObjects.h"

#include "Analysis/FactoryBars.h"
#include "Analysis/FactoryBlocks.h"
#include "Analysis/FactoryRods.h"
#include "Analysis/FactoryShape.h"
#include "Analysis/FactoryShells.h"
#include "Analysis/FactoryTubes.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/TurnedSections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace idiophone {
namespace {

/// A worn pebble: three shallow waves on an ellipsoid.
Mesh pebbleMesh() {
    Mesh mesh = icosphereMesh(1, 3);
    for (auto vertex : mesh.vertices.rowwise()) {
        const Eigen::RowVector3d unit = vertex;
        const double bump = 1 + 0.05 * std::sin(2.1 * unit.x() + 0.7) * std::cos(2.7 * unit.y()) +
                            0.03 * std::sin(3.3 * unit.z() + 1.1 * unit.x());
        vertex = bump * unit.cwiseProduct(Eigen::RowVector3d(0.026, 0.021, 0.014));
    }
    return mesh;
}

/// A sheet with ribs across, bent along, so that bodies roll back and forth on it.
Mesh washboardMesh() {
    constexpr double ribMetres = 0.016, ribHeightMetres = 0.0006, bendRadiusMetres = 1.5;
    Mesh mesh = sheetMesh(0.40, 0.12, 2600);
    for (auto vertex : mesh.vertices.rowwise())
        vertex.z() = vertex.x() * vertex.x() / (2 * bendRadiusMetres) +
                     ribHeightMetres * std::cos(2 * std::numbers::pi * vertex.x() / ribMetres);
    return mesh;
}

std::vector<LathePoint> handbellSection() {
    return bellSection({.lipRadiusMetres = 0.06734,
                        .heightMetres = 0.08744,
                        .shoulderRadiusMetres = 0.04382,
                        .shoulderCurveMetres = 0.01347,
                        .lipThicknessMetres = 0.00271,
                        .sideThicknessMetres = 0.00251,
                        .crownThicknessMetres = 0.00342});
}

std::vector<LathePoint> glassBowlSection() {
    return bowlSection({.rimRadiusMetres = 0.083,
                        .heightMetres = 0.073,
                        .footRadiusMetres = 0.035,
                        .footThicknessMetres = 0.005,
                        .rimThicknessMetres = 0.004});
}

std::vector<LathePoint> shellCaseSection() {
    return caseSection({.baseRadiusMetres = 0.049,
                        .mouthRadiusMetres = 0.045,
                        .heightMetres = 0.292,
                        .mouthHeightMetres = 0.028,
                        .cornerMetres = 0.009,
                        .baseThicknessMetres = 0.008,
                        .wallThicknessMetres = 0.002,
                        .mouthThicknessMetres = 0.0013});
}

constexpr FactoryShape shapes[] = {
    {.name = "plate",
     .source = "generated steel plate, 300 x 200 x 3 mm",
     .material = "Steel",
     .mesh = [] { return sheetMesh(0.30, 0.20, 1900); },
     .thicknessMetres = 0.003,
     .maxFrequencyHz = 22000, // above, a wavelength has fewer than eight edges
     .shapeVertexCount = 180},
    {.name = "table",
     .source = "generated wooden table top, 900 x 600 x 25 mm, a small table's",
     .material = "Wood",
     .mesh = [] { return sheetMesh(0.9, 0.6, 1400); },
     .thicknessMetres = 0.025,
     .maxFrequencyHz = 10000,
     .shapeVertexCount = 110},
    {.name = "ring",
     .source = "generated steel hoop, radius 70 mm, 15 x 4 mm",
     .material = "Steel",
     .mesh = [] { return hoopMesh(0.07, 0.015, 132, 5); },
     .thicknessMetres = 0.004,
     .maxFrequencyHz = 44000,
     .shapeVertexCount = 240},
    {.name = "handbell",
     .source = "generated bronze handbell C5, mouth 135 mm, wall 2.5 to 3.4 mm; a profile whose "
               "(3,0) is a twelfth above (2,0)",
     .material = "Bell bronze",
     .section = handbellSection,
     .edgeMetres = 0.00744,
     .maxFrequencyHz = 18000,
     .shapeVertexCount = 120},
    {.name = "glass-bowl",
     .source = "generated glass bowl, 170 x 75 mm as one of Duralex; wall of 4 to 5 mm assumed",
     .material = "Glass",
     .section = glassBowlSection,
     .edgeMetres = 0.009,
     .maxFrequencyHz = 20000,
     .shapeVertexCount = 120},
    {.name = "wok",
     .source = "generated steel wok, 14 inches wide, 14 gauge; depth of 100 mm assumed",
     .material = "Steel",
     .section = [] { return capSection(0.178, 0.1, 0.002); },
     .edgeMetres = 0.013,
     .maxFrequencyHz = 10000,
     .shapeVertexCount = 120},
    {.name = "shell-case",
     .source = "generated brass case after the 25-pounder's, 88 x 292 mm, without its rim; wall of "
               "1.3 to 2 mm assumed",
     .material = "Brass",
     .section = shellCaseSection,
     .edgeMetres = 0.01,
     .maxFrequencyHz = 10000,
     .shapeVertexCount = 120,
     .listeners = Listeners::allAround},
    {.name = "small-ring",
     .source = "generated hollow steel ring, radius 50 mm, round section of 12 mm, 200 vertices as "
               "in Raghuvanshi & Lin 2006",
     .material = "Steel",
     .mesh = [] { return torusMesh(0.05, 0.006, 20, 10); },
     .thicknessMetres = 0.001,
     .maxFrequencyHz = 22000,
     .listeners = Listeners::allAround},
    {.name = "long-table",
     .source = "generated wooden table top, 1200 x 800 x 20 mm, about 600 vertices as in "
               "Raghuvanshi & Lin 2006",
     .material = "Wood",
     .mesh = [] { return sheetMesh(1.2, 0.8, 600); },
     .thicknessMetres = 0.020,
     .maxFrequencyHz = 10000,
     .shapeVertexCount = 200},
    {.name = "cylinder",
     .source =
         "generated steel tube, 60 x 4 x 120 mm, 128 vertices, 32 around, as in Raghuvanshi & "
         "Lin 2006",
     .material = "Steel",
     .mesh = [] { return tubeMesh(0.030, 0.026, 0.120, 32); },
     .maxFrequencyHz = 22000,
     .shapeVertexCount = 128,
     .listeners = Listeners::allAround},
    {.name = "floor",
     .source = "generated wooden floor panel, 1600 x 1600 x 28 mm",
     .material = "Wood",
     .mesh = [] { return sheetMesh(1.6, 1.6, 2500); },
     .thicknessMetres = 0.028,
     .maxFrequencyHz = 5000,
     .shapeVertexCount = 120},
    {.name = "die",
     .source = "generated die, 19 mm",
     .material = "ABS",
     .mesh = [] { return boxMesh(Eigen::Vector3d::Constant(0.019), Eigen::Vector3i::Constant(4)); },
     .maxFrequencyHz = 44000,
     .listeners = Listeners::allAround},
    {.name = "pebble",
     .source = "generated granite pebble, about 52 x 42 x 28 mm",
     .material = "Granite",
     .mesh = pebbleMesh,
     .maxFrequencyHz = 44000,
     .shapeVertexCount = 160,
     .listeners = Listeners::allAround},
    {.name = "washboard",
     .source = "generated ribbed steel sheet, 400 x 120 x 1.5 mm, ribs of 1.2 mm every 16 mm, bent "
               "to 1.5 m",
     .material = "Steel",
     .mesh = washboardMesh,
     .thicknessMetres = 0.0015,
     .maxFrequencyHz = 10000,
     .shapeVertexCount = 200},
};

std::array<std::span<const FactoryShape>, 3> shapeTables() {
    return {shapes, factoryShells(), factoryBlocks()};
}

} // namespace

std::vector<std::string> factoryObjectNames() {
    std::vector<std::string> names;
    for (const auto& instrument : barInstruments())
        for (int note = instrument.lowestNote; note <= instrument.highestNote; ++note)
            names.push_back(instrument.barName(note));
    for (const auto& table : shapeTables())
        for (const auto& shape : table)
            names.emplace_back(shape.name);
    for (const auto& more : {factoryTubeNames(), factoryRodNames()})
        names.insert(names.end(), more.begin(), more.end());
    return names;
}

Result<ModalObject> makeFactoryObject(const std::string& name, const WorkControl& control) {
    for (const auto& instrument : barInstruments())
        for (int note = instrument.lowestNote; note <= instrument.highestNote; ++note)
            if (instrument.barName(note) == name)
                return tuneBar(instrument.barAt(note, noteFrequencyHz(note)), control)
                    .map([](TunedBar tuned) { return std::move(tuned.object); });
    for (const auto& table : shapeTables())
        if (const auto shape = std::ranges::find(table, name, &FactoryShape::name);
            shape != table.end())
            return analysedShape(*shape, control);
    if (auto tube = makeFactoryTube(name, control))
        return std::move(*tube);
    if (auto rod = makeFactoryRod(name, control))
        return std::move(*rod);
    return failure("there is no factory object '" + name + "'");
}

} // namespace idiophone
