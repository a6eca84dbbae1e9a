#include "Analysis/ShellBody.h"

#include "Analysis/ElementSize.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/LengthUnit.h"
#include "Geometry/Remesh.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr double edgesPerWavelength = 10, minimumEdgesPerWavelength = 4;
/// Area per vertex of equilateral triangles, in squares of their edge: √3/2.
constexpr double areaPerVertex = 0.866;

/// The two layers must not pass through each other where the surface curves.
bool isTooThick(const Mesh& mesh, double thicknessMetres) {
    const Mesh inner{mesh.vertices - layerOffsetMetres(thicknessMetres) * vertexNormals(mesh),
                     mesh.faces};
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        if (doubleAreaVector(mesh, face).dot(doubleAreaVector(inner, face)) <= 0)
            return true;
    return false;
}

/// Returns a warning if a shell is thicker than it is wide, else an empty text. The width is the
/// second of three extents along the principal axes, because flat sheets lack the third.
std::string doubtOfThickness(const Mesh& mesh, double thicknessMetres) {
    constexpr double rounding = 1e-9;
    const Eigen::MatrixXd centred = mesh.vertices.rowwise() - mesh.vertices.colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centred.transpose() * centred);
    const Eigen::MatrixXd turned = centred * axes.eigenvectors();
    Eigen::RowVector3d extents = turned.colwise().maxCoeff() - turned.colwise().minCoeff();
    std::sort(extents.begin(), extents.end());
    if (thicknessMetres <= extents(1) * (1 + rounding))
        return {};
    return "A shell of " + millimetresText(thicknessMetres) +
           " is thicker than its mesh is wide, " + millimetresText(extents(1)) +
           ": check its thickness and the mesh's unit.";
}

/// Remeshes if the triangles do not suit the band. Returns the end of the band that they resolve.
Result<double> fitMesh(Mesh& mesh,
                       std::string& notes,
                       const ShellBodySettings& settings,
                       const WorkControl& control) {
    const ElasticLaw law = elasticLaw(settings.material);
    const double wavelengthMetres = shortestWavelengthMetres(
        law, settings.material.densityKgPerM3, settings.maxFrequencyHz, settings.thicknessMetres);
    const double area = vertexAreas(mesh).sum();
    const double edge = std::min(std::max(wavelengthMetres / edgesPerWavelength,
                                          std::sqrt(area / areaPerVertex / settings.vertexBudget)),
                                 boundingDiagonalMetres(mesh) / 8);
    double given = meanEdgeLengthMetres(mesh);
    if (given < finestEdgeShare * edge || given > coarsestEdgeShare * edge ||
        mesh.vertexCount() > 2 * settings.vertexBudget) {
        if (remeshedTriangles(mesh, edge) >
            maximumNewTriangles + static_cast<double>(mesh.faceCount()))
            return failure("The mesh of " + std::to_string(mesh.vertexCount()) +
                           " vertices needs too many triangles to be covered with those of a "
                           "shell; simplify the mesh, or check its proportions and its unit.");
        auto remeshed = remesh(mesh, edge, control.part(0, 0.1));
        if (!remeshed)
            return tl::unexpected(remeshed.error());
        mesh = std::move(*remeshed);
        given = meanEdgeLengthMetres(mesh);
        notes = "The surface was remeshed to " + std::to_string(mesh.vertexCount()) + " vertices.";
    }
    return servedFrequencyHz(law, settings.material.densityKgPerM3, settings.maxFrequencyHz,
                             settings.thicknessMetres, minimumEdgesPerWavelength * given);
}

} // namespace

Result<BodyModel>
shellBody(const Mesh& surface, const ShellBodySettings& settings, const WorkControl& control) {
    BodyModel body;
    body.servedBandHz = settings.maxFrequencyHz;
    body.surface = surface;
    if (settings.fitsMesh) {
        const auto served = fitMesh(body.surface, body.notes, settings, control);
        if (!served)
            return failure(served.error().message);
        body.servedBandHz = *served;
    }
    const Mesh& mesh = body.surface;
    body.thicknessMetres = settings.thicknessMetres;
    body.material = settings.material;
    body.kind = ModelKind::twoLayers;
    body.model = twoLayerShell(mesh, settings.material, settings.thicknessMetres);
    const Eigen::MatrixXd offsets =
        layerOffsetMetres(settings.thicknessMetres) * vertexNormals(mesh);
    body.pointsMetres.resize(2 * mesh.vertexCount(), 3);
    for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v) {
        body.pointsMetres.row(2 * v) = mesh.vertices.row(v) + offsets.row(v);
        body.pointsMetres.row(2 * v + 1) = mesh.vertices.row(v) - offsets.row(v);
    }
    std::string doubt = doubtOfThickness(surface, settings.thicknessMetres);
    if (doubt.empty() && isTooThick(mesh, settings.thicknessMetres))
        doubt = "The shell is thicker than its curvature allows in places; pitches may be off "
                "there.";
    body.notes = joinedSentences({body.notes, doubt});
    return body;
}

} // namespace idiophone
