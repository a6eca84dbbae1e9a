#include "Analysis/ModalAnalysis.h"

#include "Analysis/BodyModel.h"
#include "Analysis/MethodChoice.h"
#include "Analysis/ShellBody.h"
#include "Analysis/SolidBody.h"
#include "Analysis/SpringMassModel.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/MeshRepair.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <initializer_list>
#include <new>
#include <utility>

namespace idiophone {
namespace {

/// Joins the sentences that are not empty.
std::string joined(std::initializer_list<std::string> sentences) {
    std::string text;
    for (const std::string& sentence : sentences)
        if (!sentence.empty())
            text += (text.empty() ? "" : " ") + sentence;
    return text;
}

/// Returns the requested method if the mesh allows it, or the method that suits the mesh.
Result<MethodChoice>
methodFor(const Mesh& mesh, const AnalysisSettings& settings, const std::atomic<bool>* cancelled) {
    if (settings.method && *settings.method != AnalysisMethod::tetrahedra)
        return MethodChoice{*settings.method, {}};
    const MeshCheck check = checkMesh(mesh, cancelled);
    if (!settings.method)
        return chooseMethod(check, settings.thicknessMetres);
    if (!check.isSolid())
        return failure("Finite elements need a body to fill: " + whyNotSolid(check) + ".");
    return MethodChoice{AnalysisMethod::tetrahedra, {}};
}

/// Returns the vertices of the repaired mesh that carry shapes, ascending.
Result<std::vector<int>> shapeVertices(const AnalysisSettings& settings,
                                       const RepairedMesh& repaired) {
    std::vector<int> chosen;
    for (const int vertex : settings.shapeVertices) {
        if (vertex < 0 || vertex >= static_cast<int>(repaired.vertexOfInput.size()))
            return failure("A vertex chosen to carry shapes does not exist.");
        if (repaired.vertexOfInput[vertex] >= 0)
            chosen.push_back(repaired.vertexOfInput[vertex]);
    }
    std::ranges::sort(chosen);
    const auto repeated = std::ranges::unique(chosen);
    chosen.erase(repeated.begin(), repeated.end());
    if (chosen.empty() && !settings.shapeVertices.empty())
        return failure("No vertex chosen to carry shapes is part of the repaired mesh.");
    return chosen;
}

void noteBand(const AnalysisSettings& settings, BodyModel& body) {
    if (body.servedBandHz < settings.maxFrequencyHz)
        body.notes = joined({body.notes, "The band ends at " +
                                             std::to_string(std::lround(body.servedBandHz)) +
                                             " Hz, the highest that a model of an affordable size "
                                             "follows."});
}

Result<BodyModel>
preparedShell(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    auto shell = shellBody(mesh,
                           {.material = settings.material,
                            .thicknessMetres = settings.thicknessMetres,
                            .maxFrequencyHz = settings.maxFrequencyHz,
                            .fitsMesh = !settings.method || mesh.vertexCount() > shellVertexLimit},
                           control);
    if (shell)
        noteBand(settings, *shell);
    return shell;
}

Result<BodyModel>
preparedSprings(const Mesh& mesh, AnalysisMethod method, const AnalysisSettings& settings) {
    if (mesh.vertexCount() > springMassVertexLimit)
        return failure("The mesh has " + std::to_string(mesh.vertexCount()) +
                       " vertices after repair, and the " + std::string(methodName(method)) +
                       " method takes at most " + std::to_string(springMassVertexLimit) +
                       "; simplify the mesh first.");
    const auto stiffness = method == AnalysisMethod::springMass ? SpringStiffness::literal
                                                                : SpringStiffness::vanGelder;
    BodyModel body;
    body.surface = mesh;
    body.model = springMassModel(mesh, settings.material, settings.thicknessMetres, stiffness);
    body.pointsMetres = mesh.vertices;
    body.material = settings.material;
    body.thicknessMetres = settings.thicknessMetres;
    body.servedBandHz = settings.maxFrequencyHz;
    return body;
}

Result<BodyModel>
preparedSolid(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    const GrainAxes axes = grainAlong(mesh);
    auto solid = solidBody(mesh,
                           {.material = settings.material,
                            .law = elasticLaw(settings.material, axes),
                            .maxFrequencyHz = settings.maxFrequencyHz,
                            .elementBudget = settings.elementBudget},
                           control);
    if (!solid)
        return failure(solid.error().message);
    if (settings.material.grain)
        solid->notes = joined({std::string("The grain runs along ") +
                                   (axes.grain.x() > 0   ? "x"
                                    : axes.grain.y() > 0 ? "y"
                                                         : "z") +
                                   ", the longest side.",
                               solid->notes});
    noteBand(settings, *solid);
    return solid;
}

Result<BodyModel> bodyBy(AnalysisMethod method,
                         const Mesh& mesh,
                         const AnalysisSettings& settings,
                         const WorkControl& control) {
    switch (method) {
    case AnalysisMethod::tetrahedra:
        return preparedSolid(mesh, settings, control);
    case AnalysisMethod::twoLayer:
        return preparedShell(mesh, settings, control);
    default:
        return preparedSprings(mesh, method, settings);
    }
}

/// Counts the parts that move separately. A hollow is not one.
int componentsOf(const BodyModel& body, const RepairReport& report) {
    const int surfaces = connectedComponents(body.surface).count;
    return body.body == BodyKind::solid ? std::max(1, surfaces - report.hollows) : surfaces;
}

/// Remeshing separates parts that share only a vertex, or an edge of more than two faces.
std::string noteOnParts(const BodyModel& body, const RepairReport& report) {
    const int more = connectedComponents(body.surface).count - report.components;
    if (more <= 0)
        return {};
    return "Remeshing parted what hung together at single vertices or at edges of more than two "
           "faces alone: " +
           std::to_string(more + report.components) + " parts now move by themselves.";
}

/// Builds the body by the chosen method. If tetrahedra were an automatic choice and do not fill the
/// body, it becomes a shell.
Result<BodyModel> preparedBody(const Mesh& mesh,
                               MethodChoice& choice,
                               const AnalysisSettings& settings,
                               const WorkControl& control) {
    auto prepared = bodyBy(choice.method, mesh, settings, control);
    if (prepared || settings.method || choice.method != AnalysisMethod::tetrahedra ||
        control.isCancelled())
        return prepared;
    choice = shellInstead(prepared.error().message, settings.thicknessMetres);
    return bodyBy(choice.method, mesh, settings, control);
}

/// Returns the vertices of `surface` nearest to these of the repaired mesh, ascending. `surface`
/// may be a remesh of it.
std::vector<int>
nearestVertices(const Mesh& surface, const Mesh& repaired, const std::vector<int>& vertices) {
    std::vector<int> nearest;
    for (const int vertex : vertices) {
        Eigen::Index found = 0;
        (surface.vertices.rowwise() - repaired.vertices.row(vertex))
            .rowwise()
            .squaredNorm()
            .minCoeff(&found);
        nearest.push_back(static_cast<int>(found));
    }
    std::ranges::sort(nearest);
    const auto repeated = std::ranges::unique(nearest);
    nearest.erase(repeated.begin(), repeated.end());
    return nearest;
}

Result<ModalObject>
analyseOrThrow(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    if (const auto usable = validate(settings); !usable)
        return tl::unexpected(usable.error());
    control.report(0, "Repairing the mesh");
    const auto repaired = repairMesh(mesh, {.weldTolerance = settings.weldTolerance,
                                            .largestComponentOnly = settings.largestComponentOnly,
                                            .cancelled = control.cancelled});
    if (!repaired)
        return failure(repaired.error().message);
    const auto vertices = shapeVertices(settings, *repaired);
    if (!vertices)
        return failure(vertices.error().message);
    auto choice = methodFor(repaired->mesh, settings, control.cancelled);
    if (!choice)
        return failure(choice.error().message);
    if (control.isCancelled())
        return cancellation();

    auto body = preparedBody(repaired->mesh, *choice, settings, control);
    if (!body)
        return failure(body.error().message);
    body->method = methodName(choice->method);
    body->components = componentsOf(*body, repaired->report);
    body->notes = joined({repaired->report.text(), choice->reason, body->notes,
                          noteOnParts(*body, repaired->report)});
    return solveBody(*body,
                     {.name = settings.name,
                      .source = settings.source,
                      .lowestFrequencyHz = settings.lowestFrequencyHz,
                      .maxFrequencyHz = body->servedBandHz,
                      .maximumModes = settings.maximumModes,
                      .shapeVertices = nearestVertices(body->surface, repaired->mesh, *vertices),
                      .listeningDirections = settings.listeningDirections,
                      .radiation = settings.radiation},
                     control);
}

} // namespace

Result<void> validate(const AnalysisSettings& settings) {
    if (!(settings.thicknessMetres > 0) || !(settings.thicknessMetres < 1e3))
        return failure("The thickness must be a positive number of metres.");
    if (!(settings.lowestFrequencyHz > 0) ||
        !(settings.maxFrequencyHz > settings.lowestFrequencyHz) || !(settings.maxFrequencyHz < 1e7))
        return failure("The band of the analysis must reach from a positive frequency up to less "
                       "than 10 MHz.");
    if (settings.maximumModes < 1)
        return failure("The limit on the number of modes must be positive.");
    if (settings.elementBudget < 1)
        return failure("The number of elements must be positive.");
    return validated(settings.material).map([](const Material&) {});
}

Result<ModalObject>
analyse(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    const auto start = std::chrono::steady_clock::now();
    try {
        auto object = analyseOrThrow(mesh, settings, control);
        if (!object)
            return object;
        object->provenance.analysisSeconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        control.report(1, "Done");
        return object;
    } catch (const std::bad_alloc&) {
        return failure("The analysis needs more memory than this machine has.");
    } catch (const std::exception& fault) {
        return failure(std::string("The analysis failed: ") + fault.what() + ".");
    }
}

} // namespace idiophone
