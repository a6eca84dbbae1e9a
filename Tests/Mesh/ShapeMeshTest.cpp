#include "Mesh/ShapeMesh.h"

#include "Geometry/ParametricMesh.h"
#include "Mesh/SurfaceQuery.h"
#include "Support/SyntheticObject.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace idiophone;
using Catch::Approx;

namespace {

/// Returns an object with shapes at the vertices that `isChosen` accepts.
template <class Choice>
ModalObject objectOf(const Mesh& mesh, Choice isChosen) {
    auto object = test::syntheticObject({100});
    object.vertices.clear();
    object.faces.clear();
    object.shapeVertices.clear();
    for (Eigen::Index vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        for (int axis = 0; axis < 3; ++axis)
            object.vertices.push_back(static_cast<float>(mesh.vertices(vertex, axis)));
        if (isChosen(vertex))
            object.shapeVertices.push_back(static_cast<std::int32_t>(vertex));
    }
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner)
            object.faces.push_back(mesh.faces(face, corner));
    object.shapes.assign(3 * object.shapeVertices.size(), 1);
    return object;
}

double area(const Mesh& mesh) {
    return faceAreas(mesh).sum();
}

bool isPoint(const Mesh& mesh, Eigen::Index face) {
    return mesh.faces(face, 0) == mesh.faces(face, 1) && mesh.faces(face, 1) == mesh.faces(face, 2);
}

} // namespace

TEST_CASE("If every vertex has shapes, the shape mesh is the object's own mesh") {
    const auto mesh = torusMesh(1, 0.4, 24, 10);
    const auto shapes = shapeMesh(objectOf(mesh, [](auto) { return true; }));
    REQUIRE(shapes.vertexCount() == mesh.vertexCount());
    CHECK((shapes.vertices - mesh.vertices).cwiseAbs().maxCoeff() < 1e-6);
    const auto sorted = [](const Mesh& of) {
        std::vector<std::array<int, 3>> faces;
        for (Eigen::Index face = 0; face < of.faceCount(); ++face) {
            std::array corners{of.faces(face, 0), of.faces(face, 1), of.faces(face, 2)};
            std::ranges::rotate(corners, std::ranges::min_element(corners));
            faces.push_back(corners);
        }
        std::ranges::sort(faces);
        return faces;
    };
    CHECK(sorted(shapes) == sorted(mesh));
}

TEST_CASE("Scattered shapes on a sheet are connected all over it, with no face turned over") {
    const auto mesh = sheetMesh(0.3, 0.2, 2000);
    const unsigned every = GENERATE(2u, 5u, 20u);
    std::mt19937 random(every);
    const double left = mesh.vertices.col(0).minCoeff(), below = mesh.vertices.col(1).minCoeff();
    const auto isOnEdge = [&](Eigen::Index vertex) {
        return std::abs(std::abs(mesh.vertices(vertex, 0)) + left) < 1e-9 ||
               std::abs(std::abs(mesh.vertices(vertex, 1)) + below) < 1e-9;
    };
    const auto shapes = shapeMesh(
        objectOf(mesh, [&](auto vertex) { return random() % every == 0 || isOnEdge(vertex); }));
    INFO("one of " << every << ": " << shapes.faceCount() << " faces");
    CHECK(area(shapes) == Approx(area(mesh)).epsilon(0.01));
    double upward = 0;
    for (Eigen::Index face = 0; face < shapes.faceCount(); ++face) {
        const Eigen::Vector3d a = shapes.vertices.row(shapes.faces(face, 0));
        const Eigen::Vector3d b = shapes.vertices.row(shapes.faces(face, 1));
        const Eigen::Vector3d c = shapes.vertices.row(shapes.faces(face, 2));
        upward += Eigen::Vector3d(b - a).cross(Eigen::Vector3d(c - a)).z() / 2;
    }
    CHECK(upward == Approx(area(shapes)).epsilon(1e-3));
}

TEST_CASE("Shapes on one side of a solid leave its other side open") {
    const auto mesh = icosphereMesh(1, 4);
    const auto isUp = [&](Eigen::Index vertex) { return mesh.vertices(vertex, 2) > 0.5; };
    const auto shapes = shapeMesh(objectOf(mesh, isUp));
    CHECK(area(shapes) > 0.9 * std::numbers::pi);
    CHECK(area(shapes) < 1.1 * std::numbers::pi); // area of a cap of height 0.5
    const auto below = SurfaceQuery(shapes).nearestPoint({0.1, 0, -2});
    CHECK(below.pointMetres.z() == Approx(0.5).margin(0.1));
}

TEST_CASE("The underside of a bar adds no faces against the shapes on its top") {
    const Eigen::Vector3d size(0.35, 0.035, 0.018);
    const auto mesh = boxMesh(size, {16, 2, 1});
    const double top = mesh.vertices.col(2).maxCoeff();
    const auto shapes = shapeMesh(
        objectOf(mesh, [&](Eigen::Index vertex) { return mesh.vertices(vertex, 2) == top; }));
    REQUIRE(shapes.vertexCount() == 51);
    CHECK(area(shapes) == Approx(size.x() * size.y()));
    const SurfaceQuery query(shapes);
    for (double x = -0.17; x < 0.17; x += 0.0037) {
        const auto found = query.nearestPoint({x, 0, top + 1e-6});
        for (int corner = 0; corner < 3; ++corner)
            if (found.barycentric(corner) > 1e-4) {
                INFO(x);
                CHECK(std::abs(shapes.vertices(shapes.faces(found.face, corner), 1)) < 1e-9);
            }
    }
}

TEST_CASE("Vertices without a common face are found as points") {
    const auto mesh = sheetMesh(1, 0.2, 400);
    const std::array lone{0, static_cast<int>(mesh.vertexCount()) - 1};
    const auto shapes = shapeMesh(
        objectOf(mesh, [&](Eigen::Index vertex) { return std::ranges::count(lone, vertex) > 0; }));
    REQUIRE(shapes.faceCount() == 2);
    CHECK(isPoint(shapes, 0));
    CHECK(isPoint(shapes, 1));
    const SurfaceQuery query(shapes);
    for (const int row : {0, 1}) {
        const Eigen::Vector3d vertex = shapes.vertices.row(row);
        const auto found = query.nearestPoint(vertex * 1.1);
        CHECK(shapes.faces(found.face, 0) == row);
        CHECK((found.pointMetres - vertex).norm() < 1e-12);
        CHECK(found.barycentric.sum() == Approx(1));
    }
}

TEST_CASE("An object without faces can be struck at its vertices") {
    auto object = test::syntheticObject({100});
    object.faces.clear();
    const auto shapes = shapeMesh(object);
    CHECK(shapes.faceCount() == 4);
    CHECK(SurfaceQuery(shapes).nearestPoint({0.9, 0.2, 0}).pointMetres.x() == Approx(1));
}

TEST_CASE("A mesh of 100,000 faces keeps its surface whichever vertices have shapes") {
    const auto mesh = torusMesh(1, 0.3, 500, 100);
    REQUIRE(mesh.faceCount() == 100000);
    const Eigen::Index every = GENERATE(1, 7);
    const auto object = objectOf(mesh, [every](Eigen::Index v) { return v % every == 0; });
    const SurfaceQuery query(shapeMesh(object));
    CHECK(area(query.mesh()) > 0.8 * area(mesh));
}
