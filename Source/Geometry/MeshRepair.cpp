#include "Geometry/MeshRepair.h"

#include "Geometry/EdgePairing.h"
#include "Geometry/FaceOrientation.h"
#include "Geometry/ManifoldCut.h"
#include "Geometry/MeshCleaning.h"
#include "Geometry/TJunctions.h"
#include "Geometry/VertexWelding.h"
#include "Object/WorkControl.h"

#include <algorithm>
#include <optional>

namespace idiophone {
namespace {

std::optional<std::string> faultOfIndices(const Mesh& mesh) {
    if (mesh.faceCount() == 0)
        return "The mesh has no faces.";
    if (mesh.vertices.cols() != 3 || mesh.faces.cols() != 3 || mesh.faces.minCoeff() < 0 ||
        mesh.faces.maxCoeff() >= mesh.vertexCount())
        return "The mesh has a face that names a vertex that does not exist.";
    return std::nullopt;
}

std::optional<std::string> faultOfPlaces(const Mesh& mesh) {
    constexpr double largestMetres = 1e9, smallestMetres = 1e-9;
    if (!mesh.vertices.allFinite())
        return "The mesh has a vertex that is not a finite number.";
    if (mesh.vertices.cwiseAbs().maxCoeff() > largestMetres)
        return "The mesh reaches farther than a million kilometres; its unit must be wrong.";
    const double diagonalMetres = boundingDiagonalMetres(mesh);
    if (!(diagonalMetres > 0))
        return "The mesh has all its vertices in one point.";
    if (diagonalMetres < smallestMetres)
        return "The mesh is smaller than a nanometre; its unit must be wrong.";
    return std::nullopt;
}

void renumber(std::vector<int>& vertexOfInput, const std::vector<int>& newNumber) {
    for (int& vertex : vertexOfInput)
        vertex = vertex < 0 ? -1 : newNumber[vertex];
}

void dropUnusedVertices(RepairedMesh& repaired) {
    const auto before = repaired.mesh.vertexCount();
    renumber(repaired.vertexOfInput, dropUnreferencedVertices(repaired.mesh));
    repaired.report.unreferencedVertices += static_cast<int>(before - repaired.mesh.vertexCount());
}

void dropUnusable(RepairedMesh& repaired) {
    repaired.report.degenerateFaces += dropDegenerateFaces(repaired.mesh);
    repaired.report.duplicateFaces += dropDuplicateFaces(repaired.mesh);
    dropUnusedVertices(repaired);
}

void joinTJunctions(RepairedMesh& repaired, double weldTolerance, const WorkControl& control) {
    // A round drops faces and may put new vertices onto the boundary, so repeat. If the rounds do
    // not end, leave the mesh as it is.
    constexpr int maximumRounds = 100;
    const auto maximumJoined = 1000 + 2 * repaired.mesh.faceCount();
    for (int round = 0; round < maximumRounds && repaired.report.joinedVertices <= maximumJoined &&
                        !control.isCancelled();
         ++round) {
        // Compute the tolerance from the remaining mesh, as a second repair would.
        const double toleranceMetres = 10 * weldTolerance * boundingDiagonalMetres(repaired.mesh);
        const int joined = splitTJunctions(repaired.mesh, toleranceMetres);
        if (joined == 0)
            return;
        repaired.report.joinedVertices += joined;
        dropUnusable(repaired);
    }
}

void orientAndCut(Mesh& mesh, const RepairSettings& settings, RepairReport& report) {
    auto pairing = pairEdges(mesh);
    const auto orientation = orientFaces(mesh, pairing, settings.cancelled);
    report.flippedFaces = orientation.flippedFaces;
    report.hollows = orientation.hollows;
    report.isTangled = orientation.isTangled;
    report.oneSidedEdges = orientation.oneSidedEdges;
    if (settings.cutIntoManifold) {
        const auto before = mesh.vertexCount();
        cutIntoManifold(mesh, pairing);
        report.cutVertices = static_cast<int>(mesh.vertexCount() - before);
        report.oneSidedEdges = 0;
        if (report.cutVertices > 0)
            pairing = pairEdges(mesh);
    }
    report.boundaryEdges = pairing.boundaryEdges;
    report.nonManifoldEdges = pairing.nonManifoldEdges;
}

} // namespace

bool RepairReport::mayBeCutOff() const {
    constexpr int strayVertices = 8; // for example a pivot, or a box's corners around the object
    return boundaryEdges > 0 &&
           unreferencedVertices - 3 * (degenerateFaces + duplicateFaces) > strayVertices;
}

std::string RepairReport::text() const {
    std::string text;
    const auto add = [&](const std::string& sentence) {
        text += (text.empty() ? "" : " ") + sentence;
    };
    const auto say = [&](int count, const char* before, const char* one, const char* many) {
        if (count > 0)
            add(before + std::to_string(count) + " " + (count == 1 ? one : many) + ".");
    };
    say(weldedVertices, "Joined ", "point that lay on another", "points that lay on others");
    say(degenerateFaces, "Left out ", "face without an area", "faces without an area");
    say(duplicateFaces, "Left out ", "face that was there twice", "faces that were there twice");
    say(joinedVertices, "Closed the gap at ", "point that lay on an edge",
        "points that lay on edges");
    say(unreferencedVertices, "Left out ", "point without a face", "points without a face");
    say(droppedComponents, "Left out ", "smaller part", "smaller parts");
    say(flippedFaces, "Turned ", "face over that looked the wrong way",
        "faces over that looked the wrong way");
    say(cutVertices,
        "Cut the surface where its parts met only at an edge or a point: ", "added point",
        "added points");
    if (boundaryEdges > maximumOpenEdges)
        add("It has too many open edges to look for gaps between them.");
    say(boundaryEdges, "The surface is open along ", "edge", "edges");
    if (mayBeCutOff())
        add("Many points have no face: the end of the mesh may be missing.");
    say(nonManifoldEdges, "More than two faces meet at ", "edge", "edges");
    say(oneSidedEdges, "The surface has one side only: its faces disagree at ", "edge", "edges");
    say(hollows, "", "closed surface inside another is taken for a hollow",
        "closed surfaces inside others are taken for hollows");
    if (isTangled)
        add("The surface is too tangled to tell which of its parts are hollows.");
    if (components > 1)
        say(components, "It has ", "part", "parts that do not touch");
    return text;
}

Result<RepairedMesh> repairMesh(const Mesh& input, const RepairSettings& settings) {
    if (auto fault = faultOfIndices(input))
        return failure(std::move(*fault));
    const WorkControl control{.progress = {}, .cancelled = settings.cancelled};
    RepairedMesh result{.mesh = input, .report = {}, .vertexOfInput = allVertices(input)};
    auto& [mesh, report, vertexOfInput] = result;
    dropUnusedVertices(result); // they would count for the mesh's size
    if (auto fault = faultOfPlaces(mesh))
        return failure(std::move(*fault));
    const double weldTolerance = std::max(settings.weldTolerance, 1e-12);
    const auto unwelded = mesh.vertexCount();
    renumber(vertexOfInput, weldVertices(mesh, weldTolerance * boundingDiagonalMetres(mesh)));
    report.weldedVertices = static_cast<int>(unwelded - mesh.vertexCount());
    dropUnusable(result);
    joinTJunctions(result, weldTolerance, control);
    if (control.isCancelled())
        return cancellation();
    if (mesh.faceCount() == 0)
        return failure("The mesh has no face with an area.");
    if (settings.largestComponentOnly) {
        report.droppedComponents = keepLargestComponent(mesh);
        dropUnusedVertices(result);
    }
    orientAndCut(mesh, settings, report);
    if (control.isCancelled())
        return cancellation();
    report.components = connectedComponents(mesh).count;
    return result;
}

} // namespace idiophone
