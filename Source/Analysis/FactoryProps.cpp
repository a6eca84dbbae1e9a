#include "Analysis/FactoryProps.h"

#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/SpreadVertices.h"

#include <cmath>
#include <numbers>
#include <string_view>

namespace idiophone {
namespace {

std::vector<int> someVertices(const Mesh& mesh, std::size_t count) {
    return spreadVertices(mesh, allVertices(mesh), count);
}

/// A hollow ring, like a curtain ring.
Result<ModalObject> makeSmallRing(const WorkControl& control) {
    return analyse(torusMesh(0.05, 0.006, 20, 10),
                   {.name = "small-ring",
                    .source = "generated hollow steel ring, radius 50 mm, round section of 12 mm, "
                              "200 vertices as in Raghuvanshi & Lin 2006",
                    .material = *findMaterial("Steel"),
                    .method = AnalysisMethod::twoLayer,
                    .thicknessMetres = 0.001,
                    .maxFrequencyHz = 22000,
                    .listeningDirections = directionsAllAround(),
                    .radiation = RadiationMethod::exact},
                   control);
}

Result<ModalObject> makeLongTable(const WorkControl& control) {
    const Mesh mesh = sheetMesh(1.2, 0.8, 600);
    return analyse(mesh,
                   {.name = "long-table",
                    .source = "generated wooden table top, 1200 x 800 x 20 mm, about 600 vertices "
                              "as in Raghuvanshi & Lin 2006",
                    .material = *findMaterial("Wood"),
                    .method = AnalysisMethod::twoLayer,
                    .thicknessMetres = 0.020,
                    .maxFrequencyHz = 10000,
                    .shapeVertices = someVertices(mesh, 200),
                    .radiation = RadiationMethod::exact},
                   control);
}

Result<ModalObject> makeCylinder(const WorkControl& control) {
    const Mesh mesh = tubeMesh(0.030, 0.026, 0.120, 32);
    return analyse(mesh,
                   {.name = "cylinder",
                    .source =
                        "generated steel tube, 60 x 4 x 120 mm, 128 vertices, 32 around, as in "
                        "Raghuvanshi & Lin 2006",
                    .material = *findMaterial("Steel"),
                    .method = AnalysisMethod::tetrahedra,
                    .maxFrequencyHz = 22000,
                    .shapeVertices = someVertices(mesh, 128),
                    .listeningDirections = directionsAllAround(),
                    .radiation = RadiationMethod::exact},
                   control);
}

Result<ModalObject> makeFloor(const WorkControl& control) {
    const Mesh mesh = sheetMesh(1.6, 1.6, 2500);
    return analyse(mesh,
                   {.name = "floor",
                    .source = "generated wooden floor panel, 1600 x 1600 x 28 mm",
                    .material = *findMaterial("Wood"),
                    .method = AnalysisMethod::twoLayer,
                    .thicknessMetres = 0.028,
                    .maxFrequencyHz = 5000,
                    .shapeVertices = someVertices(mesh, 120),
                    .radiation = RadiationMethod::exact},
                   control);
}

Result<ModalObject> makeDie(const WorkControl& control) {
    return analyse(boxMesh(Eigen::Vector3d::Constant(0.019), Eigen::Vector3i::Constant(4)),
                   {.name = "die",
                    .source = "generated die, 19 mm",
                    .material = *findMaterial("ABS"),
                    .method = AnalysisMethod::tetrahedra,
                    .maxFrequencyHz = 44000,
                    .listeningDirections = directionsAllAround(),
                    .radiation = RadiationMethod::exact},
                   control);
}

Result<ModalObject> makePebble(const WorkControl& control) {
    Mesh mesh = icosphereMesh(1, 3);
    for (Eigen::Index i = 0; i < mesh.vertexCount(); ++i) {
        const Eigen::RowVector3d unit = mesh.vertices.row(i);
        // Three shallow waves make it look worn, but not round.
        const double bump = 1 + 0.05 * std::sin(2.1 * unit.x() + 0.7) * std::cos(2.7 * unit.y()) +
                            0.03 * std::sin(3.3 * unit.z() + 1.1 * unit.x());
        mesh.vertices.row(i) = bump * unit.cwiseProduct(Eigen::RowVector3d(0.026, 0.021, 0.014));
    }
    return analyse(mesh,
                   {.name = "pebble",
                    .source = "generated granite pebble, about 52 x 42 x 28 mm",
                    .material = *findMaterial("Granite"),
                    .method = AnalysisMethod::tetrahedra,
                    .maxFrequencyHz = 44000,
                    .shapeVertices = someVertices(mesh, 160),
                    .listeningDirections = directionsAllAround(),
                    .radiation = RadiationMethod::exact},
                   control);
}

/// The sheet has ribs across and is bent along, so that bodies roll back and forth on it.
Result<ModalObject> makeWashboard(const WorkControl& control) {
    constexpr double ribMetres = 0.016, ribHeightMetres = 0.0006, bendRadiusMetres = 1.5;
    Mesh mesh = sheetMesh(0.40, 0.12, 2600);
    for (Eigen::Index i = 0; i < mesh.vertexCount(); ++i) {
        const double x = mesh.vertices(i, 0);
        mesh.vertices(i, 2) = x * x / (2 * bendRadiusMetres) +
                              ribHeightMetres * std::cos(2 * std::numbers::pi * x / ribMetres);
    }
    return analyse(mesh,
                   {.name = "washboard",
                    .source = "generated ribbed steel sheet, 400 x 120 x 1.5 mm, ribs of 1.2 mm "
                              "every 16 mm, bent to 1.5 m",
                    .material = *findMaterial("Steel"),
                    .method = AnalysisMethod::twoLayer,
                    .thicknessMetres = 0.0015,
                    .maxFrequencyHz = 10000,
                    .shapeVertices = someVertices(mesh, 200),
                    .radiation = RadiationMethod::exact},
                   control);
}

struct Prop {
    std::string_view name;
    Result<ModalObject> (*make)(const WorkControl&);
};
constexpr Prop props[] = {{"small-ring", makeSmallRing},
                          {"long-table", makeLongTable},
                          {"cylinder", makeCylinder},
                          {"floor", makeFloor},
                          {"die", makeDie},
                          {"pebble", makePebble},
                          {"washboard", makeWashboard}};

} // namespace

std::vector<std::string> factoryPropNames() {
    std::vector<std::string> names;
    for (const auto& prop : props)
        names.emplace_back(prop.name);
    return names;
}

Result<ModalObject> makeFactoryProp(const std::string& name, const WorkControl& control) {
    for (const auto& prop : props)
        if (prop.name == name)
            return prop.make(control);
    return failure("there is no factory object '" + name + "'");
}

} // namespace idiophone
