#include "Analysis/ModalAnalysis.h"

#include "Analysis/Eigensolver.h"
#include "Analysis/Radiation.h"
#include "Analysis/SpringMassModel.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/MeshRepair.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr std::array<std::pair<AnalysisMethod, std::string_view>, 3> methodNames{
    {{AnalysisMethod::twoLayer, "two-layer"},
     {AnalysisMethod::springMass, "spring-mass"},
     {AnalysisMethod::vanGelder, "van-gelder"}}};

std::string faultOf(const AnalysisSettings& settings) {
    if (!(settings.thicknessMetres > 0) || !(settings.thicknessMetres < 1e3))
        return "The thickness must be a positive number of metres.";
    if (!(settings.lowestFrequencyHz > 0) ||
        !(settings.maxFrequencyHz > settings.lowestFrequencyHz) || !(settings.maxFrequencyHz < 1e7))
        return "The band of the analysis must reach from a positive frequency up to less than "
               "10 MHz.";
    if (settings.maximumModes < 1)
        return "The limit on the number of modes must be positive.";
    return {};
}

VibrationModel modelOf(const Mesh& mesh, const AnalysisSettings& settings) {
    if (settings.method == AnalysisMethod::twoLayer)
        return twoLayerShell(mesh, settings.material, settings.thicknessMetres);
    return springMassModel(mesh, settings.material, settings.thicknessMetres,
                           settings.method == AnalysisMethod::springMass
                               ? SpringStiffness::literal
                               : SpringStiffness::vanGelder);
}

/// Of the masses that the model has: for two layers, those at ± t/√12, which is a plate's inertia.
MassProperties massProperties(const Mesh& mesh, const AnalysisSettings& settings) {
    const Eigen::VectorXd masses =
        settings.material.densityKgPerM3 * settings.thicknessMetres * vertexAreas(mesh);
    MassProperties result{.massKg = masses.sum(), .centreMetres = {}, .inertiaKgM2 = {}};
    const Eigen::RowVector3d centre = masses.transpose() * mesh.vertices / result.massKg;
    const double offset = settings.method == AnalysisMethod::twoLayer
                              ? layerOffsetMetres(settings.thicknessMetres)
                              : 0;
    const Eigen::MatrixXd normals = vertexNormals(mesh);
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero(); // Σ m x xᵀ
    for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v)
        for (const double side : {-offset, offset}) {
            const Eigen::RowVector3d x = mesh.vertices.row(v) + side * normals.row(v) - centre;
            second += masses(v) / 2 * x.transpose() * x;
        }
    const Eigen::Matrix3d inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
    Eigen::Map<Eigen::RowVector3d>(result.centreMetres.data()) = centre;
    Eigen::Map<Eigen::Matrix3d>(result.inertiaKgM2.data()) = inertia; // symmetric: either order
    return result;
}

/// The vertices of the repaired mesh that carry shapes, ascending; all when none are named.
Result<std::vector<int>> shapeVertices(const AnalysisSettings& settings,
                                       const RepairedMesh& repaired) {
    std::vector<int> chosen;
    if (settings.shapeVertices.empty()) {
        chosen.resize(static_cast<std::size_t>(repaired.mesh.vertexCount()));
        for (std::size_t i = 0; i < chosen.size(); ++i)
            chosen[i] = static_cast<int>(i);
        return chosen;
    }
    for (const int vertex : settings.shapeVertices) {
        if (vertex < 0 || vertex >= static_cast<int>(repaired.vertexOfInput.size()))
            return failure("A vertex chosen to carry shapes does not exist.");
        if (repaired.vertexOfInput[vertex] >= 0)
            chosen.push_back(repaired.vertexOfInput[vertex]);
    }
    std::ranges::sort(chosen);
    const auto repeated = std::ranges::unique(chosen);
    chosen.erase(repeated.begin(), repeated.end());
    if (chosen.empty())
        return failure("No vertex chosen to carry shapes is part of the repaired mesh.");
    return chosen;
}

/// The two layers must not pass through each other where the surface curves.
bool isTooThick(const Mesh& mesh, double thicknessMetres) {
    const Mesh inner{mesh.vertices - layerOffsetMetres(thicknessMetres) * vertexNormals(mesh),
                     mesh.faces};
    const auto normal = [](const Mesh& m, Eigen::Index face) {
        const auto corner = [&](int k) {
            return Eigen::Vector3d(m.vertices.row(m.faces(face, k)).transpose());
        };
        const Eigen::Vector3d u = corner(1) - corner(0), v = corner(2) - corner(0);
        return Eigen::Vector3d(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
                               u.x() * v.y() - u.y() * v.x());
    };
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        if (normal(mesh, face).dot(normal(inner, face)) <= 0)
            return true;
    return false;
}

std::string
notesOn(const RepairedMesh& repaired, const AnalysisSettings& settings, const Modes& modes) {
    std::string notes = repaired.report.text();
    const auto add = [&](const std::string& sentence) {
        notes += (notes.empty() ? "" : " ") + sentence;
    };
    const Eigen::Index rigid = 6 * static_cast<Eigen::Index>(repaired.report.components);
    if (modes.zeroModes > rigid)
        add("The model has " + std::to_string(modes.zeroModes) + " zero modes where " +
            std::to_string(rigid) +
            " are rigid motion: flat parts bend freely in it; the two-layer method does not.");
    if (modes.belowBand > 0)
        add(std::to_string(modes.belowBand) + " modes below " +
            std::to_string(std::lround(settings.lowestFrequencyHz)) + " Hz were left out.");
    if (settings.method == AnalysisMethod::twoLayer &&
        isTooThick(repaired.mesh, settings.thicknessMetres))
        add("The shell is thicker than its curvature allows in places; pitches may be off there.");
    return notes;
}

/// `shapes` [3N×M] are those of all vertices, of which `vertices` keep theirs.
void storeModes(const Eigen::VectorXd& eigenvalues,
                const Eigen::MatrixXd& shapes,
                const std::vector<int>& vertices,
                ModalObject& object) {
    object.shapes.reserve(vertices.size() * static_cast<std::size_t>(shapes.cols()) * 3);
    for (const int vertex : vertices)
        for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode)
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                object.shapes.push_back(
                    static_cast<float>(shapes(3 * Eigen::Index{vertex} + axis, mode)));
    object.shapeVertices.assign(vertices.begin(), vertices.end());
    object.eigenvalues.assign(eigenvalues.begin(), eigenvalues.end());
}

void storeMesh(const Mesh& mesh, ModalObject& object) {
    for (const auto& vertex : mesh.vertices.rowwise())
        for (const double coordinate : vertex)
            object.vertices.push_back(static_cast<float>(coordinate));
    for (const auto& face : mesh.faces.rowwise())
        object.faces.insert(object.faces.end(), face.begin(), face.end());
}

} // namespace

std::string_view methodName(AnalysisMethod method) {
    return std::ranges::find(methodNames, method, &decltype(methodNames)::value_type::first)
        ->second;
}

std::optional<AnalysisMethod> findMethod(std::string_view name) {
    const auto* found =
        std::ranges::find(methodNames, name, &decltype(methodNames)::value_type::second);
    return found == methodNames.end() ? std::nullopt : std::optional(found->first);
}

Result<ModalObject>
analyse(const Mesh& mesh, const AnalysisSettings& settings, const AnalysisControl& control) {
    const auto start = std::chrono::steady_clock::now();
    if (const auto fault = faultOf(settings); !fault.empty())
        return failure(fault);
    if (const auto material = validated(settings.material); !material)
        return failure(material.error().message);
    control.report(0, "Repairing the mesh");
    const auto repaired = repairMesh(mesh, {.weldTolerance = settings.weldTolerance,
                                            .largestComponentOnly = settings.largestComponentOnly});
    if (!repaired)
        return failure(repaired.error().message);
    const auto vertices = shapeVertices(settings, *repaired);
    if (!vertices)
        return failure(vertices.error().message);
    const int limit =
        settings.method == AnalysisMethod::twoLayer ? twoLayerVertexLimit : springMassVertexLimit;
    if (repaired->mesh.vertexCount() > limit)
        return failure("The mesh has " + std::to_string(repaired->mesh.vertexCount()) +
                       " vertices after repair, and the " +
                       std::string(methodName(settings.method)) + " method takes at most " +
                       std::to_string(limit) + "; simplify the mesh first.");
    if (control.isCancelled())
        return failure(std::string(cancelledMessage));

    const auto modes = solveModes(modelOf(repaired->mesh, settings),
                                  {.lowestHz = settings.lowestFrequencyHz,
                                   .highestHz = settings.maxFrequencyHz,
                                   .maximumModes = settings.maximumModes},
                                  control);
    if (!modes)
        return failure(modes.error().message);
    if (modes->eigenvalues.size() == 0)
        return failure("The object has no mode between " +
                       std::to_string(std::lround(settings.lowestFrequencyHz)) + " and " +
                       std::to_string(std::lround(settings.maxFrequencyHz)) +
                       " Hz; check its size and its unit.");
    ModalObject object;
    object.name = settings.name;
    object.material = settings.material;
    object.body = BodyKind::shell;
    object.thicknessMetres = settings.thicknessMetres;
    object.method = methodName(settings.method);
    object.bandHz = settings.maxFrequencyHz;
    const Eigen::MatrixXd shapes = settings.method == AnalysisMethod::twoLayer
                                       ? midSurfaceShapes(modes->shapes)
                                       : modes->shapes;
    storeModes(modes->eigenvalues, shapes, *vertices, object);
    storeMesh(repaired->mesh, object);
    object.mass = massProperties(repaired->mesh, settings);
    control.report(0.99, "Computing radiation");
    auto radiation = radiationOf({.mesh = repaired->mesh,
                                  .shapes = shapes,
                                  .eigenvalues = modes->eigenvalues,
                                  .thicknessMetres = settings.thicknessMetres,
                                  .centreMetres = Eigen::Vector3d(object.mass.centreMetres.data())},
                                 {}, control);
    if (!radiation)
        return failure(radiation.error().message);
    object.radiation = std::move(*radiation);
    object.provenance = {
        .source = settings.source,
        .software = "Idiophone " IDIOPHONE_VERSION,
        .notes = notesOn(*repaired, settings, *modes),
        .analysisSeconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
        .analysedVertices = repaired->mesh.vertexCount(),
        .zeroModes = modes->zeroModes};
    control.report(1, "Done");
    return validated(std::move(object));
}

} // namespace idiophone
