#include "Analysis/SlitShell.h"

#include "Analysis/LighterMesh.h"
#include "Analysis/SolidShell.h"
#include "Mesh/ObjectMesh.h"

#include <utility>
#include <vector>

namespace idiophone {
namespace {

Eigen::RowVector3d middleOf(const Mesh& mesh, Eigen::Index face) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int vertex : mesh.faces.row(face))
        sum += mesh.vertices.row(vertex);
    return sum / 3;
}

/// One side of a wall whose faces look outward, offset from the middle by a share of the thickness.
Mesh sideOf(const LatheMesh& wall, const Mesh& open, double share) {
    return {open.vertices + share * wall.thicknessMetres.asDiagonal() * vertexNormals(open),
            wall.mesh.faces};
}

/// [3N×M] the shapes of vertices `first` to `first` + `count` − 1 of an object that stores all.
Eigen::MatrixXd shapesOf(const ModalObject& object, Eigen::Index first, Eigen::Index count) {
    const auto modes = static_cast<Eigen::Index>(object.modeCount());
    Eigen::MatrixXd shapes(3 * count, modes);
    for (Eigen::Index v = 0; v < count; ++v) {
        const auto row = object.shapesAt(static_cast<std::size_t>(first + v));
        for (Eigen::Index mode = 0; mode < modes; ++mode)
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                shapes(3 * v + axis, mode) =
                    static_cast<double>(row[static_cast<std::size_t>(3 * mode + axis)]);
    }
    return shapes;
}

/// [M] the volume that each shape takes from the inside of a closed surface.
std::vector<double> inwardM3(const Mesh& inside, const Eigen::MatrixXd& shapes) {
    Eigen::RowVectorXd outward = Eigen::RowVectorXd::Zero(shapes.cols());
    for (Eigen::Index face = 0; face < inside.faceCount(); ++face) {
        const Eigen::RowVector3d sixthOfArea = doubleAreaVector(inside, face) / 6;
        for (const int vertex : inside.faces.row(face))
            outward += sixthOfArea * shapes.middleRows<3>(3 * Eigen::Index{vertex});
    }
    const Eigen::RowVectorXd inward = -outward;
    return {inward.begin(), inward.end()};
}

} // namespace

SlitShell slitShell(const LatheMesh& closed,
                    const std::function<bool(const Eigen::RowVector3d& middleMetres)>& isSlit) {
    SlitShell shell;
    shell.closed = closed;
    shell.open = {closed.mesh.vertices, Eigen::MatrixXi(closed.mesh.faceCount(), 3)};
    Eigen::Index kept = 0;
    Eigen::AlignedBox3d mouth;
    double thickness = 0;
    int corners = 0;
    for (Eigen::Index face = 0; face < closed.mesh.faceCount(); ++face) {
        if (!isSlit(middleOf(closed.mesh, face))) {
            shell.open.faces.row(kept++) = closed.mesh.faces.row(face);
            continue;
        }
        shell.cavity.mouthM2 += doubleAreaVector(closed.mesh, face).norm() / 2;
        for (const int vertex : closed.mesh.faces.row(face)) {
            mouth.extend(closed.mesh.vertices.row(vertex).transpose());
            thickness += closed.thicknessMetres(vertex);
            ++corners;
        }
    }
    shell.open.faces.conservativeResize(kept, 3);
    shell.cavity.volumeM3 = signedVolumeM3(sideOf(closed, shell.open, -0.5));
    shell.cavity.mouthLengthMetres = mouth.sizes().maxCoeff();
    shell.cavity.wallMetres = thickness / corners;
    shell.mouthMetres = mouth.center();
    return shell;
}

Result<ModalObject> solveSlitShell(const SlitShell& shell,
                                   const Material& material,
                                   const SolveSettings& settings,
                                   const WorkControl& control) {
    SolveSettings walls = settings;
    walls.shapeVertices = {};
    walls.listeningDirections = {};
    const auto body = solidShell(shell.open, shell.closed.thicknessMetres, material);
    auto object = solveBody(body, walls, control.part(0, 0.4));
    if (!object)
        return object;
    const Eigen::Index count = shell.open.vertexCount();
    const Mesh outside = sideOf(shell.closed, shell.open, 0.5);
    const Eigen::Vector3d centre(object->mass.centreMetres.data());
    auto radiation =
        radiationOf({.mesh = outside,
                     .shapes = shapesOf(*object, 0, count),
                     .eigenvalues = Eigen::Map<const Eigen::VectorXd>(
                         object->eigenvalues.data(), std::ssize(object->eigenvalues)),
                     .centreMetres = centre},
                    {.directions = settings.listeningDirections, .method = settings.radiation},
                    control.part(0.4, 1));
    if (!radiation)
        return tl::unexpected(radiation.error());
    object->radiation = std::move(radiation->table);
    const auto inward =
        inwardM3(sideOf(shell.closed, shell.open, -0.5), shapesOf(*object, count, count));
    auto light = withLighterMesh(*object, body.surface, settings.shapeVertices);
    if (!light)
        return light;
    const Eigen::Vector3d mouth = shell.mouthMetres - centre;
    addCavity(*light, shell.cavity, inward, {mouth.x(), mouth.y(), mouth.z()});
    return validated(std::move(*light));
}

} // namespace idiophone
