#include "Analysis/FactoryShape.h"

#include "Analysis/ModalAnalysis.h"
#include "Analysis/SlitShell.h"
#include "Analysis/SolidShell.h"
#include "Geometry/SpreadVertices.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <string>

namespace idiophone {
namespace {

std::vector<int> shapeVertices(const FactoryShape& shape, const Mesh& mesh) {
    if (shape.shapeVertexCount == 0)
        return {};
    return spreadVertices(mesh, allVertices(mesh), shape.shapeVertexCount);
}

/// 8° apart. Neither x nor y is 0, and the strike at the front has both on one side.
std::vector<Eigen::Vector3d> directionsBeside() {
    std::vector<Eigen::Vector3d> directions;
    constexpr double elevation = 20, degree = std::numbers::pi / 180;
    for (const double azimuth : {62.0, 70.0})
        directions.emplace_back(std::cos(elevation * degree) * std::cos(azimuth * degree),
                                std::cos(elevation * degree) * std::sin(azimuth * degree),
                                std::sin(elevation * degree));
    return directions;
}

std::vector<Eigen::Vector3d> listeningDirections(const FactoryShape& shape) {
    switch (shape.listeners) {
    case Listeners::allAround:
        return directionsAllAround();
    case Listeners::beside:
        return directionsBeside();
    default:
        return stereoDirections();
    }
}

/// Adds Δα = R/2 φ² of the held place to the decay of each mode.
void addHeldLoss(ModalObject& object, const FactoryShape& shape) {
    object.extraDecaysPerSecond.resize(object.modeCount());
    const auto held = object.shapesAt(nearestShapeRow(object, shape.heldAtMetres));
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        for (const float along : held.subspan(3 * mode, 3))
            object.extraDecaysPerSecond[mode] +=
                shape.heldResistanceNsPerM / 2 * static_cast<double>(along * along);
}

Result<ModalObject> analysedMesh(const FactoryShape& shape, const WorkControl& control) {
    const Mesh mesh = shape.mesh();
    const bool isSolid = shape.thicknessMetres == 0;
    AnalysisSettings settings{.name = std::string(shape.name),
                              .source = std::string(shape.source),
                              .material = *findMaterial(shape.material),
                              .method =
                                  isSolid ? AnalysisMethod::tetrahedra : AnalysisMethod::twoLayer,
                              .maxFrequencyHz = shape.maxFrequencyHz,
                              .shapeVertices = shapeVertices(shape, mesh),
                              .listeningDirections = listeningDirections(shape),
                              .radiation = RadiationMethod::exact};
    if (!isSolid)
        settings.thicknessMetres = shape.thicknessMetres;
    return analyse(mesh, settings, control);
}

Result<ModalObject> analysedWall(const FactoryShape& shape, const WorkControl& control) {
    const auto start = std::chrono::steady_clock::now();
    const LatheMesh wall =
        shape.wall != nullptr ? shape.wall() : latheMesh(shape.section(), shape.edgeMetres);
    const Material material = *findMaterial(shape.material);
    const SolveSettings settings{.name = std::string(shape.name),
                                 .source = std::string(shape.source),
                                 .maxFrequencyHz = shape.maxFrequencyHz,
                                 .shapeVertices = shapeVertices(shape, wall.mesh),
                                 .listeningDirections = listeningDirections(shape),
                                 .radiation = RadiationMethod::exact};
    auto object =
        shape.isSlit != nullptr
            ? solveSlitShell(slitShell(wall, shape.isSlit), material, settings, control)
            : solveBody(solidShell(wall.mesh, wall.thicknessMetres, material), settings, control);
    if (!object)
        return object;
    if (shape.heldResistanceNsPerM > 0)
        addHeldLoss(*object, shape);
    object->provenance.analysisSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return object;
}

} // namespace

Result<ModalObject> analysedShape(const FactoryShape& shape, const WorkControl& control) {
    return shape.mesh != nullptr ? analysedMesh(shape, control) : analysedWall(shape, control);
}

} // namespace idiophone
