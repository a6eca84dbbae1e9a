#include "Geometry/Subdivision.h"
#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("Each subdivision makes four faces of one, and a coarse sphere rounder") {
    const Mesh coarse = icosphereMesh(1, 1);
    const Mesh fine = subdivided(coarse, 2);
    CHECK(fine.faceCount() == 16 * coarse.faceCount());
    const auto roughness = [](const Mesh& mesh) { // the spread of the faces' distances
        const Eigen::MatrixXd& v = mesh.vertices;
        Eigen::VectorXd distance(mesh.faceCount());
        for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
            distance[face] = (v.row(mesh.faces(face, 0)) + v.row(mesh.faces(face, 1)) +
                              v.row(mesh.faces(face, 2)))
                                 .norm() /
                             3;
        return (v.rowwise().norm().maxCoeff() - distance.minCoeff()) / distance.mean();
    };
    CHECK(roughness(fine) < roughness(coarse) / 3);
}

TEST_CASE("Vertices without a face are left out of what is subdivided") {
    Mesh mesh = icosphereMesh(1, 1);
    const Mesh whole = subdivided(mesh, 1);
    mesh.vertices.conservativeResize(mesh.vertexCount() + 5, 3);
    mesh.vertices.bottomRows(5).setConstant(7);
    CHECK(subdivided(mesh, 1).vertices == whole.vertices);
}

TEST_CASE("Faces that meet three in an edge stay as they are") {
    const Mesh mesh{.vertices = Eigen::MatrixXd::Random(5, 3),
                    .faces = (Eigen::MatrixXi(3, 3) << 0, 1, 2, 1, 0, 3, 0, 1, 4).finished()};
    CHECK(subdivided(mesh, 3).faces == mesh.faces);
}
