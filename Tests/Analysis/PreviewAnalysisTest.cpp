// Tests of previews: playable until the full analysis is done, with few elements for any mesh.
#include "Analysis/ModalAnalysis.h"

#include "Geometry/ParametricMesh.h"
#include "Support/GeneratedMeshes.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

AnalysisSettings settings(std::optional<AnalysisMethod> method = {}) {
    return {.name = "thing",
            .source = "thing.obj",
            .material = *findMaterial("Steel"),
            .method = method,
            .thicknessMetres = 0.003};
}

double hertz(const ModalObject& object, std::size_t mode) {
    return std::sqrt(object.eigenvalues[mode]) / (2 * std::numbers::pi);
}

} // namespace

TEST_CASE("A preview's lowest modes are within 3 % of the full analysis", "[.weekly]") {
    for (const Mesh& mesh : {sheetMesh(0.3, 0.2, 2000), hoopMesh(0.1, 0.03, 120, 8),
                             extrudedMesh(sheetMesh(0.3, 0.04, 600), 0.02, 4)}) {
        const auto preview = analysePreview(mesh, settings());
        auto bounded = settings();
        bounded.maxFrequencyHz = 6000;
        const auto whole = analyse(mesh, bounded);
        REQUIRE(preview);
        REQUIRE(whole);
        CHECK(preview->method == whole->method);
        for (std::size_t mode = 0; mode < 4; ++mode) {
            INFO(hertz(*preview, mode) << " Hz for " << hertz(*whole, mode));
            CHECK(std::abs(hertz(*preview, mode) / hertz(*whole, mode) - 1) < 0.03);
        }
    }
}

TEST_CASE("A preview reaches as high as the whole analysis, with about as many modes") {
    for (const Mesh& mesh :
         {hoopMesh(0.05, 0.03, 100, 12), extrudedMesh(sheetMesh(0.15, 0.03, 600), 0.02, 4)}) {
        auto bounded = settings();
        bounded.maxFrequencyHz = 30000;
        const auto preview = analysePreview(mesh, bounded);
        const auto whole = analyse(mesh, bounded);
        REQUIRE(preview);
        REQUIRE(whole);
        CHECK(preview->bandHz == whole->bandHz);
        const auto share = static_cast<double>(preview->modeCount()) / double(whole->modeCount());
        INFO(preview->modeCount() << " modes for " << whole->modeCount());
        CHECK(share > 0.7);
        CHECK(share < 1.3);
    }
}

TEST_CASE("A preview with too many modes for the whole band ends where it has enough") {
    const auto preview = analysePreview(sheetMesh(1, 1, 4000), settings());
    REQUIRE(preview);
    CHECK(preview->bandHz < highestAnalysedHz);
    CHECK(preview->modeCount() > 250);
}

TEST_CASE("A preview of 20,000 triangles has few vertices and few elements") {
    const Mesh fine[] = {icosphereMesh(0.1, 5), sheetMesh(0.4, 0.3, 10000),
                         sheetMesh(0.4, 0.05, 10000), torusMesh(0.1, 0.01, 426, 20)};
    for (const auto& mesh : fine) {
        const auto preview = analysePreview(mesh, settings());
        REQUIRE(preview);
        CHECK(preview->vertexCount() <= 2 * previewVertices);
        CHECK(preview->shapeVertexCount() == preview->vertexCount());
        CHECK(preview->modeCount() < 400);
        CHECK_THAT(preview->provenance.notes, ContainsSubstring("preview"));
    }
}

TEST_CASE("A preview uses the requested method, and two layers for all spring methods") {
    const Mesh ball = icosphereMesh(0.1, 2);
    const auto methodOf = [&](AnalysisMethod method) {
        const auto preview = analysePreview(ball, settings(method));
        return preview ? preview->method : preview.error().message;
    };
    CHECK(methodOf(AnalysisMethod::tetrahedra) == "fem");
    CHECK(methodOf(AnalysisMethod::twoLayer) == "two-layer");
    CHECK(methodOf(AnalysisMethod::springMass) == "two-layer");
    CHECK(methodOf(AnalysisMethod::vanGelder) == "two-layer");
    const auto open =
        analysePreview(sheetMesh(0.1, 0.1, 100), settings(AnalysisMethod::tetrahedra));
    CHECK_FALSE(open);
}

TEST_CASE("A cancelled preview or an empty mesh gives a one-sentence error") {
    const std::atomic<bool> cancelled{true};
    const auto stopped = analysePreview(icosphereMesh(0.1, 4), settings(),
                                        {.progress = {}, .cancelled = &cancelled});
    REQUIRE_FALSE(stopped);
    CHECK(stopped.error().message == cancelledMessage);
    CHECK_FALSE(analysePreview(Mesh{}, settings()));
    auto steel = settings();
    steel.material.densityKgPerM3 = 0;
    CHECK_FALSE(analysePreview(icosphereMesh(0.1, 1), steel));
    auto endless = settings();
    endless.maxFrequencyHz = std::nan("");
    const auto refused = analysePreview(icosphereMesh(0.1, 1), endless);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.starts_with("The band of the analysis"));
}
