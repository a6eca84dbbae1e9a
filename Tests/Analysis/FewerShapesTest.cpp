#include "Analysis/FewerShapes.h"

#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"
#include "Object/HalfFloat.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;

namespace {

ModalObject plate() {
    return analyse(sheetMesh(0.2, 0.1, 200), {.name = "plate",
                                              .source = "test",
                                              .material = *findMaterial("Steel"),
                                              .method = AnalysisMethod::twoLayer,
                                              .thicknessMetres = 0.003,
                                              .maxFrequencyHz = 4000})
        .value();
}

} // namespace

TEST_CASE("Fewer shapes are a subset in half precision, spread over the whole surface") {
    const auto whole = plate();
    const auto fewer = withFewerShapes(whole, 30);
    REQUIRE(fewer.shapeVertexCount() == 30);
    CHECK(validated(fewer));
    CHECK(fewer.vertices == whole.vertices);
    CHECK(fewer.eigenvalues == whole.eigenvalues);
    for (std::size_t row = 0; row < 30; ++row) {
        const auto vertex = fewer.shapeVertices[row];
        const auto found = std::ranges::find(whole.shapeVertices, vertex);
        REQUIRE(found != whole.shapeVertices.end());
        const auto before =
            whole.shapesAt(static_cast<std::size_t>(found - whole.shapeVertices.begin()));
        const auto after = fewer.shapesAt(row);
        for (std::size_t i = 0; i < after.size(); ++i)
            CHECK(after[i] == halfToFloat(floatToHalf(before[i])));
    }
    // 30 positions on 0.02 m² are about 26 mm apart.
    for (std::size_t v = 0; v < whole.vertexCount(); ++v) {
        const auto row = nearestShapeRow(
            fewer, {whole.vertices[3 * v], whole.vertices[3 * v + 1], whole.vertices[3 * v + 2]});
        const auto* p = &fewer.vertices[static_cast<std::size_t>(fewer.shapeVertices[row]) * 3];
        CHECK(std::hypot(p[0] - whole.vertices[3 * v], p[1] - whole.vertices[3 * v + 1]) < 0.03f);
    }
}

TEST_CASE("All shapes are kept if they are few enough, and rounding twice equals rounding once") {
    const auto whole = plate();
    const auto rounded = withFewerShapes(whole, 100000);
    CHECK(rounded.shapeVertices == whole.shapeVertices);
    CHECK(withFewerShapes(rounded, 100000).shapes == rounded.shapes);
    CHECK(withFewerShapes(whole, 1).shapeVertexCount() == 1);
}
