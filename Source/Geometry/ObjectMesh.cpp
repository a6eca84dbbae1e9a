#include "Geometry/ObjectMesh.h"

#include <cstdint>
#include <igl/per_corner_normals.h>

namespace idiophone {

Mesh objectMesh(const ModalObject& object) {
    using Coordinates = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
    using Corners = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;
    const auto vertexCount = static_cast<Eigen::Index>(object.vertexCount());
    const auto faceCount = static_cast<Eigen::Index>(object.faceCount());
    return {
        .vertices =
            Eigen::Map<const Coordinates>(object.vertices.data(), vertexCount, 3).cast<double>(),
        .faces = Eigen::Map<const Corners>(object.faces.data(), faceCount, 3)};
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
