#include "Analysis/ModalAnalysis.h"

#include "Analysis/BodyModel.h"
#include "Analysis/MethodChoice.h"
#include "Analysis/SolidBody.h"
#include "Analysis/SpringMassModel.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/MeshRepair.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace idiophone {
namespace {

std::string faultOf(const AnalysisSettings& settings) {
    if (!(settings.thicknessMetres > 0) || !(settings.thicknessMetres < 1e3))
        return "The thickness must be a positive number of metres.";
    if (!(settings.lowestFrequencyHz > 0) ||
        !(settings.maxFrequencyHz > settings.lowestFrequencyHz) || !(settings.maxFrequencyHz < 1e7))
        return "The band of the analysis must reach from a positive frequency up to less than "
               "10 MHz.";
    if (settings.maximumModes < 1)
        return "The limit on the number of modes must be positive.";
    if (settings.elementBudget < 1)
        return "The number of elements must be positive.";
    return {};
}

/// The sentences that are not empty, one after another.
std::string joined(std::initializer_list<std::string> sentences) {
    std::string text;
    for (const std::string& sentence : sentences)
        if (!sentence.empty())
            text += (text.empty() ? "" : " ") + sentence;
    return text;
}

/// The method asked for, if the mesh allows it, or the one that suits the mesh.
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

/// The shell's model, and where its points lie.
BodyModel shellBody(const Mesh& mesh, AnalysisMethod method, const AnalysisSettings& settings) {
    BodyModel body;
    body.surface = mesh;
    body.thicknessMetres = settings.thicknessMetres;
    body.material = settings.material;
    if (method == AnalysisMethod::twoLayer) {
        body.model = twoLayerShell(mesh, settings.material, settings.thicknessMetres);
        const Eigen::MatrixXd offsets =
            layerOffsetMetres(settings.thicknessMetres) * vertexNormals(mesh);
        body.pointsMetres.resize(2 * mesh.vertexCount(), 3);
        for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v) {
            body.pointsMetres.row(2 * v) = mesh.vertices.row(v) + offsets.row(v);
            body.pointsMetres.row(2 * v + 1) = mesh.vertices.row(v) - offsets.row(v);
        }
        if (isTooThick(mesh, settings.thicknessMetres))
            body.notes =
                "The shell is thicker than its curvature allows in places; pitches may be off "
                "there.";
    } else {
        body.model =
            springMassModel(mesh, settings.material, settings.thicknessMetres,
                            method == AnalysisMethod::springMass ? SpringStiffness::literal
                                                                 : SpringStiffness::vanGelder);
        body.pointsMetres = mesh.vertices;
    }
    return body;
}

/// What is to be solved, up to which frequency.
struct PreparedBody {
    BodyModel body;
    double maxFrequencyHz = 0;
};

Result<PreparedBody> preparedShell(const RepairedMesh& repaired,
                                   AnalysisMethod method,
                                   const AnalysisSettings& settings) {
    const int limit =
        method == AnalysisMethod::twoLayer ? twoLayerVertexLimit : springMassVertexLimit;
    if (repaired.mesh.vertexCount() > limit)
        return failure("The mesh has " + std::to_string(repaired.mesh.vertexCount()) +
                       " vertices after repair, and the " + std::string(methodName(method)) +
                       " method takes at most " + std::to_string(limit) +
                       "; simplify the mesh first.");
    return PreparedBody{shellBody(repaired.mesh, method, settings), settings.maxFrequencyHz};
}

Result<PreparedBody>
preparedSolid(const Mesh& mesh, const AnalysisSettings& settings, const AnalysisControl& control) {
    auto solid = solidBody(mesh,
                           {.material = settings.material,
                            .law = elasticLaw(settings.material),
                            .maxFrequencyHz = settings.maxFrequencyHz,
                            .elementBudget = settings.elementBudget},
                           control);
    if (!solid)
        return failure(solid.error().message);
    if (solid->maxFrequencyHz < settings.maxFrequencyHz) {
        auto& notes = solid->body.notes;
        notes += (notes.empty() ? "" : " ") + std::string("The band ends at ") +
                 std::to_string(std::lround(solid->maxFrequencyHz)) +
                 " Hz, the highest that elements of an affordable size follow.";
    }
    return PreparedBody{std::move(solid->body), solid->maxFrequencyHz};
}

/// Ascending vertices of `surface` nearest to these of the repaired mesh, which it may replace.
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

} // namespace

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
    const auto choice = methodFor(repaired->mesh, settings, control.cancelled);
    if (!choice)
        return failure(choice.error().message);
    if (control.isCancelled())
        return failure(std::string(cancelledMessage));

    auto prepared = choice->method == AnalysisMethod::tetrahedra
                        ? preparedSolid(repaired->mesh, settings, control)
                        : preparedShell(*repaired, choice->method, settings);
    if (!prepared)
        return failure(prepared.error().message);
    BodyModel& body = prepared->body;
    body.method = methodName(choice->method);
    body.components = connectedComponents(repaired->mesh).count;
    body.notes = joined({repaired->report.text(), choice->reason, body.notes});
    auto object =
        solveBody(body,
                  {.name = settings.name,
                   .source = settings.source,
                   .lowestFrequencyHz = settings.lowestFrequencyHz,
                   .maxFrequencyHz = prepared->maxFrequencyHz,
                   .maximumModes = settings.maximumModes,
                   .shapeVertices = settings.shapeVertices.empty()
                                        ? std::vector<int>{}
                                        : nearestVertices(body.surface, repaired->mesh, *vertices)},
                  control);
    if (!object)
        return object;
    object->provenance.analysisSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    control.report(1, "Done");
    return object;
}

} // namespace idiophone
