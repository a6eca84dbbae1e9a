#include "Geometry/ObjectMesh.h"

#include <cstdint>
#include <igl/per_corner_normals.h>

namespace idiophone {
namespace {

using Coordinates = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Corners = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

} // namespace

Mesh objectMesh(const ModalObject& object) {
    const auto vertexCount = static_cast<Eigen::Index>(object.vertexCount());
    const auto faceCount = static_cast<Eigen::Index>(object.faceCount());
    return {
        .vertices =
            Eigen::Map<const Coordinates>(object.vertices.data(), vertexCount, 3).cast<double>(),
        .faces = Eigen::Map<const Corners>(object.faces.data(), faceCount, 3)};
}

void setMesh(ModalObject& object, const Mesh& mesh) {
    object.vertices.resize(static_cast<std::size_t>(mesh.vertices.size()));
    object.faces.resize(static_cast<std::size_t>(mesh.faces.size()));
    Eigen::Map<Coordinates>(object.vertices.data(), mesh.vertexCount(), 3) =
        mesh.vertices.cast<float>();
    Eigen::Map<Corners>(object.faces.data(), mesh.faceCount(), 3) = mesh.faces;
}

Eigen::MatrixXd cornerNormals(const Mesh& mesh, double creaseDegrees) {
    Eigen::MatrixXd normals;
    igl::per_corner_normals(mesh.vertices, mesh.faces, creaseDegrees, normals);
    for (Eigen::Index corner = 0; corner < normals.rows(); ++corner)
        if (!normals.row(corner).allFinite())
            normals.row(corner).setZero();
    return normals;
}

} // namespace idiophone
