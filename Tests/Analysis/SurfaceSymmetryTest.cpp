#include "Analysis/SurfaceSymmetry.h"

#include "Geometry/LatheMesh.h"
#include "Geometry/ParametricMesh.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <set>

using namespace idiophone;

TEST_CASE("The symmetry of generated meshes is found") {
    CHECK(surfaceSymmetry(sheetMesh(0.3, 0.2, 200)).order() == 8); // mirrored in its plane too
    CHECK(surfaceSymmetry(hoopMesh(0.1, 0.05, 24, 2)).order() == 48);
    const auto cup = latheMesh({{0.05, 0, 0.002}, {0.08, 0.1, 0.002}}, 0.01);
    CHECK(surfaceSymmetry(cup.mesh).order() >= 12);
}

TEST_CASE("A mesh with one vertex out of place has no symmetry") {
    Mesh mesh = sheetMesh(0.3, 0.2, 200);
    mesh.vertices.row(3) += Eigen::RowVector3d(1e-3, 2e-3, 3e-3);
    CHECK(surfaceSymmetry(mesh).order() == 1);
}

TEST_CASE("A mesh keeps its symmetry when shifted and scaled") {
    Mesh mesh = hoopMesh(0.1, 0.05, 24, 2);
    mesh.vertices = 37 * mesh.vertices;
    mesh.vertices.rowwise() += Eigen::RowVector3d(1, -2, 3);
    CHECK(surfaceSymmetry(mesh).order() == 48);
}

TEST_CASE("Characters are orthogonal and multiply like the elements") {
    const Mesh mesh = hoopMesh(0.1, 0.05, 12, 2);
    const auto symmetry = surfaceSymmetry(mesh);
    const auto order = symmetry.order();
    const Eigen::MatrixXcd products = symmetry.characters * symmetry.characters.adjoint();
    CHECK(
        (products - static_cast<double>(order) * Eigen::MatrixXcd::Identity(order, order)).norm() <
        1e-9);
    for (std::size_t a = 0; a < symmetry.images.size(); ++a)
        for (std::size_t b = 0; b < symmetry.images.size(); ++b) {
            std::vector<int> both;
            for (const int face : symmetry.images[a])
                both.push_back(symmetry.images[b][static_cast<std::size_t>(face)]);
            const auto found = std::ranges::find(symmetry.images, both);
            REQUIRE(found != symmetry.images.end());
            const auto product = found - symmetry.images.begin();
            for (Eigen::Index character = 0; character < order; ++character)
                CHECK(std::abs(symmetry.characters(character, static_cast<Eigen::Index>(a)) *
                                   symmetry.characters(character, static_cast<Eigen::Index>(b)) -
                               symmetry.characters(character, product)) < 1e-9);
        }
}

TEST_CASE("Orbits contain every face once, with the element that leads to it") {
    const Mesh mesh = icosphereMesh(1, 1);
    const auto symmetry = surfaceSymmetry(mesh);
    const auto orbits = orbitsOf(symmetry, mesh);
    REQUIRE(symmetry.order() > 1);
    for (std::size_t face = 0; face < orbits.orbits.size(); ++face) {
        const auto first =
            static_cast<std::size_t>(orbits.firsts[static_cast<std::size_t>(orbits.orbits[face])]);
        CHECK(symmetry.images[static_cast<std::size_t>(orbits.elements[face])][first] ==
              static_cast<int>(face));
    }
    CHECK(std::set<int>(orbits.firsts.begin(), orbits.firsts.end()).size() == orbits.firsts.size());
}
