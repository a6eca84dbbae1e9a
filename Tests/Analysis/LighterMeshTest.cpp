#include "Analysis/LighterMesh.h"

#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// A hoop with shapes at every vertex.
ModalObject fineHoop() {
    return analyse(hoopMesh(0.1, 0.06, 48, 8), {.name = "hoop",
                                                .source = "",
                                                .material = referenceWood(),
                                                .method = AnalysisMethod::twoLayer,
                                                .thicknessMetres = 0.004,
                                                .maxFrequencyHz = 1000})
        .value();
}

} // namespace

TEST_CASE("On a lighter mesh the chosen vertices keep their positions and shapes") {
    const auto fine = fineHoop();
    const auto lighter = hoopMesh(0.1, 0.06, 24, 4);
    const auto object = withLighterMesh(fine, lighter, {0, 7, 50});
    REQUIRE(object);
    CHECK(object->eigenvalues == fine.eigenvalues);
    CHECK(object->radiation.weights == fine.radiation.weights);
    REQUIRE(object->vertexCount() == static_cast<std::size_t>(lighter.vertexCount()));
    REQUIRE(object->faceCount() == static_cast<std::size_t>(lighter.faceCount()));
    REQUIRE(object->shapeVertices == std::vector<std::int32_t>{0, 7, 50});
    for (std::size_t row = 0; row < 3; ++row) {
        const auto vertex = static_cast<std::size_t>(object->shapeVertices[row]);
        const auto place = std::span(object->vertices).subspan(3 * vertex, 3);
        std::size_t same = 0;
        while (!std::ranges::equal(std::span(fine.vertices).subspan(3 * same, 3), place))
            ++same;
        CHECK(std::ranges::equal(object->shapesAt(row), fine.shapesAt(same)));
    }
}

TEST_CASE("A mesh that is not lighter, or needs missing shapes, is refused") {
    auto object = fineHoop();
    CHECK_FALSE(withLighterMesh(object, hoopMesh(0.1, 0.06, 96, 16), {0}));
    object.shapeVertices = {5};
    object.shapes.resize(object.modeCount() * 3);
    CHECK_FALSE(withLighterMesh(object, hoopMesh(0.1, 0.06, 24, 4), {0}));
}
