#include "Synth/StrikePoints.h"

#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("A strike point is the nearest vertex with shapes, with its outward normal") {
    auto object = test::syntheticObject({440});
    object.vertices = {0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1}; // upright, facing -y
    object.shapeVertices = {1, 3};
    object.shapes.resize(6);
    const StrikePoints points(std::make_shared<const ModalObject>(object));
    const auto low = points.nearest({0.7, 0, 0.2}), high = points.nearest({0.2, 0, 0.7});
    CHECK(low.shapeRows[0] == 0);
    CHECK(high.shapeRows[0] == 1);
    for (const auto& point : {low, high}) {
        CHECK(point.normal == std::array<float, 3>{0, -1, 0});
        CHECK(point.weights[0] == 1);
        CHECK(point.weights[1] == 0);
    }
}
