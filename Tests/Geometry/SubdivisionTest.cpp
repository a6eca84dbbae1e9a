#include "Geometry/Subdivision.h"
#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("Each subdivision divides a face into four and makes a coarse sphere rounder") {
    const Mesh coarse = icosphereMesh(1, 1);
    const Mesh fine = subdivided(coarse, 2);
    CHECK(fine.faceCount() == 16 * coarse.faceCount());
    const auto roughness = [](const Mesh& mesh) { // spread of the faces' distances
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

TEST_CASE("Subdivision drops vertices without a face") {
    Mesh mesh = icosphereMesh(1, 1);
    const Mesh whole = subdivided(mesh, 1);
    mesh.vertices.conservativeResize(mesh.vertexCount() + 5, 3);
    mesh.vertices.bottomRows(5).setConstant(7);
    CHECK(subdivided(mesh, 1).vertices == whole.vertices);
}

TEST_CASE("Meshes with inconsistent faces or a repeated corner stay unchanged") {
    constexpr int around = 40;
    Eigen::MatrixXi strip(2 * around, 3); // a Möbius strip on vertices i and around + i
    for (int i = 0; i < around; ++i) {
        const int next = (i + 1) % around;
        const int near = next == 0 ? around : next, far = next == 0 ? 0 : around + next;
        strip.row(2 * i) << i, near, around + i;
        strip.row(2 * i + 1) << near, far, around + i;
    }
    for (const Eigen::MatrixXi& faces :
         {Eigen::MatrixXi{{0, 1, 2}, {1, 2, 3}}, strip, Eigen::MatrixXi{{0, 1, 2}, {2, 1, 1}}}) {
        const Mesh mesh{Eigen::MatrixXd::Random(2 * around, 3), faces};
        CHECK(subdivided(mesh, 2).faces == mesh.faces);
    }
}

TEST_CASE("Fans with a common vertex are subdivided like other faces") {
    const Mesh mesh{
        Eigen::MatrixXd::Random(9, 3),
        Eigen::MatrixXi{{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 6, 7}, {0, 7, 8}, {0, 8, 6}}};
    const auto fine = subdivided(mesh, 2);
    CHECK(fine.faceCount() == 16 * mesh.faceCount());
    CHECK(fine.vertices.allFinite());
}

TEST_CASE("Meshes with three faces at an edge stay unchanged") {
    const Mesh mesh{.vertices = Eigen::MatrixXd::Random(5, 3),
                    .faces = (Eigen::MatrixXi(3, 3) << 0, 1, 2, 1, 0, 3, 0, 1, 4).finished()};
    CHECK(subdivided(mesh, 3).faces == mesh.faces);
}
