#include "Geometry/SimpleShapes.h"

#include "Geometry/MeshCheck.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <numbers>

using namespace idiophone;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

const ShapeSizes bowl{.heightMetres = 0.06, .radiusMetres = 0.08, .footRadiusMetres = 0.03};

Eigen::RowVector3d sidesOf(const Mesh& mesh) {
    return mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff();
}

} // namespace

TEST_CASE("Every simple shape has about the requested vertex count") {
    for (const auto name : simpleShapeNames()) {
        const auto mesh = simpleShape(name, {.vertexCount = 2500});
        INFO(name);
        REQUIRE(mesh);
        CHECK(mesh->vertexCount() > 1200); // spheres and discs come in few sizes
        CHECK(mesh->vertexCount() < 5000);
    }
}

TEST_CASE("A bowl without a wall is an open surface of its radius, height and foot") {
    const auto mesh = simpleShape("bowl", bowl);
    REQUIRE(mesh);
    const auto sides = sidesOf(*mesh);
    CHECK(sides.x() == Approx(0.16).epsilon(0.01));
    CHECK(sides.z() == Approx(0.06));
    CHECK(checkMesh(*mesh).boundaryEdges >= 24);
    for (const auto& vertex : mesh->vertices.rowwise()) // the foot is flat
        CHECK((vertex.head(2).norm() > 0.0301) == (vertex.z() > 1e-9));
}

TEST_CASE("A bowl with a wall is a closed body of that thickness") {
    auto sizes = bowl;
    sizes.thicknessMetres = 0.004;
    sizes.vertexCount = 6000;
    const auto mesh = simpleShape("bowl", sizes), open = simpleShape("bowl", bowl);
    REQUIRE(mesh);
    REQUIRE(open);
    const auto check = checkMesh(*mesh);
    CHECK(check.isSolid());
    CHECK(sidesOf(*mesh).z() == Approx(0.06));
    CHECK(check.volumeM3 == Approx(0.004 * checkMesh(*open).areaM2).epsilon(0.06));
}

TEST_CASE("Sizes of a shape that contradict each other give an error") {
    const auto fault = [](std::string_view name, const ShapeSizes& sizes) {
        const auto mesh = simpleShape(name, sizes);
        return mesh ? std::string() : mesh.error().message;
    };
    CHECK_THAT(fault("ring", {.radiusMetres = 0.01, .sectionRadiusMetres = 0.02}),
               ContainsSubstring("cross-section must be smaller"));
    CHECK_THAT(fault("bowl", {.radiusMetres = 0.1, .footRadiusMetres = 0.1}),
               ContainsSubstring("foot must be narrower"));
    CHECK_THAT(fault("bowl", {.heightMetres = 0.01, .thicknessMetres = 0.006}),
               ContainsSubstring("wall must be thinner"));
    CHECK_THAT(fault("bar", {.lengthMetres = 100, .widthMetres = 1e-4, .vertexCount = 1000000}),
               ContainsSubstring("vertices"));
    CHECK_THAT(fault("teapot", {}), ContainsSubstring("no such shape"));
}
