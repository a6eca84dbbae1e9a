#include "Analysis/ModalAnalysis.h"

#include "Analysis/BodyModel.h"
#include "Analysis/Eigensolver.h"
#include "Analysis/HeldBody.h"
#include "Analysis/MethodChoice.h"
#include "Analysis/ShellBody.h"
#include "Analysis/SolidBody.h"
#include "Analysis/SpringMassModel.h"
#include "Geometry/Decimation.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/MeshRepair.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

namespace idiophone {
namespace {

// Measured: repair and decimation of 20,000 triangles take as long as this many elements.
constexpr int previewElements = 300, previewShellVertices = 300;
/// More modes would make previews longer than two seconds (docs/decisions/0023).
constexpr int previewModes = 350;

/// One analysis: the whole one, or the preview of few elements.
struct Task {
    AnalysisSettings settings;
    const WorkControl& control;
    bool isPreview = false;
};

/// Returns the requested method if the mesh allows it, or the method that suits the mesh.
Result<MethodChoice> methodFor(const Mesh& mesh, const Task& task) {
    const auto& settings = task.settings;
    if (settings.method && *settings.method != AnalysisMethod::tetrahedra)
        return MethodChoice{task.isPreview ? AnalysisMethod::twoLayer : *settings.method, {}};
    const MeshCheck check = checkMesh(mesh, task.control.cancelled);
    if (!settings.method)
        return chooseMethod(check, settings.thicknessMetres);
    if (!check.isSolid())
        return failure("The mesh cannot be taken as a solid, because " + whyNotSolid(check) +
                       "; choose a shell, or repair it in its own program.");
    return MethodChoice{AnalysisMethod::tetrahedra, {}};
}

void makeSortedSet(std::vector<int>& values) {
    std::ranges::sort(values);
    values.erase(std::ranges::unique(values).begin(), values.end());
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
    makeSortedSet(chosen);
    if (chosen.empty() && !settings.shapeVertices.empty())
        return failure("No vertex chosen to carry shapes is part of the repaired mesh.");
    return chosen;
}

Result<BodyModel> springBody(const Mesh& mesh, AnalysisMethod method, const Task& task) {
    const auto& settings = task.settings;
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

Result<BodyModel> grainedSolid(const Mesh& mesh, const Task& task) {
    const auto& settings = task.settings;
    const GrainAxes axes = grainAlong(mesh);
    auto solid = solidBody(mesh,
                           {.material = settings.material,
                            .law = elasticLaw(settings.material, axes),
                            .maxFrequencyHz = settings.maxFrequencyHz,
                            .elementBudget = settings.elementBudget},
                           task.control);
    if (solid && settings.material.grain) {
        const char* axis = axes.grain.x() > 0 ? "x" : axes.grain.y() > 0 ? "y" : "z";
        solid->notes = joinedSentences(
            {std::string("The grain runs along ") + axis + ", the longest side.", solid->notes});
    }
    return solid;
}

Result<BodyModel> bodyBy(AnalysisMethod method, const Mesh& mesh, const Task& task) {
    const auto& settings = task.settings;
    switch (method) {
    case AnalysisMethod::tetrahedra:
        return grainedSolid(mesh, task);
    case AnalysisMethod::twoLayer:
        return shellBody(
            mesh,
            {.material = settings.material,
             .thicknessMetres = settings.thicknessMetres,
             .maxFrequencyHz = settings.maxFrequencyHz,
             .vertexBudget = task.isPreview ? previewShellVertices : defaultShellVertices,
             .fitsMesh =
                 task.isPreview || !settings.method || mesh.vertexCount() > shellVertexLimit},
            task.control);
    default:
        return springBody(mesh, method, task);
    }
}

/// Counts the parts that move separately. A hollow does not count.
int componentsOf(const BodyModel& body, const RepairReport& report) {
    const int surfaces = connectedComponents(body.surface).count;
    return body.body == BodyKind::solid ? std::max(1, surfaces - report.hollows) : surfaces;
}

std::string noteOnBand(const BodyModel& body, const AnalysisSettings& settings) {
    if (body.servedBandHz >= settings.maxFrequencyHz)
        return {};
    return "The band ends at " + std::to_string(std::lround(body.servedBandHz)) +
           " Hz, the highest that a model of an affordable size follows.";
}

/// Remeshing separates parts that share only a vertex, or an edge of more than two faces.
std::string noteOnParts(const BodyModel& body, const RepairReport& report) {
    const int more = connectedComponents(body.surface).count - report.components;
    if (more <= 0)
        return {};
    return "Parts that met only at a point, or at an edge of more than two faces, are now "
           "separate: each of " +
           std::to_string(more + report.components) + " parts moves by itself.";
}

/// Builds the body by the chosen method. If tetrahedra were an automatic choice and do not fill the
/// body, it becomes a shell.
Result<BodyModel> bodyFor(MethodChoice& choice, const Mesh& mesh, const Task& task) {
    auto body = bodyBy(choice.method, mesh, task);
    if (body || task.settings.method || choice.method != AnalysisMethod::tetrahedra ||
        task.control.isCancelled())
        return body;
    choice = shellInstead(body.error().message, task.settings.thicknessMetres);
    return bodyBy(choice.method, mesh, task);
}

/// Returns the vertices of `surface` nearest to the given vertices of the repaired mesh, ascending.
/// `surface` may be a remesh of that mesh.
std::vector<int>
nearestVertices(const Mesh& surface, const Mesh& repaired, const std::vector<int>& vertices) {
    std::vector<int> nearest;
    for (const int vertex : vertices)
        nearest.push_back(nearestVertex(surface, repaired.vertices.row(vertex)));
    makeSortedSet(nearest);
    return nearest;
}

/// Returns the end of a preview's band: beyond what its elements resolve, up to a number of modes,
/// because a mode that is some per cent off sounds nearer to the object than none.
double previewBandHz(const BodyModel& body, double maxFrequencyHz) {
    const auto isAffordable = [&](double hz) {
        const auto modes = countModesBelow(body.model, hz);
        return modes && *modes <= previewModes;
    };
    if (isAffordable(maxFrequencyHz))
        return maxFrequencyHz;
    constexpr double lowestPreviewHz = 100;
    double low = std::clamp(body.servedBandHz, lowestPreviewHz, maxFrequencyHz);
    double high = maxFrequencyHz;
    for (int step = 0; step < 8; ++step) {
        const double middle = std::sqrt(low * high);
        (isAffordable(middle) ? low : high) = middle;
    }
    return low;
}

/// Solves the body in the band that its elements resolve, and a preview beyond.
Result<ModalObject>
solved(const BodyModel& body, const std::vector<int>& shapeVertices, const Task& task) {
    const auto& settings = task.settings;
    return solveBody(body,
                     {.name = settings.name,
                      .source = settings.source,
                      .lowestFrequencyHz = settings.lowestFrequencyHz,
                      .maxFrequencyHz = task.isPreview
                                            ? previewBandHz(body, settings.maxFrequencyHz)
                                            : body.servedBandHz,
                      .maximumModes = settings.maximumModes,
                      .shapeVertices = shapeVertices,
                      .listeningDirections = settings.listeningDirections,
                      .radiation = settings.radiation,
                      .threads = settings.threads},
                     task.control);
}

Result<ModalObject> analysed(const Mesh& mesh, const Task& task) {
    const auto& [settings, control, isPreview] = task;
    if (const auto usable = validate(settings); !usable)
        return tl::unexpected(usable.error());
    control.report(0, "Repairing the mesh");
    auto repaired = repairMesh(mesh, {.largestComponentOnly = settings.largestComponentOnly,
                                      .cancelled = control.cancelled});
    if (!repaired)
        return tl::unexpected(repaired.error());
    const auto vertices = shapeVertices(settings, *repaired);
    if (!vertices)
        return tl::unexpected(vertices.error());
    if (isPreview && repaired->mesh.vertexCount() > previewVertices) {
        auto light = decimate(repaired->mesh, previewVertices, control.quiet());
        if (!light)
            return tl::unexpected(light.error());
        repaired->mesh = std::move(*light);
    }
    auto choice = methodFor(repaired->mesh, task);
    if (!choice)
        return tl::unexpected(choice.error());
    if (control.isCancelled())
        return cancellation();
    auto body = bodyFor(*choice, repaired->mesh, task);
    if (!body)
        return tl::unexpected(body.error());
    body->method = methodName(choice->method);
    body->components = componentsOf(*body, repaired->report);
    if (const auto held = holdBody(*body, mesh, settings.support); !held)
        return tl::unexpected(held.error());
    body->notes =
        joinedSentences({repaired->report.text(), choice->reason, body->notes,
                         noteOnBand(*body, settings), noteOnParts(*body, repaired->report)});
    auto object = solved(*body, nearestVertices(body->surface, repaired->mesh, *vertices), task);
    if (object && isPreview)
        object->provenance.notes = "A preview of few elements.";
    return object;
}

/// The boundary of the module: turns exceptions into errors.
Result<ModalObject> analysedInTime(const Mesh& mesh, const Task& task) {
    const auto start = std::chrono::steady_clock::now();
    try {
        auto object = analysed(mesh, task);
        if (object) {
            object->provenance.analysisSeconds =
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            task.control.report(1, "Done");
        }
        return object;
    } catch (const std::bad_alloc&) {
        return failure("The analysis needs more memory than this machine has.");
    } catch (const std::exception& fault) {
        return failure(std::string("The analysis failed: ") + fault.what() + ".");
    }
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
    if (const auto support = validate(settings.support); !support)
        return support;
    return validated(settings.material).map([](const Material&) {});
}

Result<ModalObject>
analyse(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    return analysedInTime(mesh, {settings, control});
}

Result<ModalObject>
analysePreview(const Mesh& mesh, const AnalysisSettings& settings, const WorkControl& control) {
    Task task{settings, control, true};
    task.settings.elementBudget = previewElements;
    task.settings.shapeVertices.clear();
    task.settings.listeningDirections = stereoDirections();
    task.settings.radiation = RadiationMethod::preview;
    return analysedInTime(mesh, task);
}

} // namespace idiophone
