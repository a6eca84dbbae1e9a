#include "Editor/DrawingMesh.h"

#include "Mesh/ObjectMesh.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using Eigen::Vector3d;

constexpr double flatness = 0.02; ///< distance from the box that counts as on it, of its extent

Form formOf(const Mesh& mesh) {
    const Vector3d lowest = mesh.vertices.colwise().minCoeff(),
                   highest = mesh.vertices.colwise().maxCoeff();
    const Vector3d extent = highest - lowest, middle = (lowest + highest) / 2;
    const double width = extent.head<2>().maxCoeff();
    double widest = 0;
    Eigen::Index onBox = 0;
    for (const auto vertex : mesh.vertices.rowwise()) {
        const Vector3d away = (vertex.transpose() - middle).cwiseAbs();
        widest = std::max(widest, away.head<2>().norm());
        onBox += ((extent / 2 - away).array() <= flatness * extent.array() + 1e-6).any();
    }
    constexpr double roundness = 1.03;
    constexpr Eigen::Index fewestAround = 16;
    if (mesh.vertexCount() > fewestAround && widest < roundness * width / 2 &&
        std::abs(extent.x() - extent.y()) < (roundness - 1) * width)
        return Form::turned;
    return onBox == mesh.vertexCount() ? Form::box : Form::free;
}

/// Doubles an open sheet: both sides at half the thickness, joined along its edges. Vertex v
/// becomes v and v + N.
Mesh thickened(const Mesh& sheet, double thicknessMetres) {
    const auto vertices = sheet.vertexCount(), faces = sheet.faceCount();
    const Eigen::MatrixXd out = vertexNormals(sheet) * (thicknessMetres / 2);
    const auto edges = uniqueEdges(sheet);
    std::vector<Eigen::RowVector3i> rim;
    for (const auto face : sheet.faces.rowwise())
        for (int corner = 0; corner < 3; ++corner) {
            const int from = face(corner), to = face((corner + 1) % 3);
            const std::pair ends{std::min(from, to), std::max(from, to)};
            const auto edge = std::ranges::lower_bound(
                edges, ends, {}, [](const MeshEdge& each) { return std::pair(each.a, each.b); });
            if (edge->faceCount > 1)
                continue;
            const int count = static_cast<int>(vertices);
            rim.emplace_back(from + count, to + count, to);
            rim.emplace_back(from + count, to, from);
        }
    Mesh result{Eigen::MatrixXd(2 * vertices, 3),
                Eigen::MatrixXi(2 * faces + static_cast<Eigen::Index>(rim.size()), 3)};
    result.vertices << sheet.vertices + out, sheet.vertices - out;
    result.faces.topRows(faces) = sheet.faces;
    result.faces.middleRows(faces, faces) =
        sheet.faces.rowwise().reverse().array() + static_cast<int>(vertices);
    for (std::size_t i = 0; i < rim.size(); ++i)
        result.faces.row(2 * faces + static_cast<Eigen::Index>(i)) = rim[i];
    return result;
}

/// A point of a face by barycentric coordinates, pulled towards the tangent planes at the corners.
Vector3d bentPlace(const Eigen::Matrix3d& places, // corners as columns
                   const Eigen::Matrix3d& normals,
                   const Vector3d& weights) {
    constexpr double bend = 0.75; // of the paper
    const Vector3d flat = places * weights;
    Vector3d onPlanes = Vector3d::Zero();
    for (int corner = 0; corner < 3; ++corner) {
        const Vector3d normal = normals.col(corner);
        onPlanes += weights(corner) * (flat - normal.dot(flat - places.col(corner)) * normal);
    }
    return (1 - bend) * flat + bend * onPlanes;
}

} // namespace

DrawingMesh drawingMesh(const ModalObject& object, std::size_t maximumFaces) {
    const auto own = objectMesh(object);
    const auto ownVertices = static_cast<std::int32_t>(own.vertexCount());
    const bool isThin = object.body == BodyKind::shell && object.thicknessMetres > 0 &&
                        2 * object.faceCount() <= maximumFaces && !isClosed(uniqueEdges(own));
    const Mesh mesh = isThin ? thickened(own, object.thicknessMetres) : own;
    DrawingMesh result;
    if (mesh.faceCount() == 0)
        return result;
    result.form = formOf(mesh);
    result.isClosed = isThin || isClosed(uniqueEdges(mesh));
    const auto faces = static_cast<double>(mesh.faceCount());
    constexpr double finest = 4;
    const int parts =
        result.form == Form::turned
            ? static_cast<int>(std::clamp(
                  std::floor(std::sqrt(static_cast<double>(maximumFaces) / faces)), 1.0, finest))
            : 1;
    const auto normals = cornerNormals(mesh);
    result.corners.reserve(static_cast<std::size_t>(3 * parts * parts) *
                           static_cast<std::size_t>(mesh.faceCount()));
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        Eigen::Matrix3d places, turned;
        DrawingMesh::Corner base;
        for (int corner = 0; corner < 3; ++corner) {
            const int vertex = mesh.faces(face, corner);
            places.col(corner) = mesh.vertices.row(vertex);
            turned.col(corner) = normals.row(3 * face + corner);
            base.onMesh.vertices[static_cast<std::size_t>(corner)] = vertex % ownVertices;
        }
        const auto add = [&](int second, int third) {
            const Vector3d weights =
                Vector3d(parts - second - third, second, third) / double(parts);
            auto corner = base;
            corner.place = bentPlace(places, turned, weights).cast<float>();
            corner.normal = (turned * weights).normalized().cast<float>();
            Eigen::Map<Eigen::Vector3f>(corner.onMesh.weights.data()) = weights.cast<float>();
            result.corners.push_back(corner);
        };
        for (int i = 0; i < parts; ++i)
            for (int k = 0; i + k < parts; ++k) {
                add(i, k);
                add(i + 1, k);
                add(i, k + 1);
                if (i + k + 1 < parts) {
                    add(i + 1, k);
                    add(i + 1, k + 1);
                    add(i, k + 1);
                }
            }
    }
    return result;
}

DrawingMesh boxMesh(const Eigen::AlignedBox3d& box) {
    Mesh mesh{Eigen::MatrixXd(8, 3), Eigen::MatrixXi{{0, 2, 1},
                                                     {1, 2, 3},
                                                     {4, 5, 6},
                                                     {5, 7, 6},
                                                     {0, 1, 4},
                                                     {1, 5, 4},
                                                     {2, 6, 3},
                                                     {3, 6, 7},
                                                     {0, 4, 2},
                                                     {2, 4, 6},
                                                     {1, 3, 5},
                                                     {3, 7, 5}}};
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.row(corner) =
            box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)).transpose();
    DrawingMesh result{.corners = {}, .form = Form::box, .isClosed = true};
    const auto normals = cornerNormals(mesh);
    for (Eigen::Index corner = 0; corner < 3 * mesh.faceCount(); ++corner)
        result.corners.push_back(
            {.place = mesh.vertices.row(mesh.faces(corner / 3, corner % 3)).cast<float>(),
             .normal = normals.row(corner).cast<float>(),
             .onMesh = {}});
    return result;
}

} // namespace idiophone
