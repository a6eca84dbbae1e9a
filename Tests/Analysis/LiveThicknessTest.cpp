// Compares shells of live thickness with a new analysis at that thickness.
#include "Analysis/ModalAnalysis.h"
#include "Geometry/LatheMesh.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

ModalObject shell(const Mesh& mesh, double thicknessMetres, double maxFrequencyHz) {
    auto object = analyse(mesh, {.name = "shell",
                                 .source = "test",
                                 .material = referenceWood(0.3),
                                 .method = AnalysisMethod::twoLayer,
                                 .thicknessMetres = thicknessMetres,
                                 .maxFrequencyHz = maxFrequencyHz});
    REQUIRE(object);
    return std::move(*object);
}

/// Returns the largest error of the lowest modes at this thickness ratio, in cents.
double errorCents(const Mesh& mesh, double thicknessMetres, double maxHz, double ratio, int modes) {
    const auto own = shell(mesh, thicknessMetres, maxHz);
    const auto anew = shell(mesh, ratio * thicknessMetres, 1.2 * maxHz * std::max(1.0, ratio));
    REQUIRE(own.hasLiveThickness());
    std::vector<double> live;
    for (std::size_t mode = 0; mode < own.modeCount(); ++mode)
        live.push_back(own.eigenvalueAt(mode, ratio));
    std::ranges::sort(live);
    double worst = 0;
    for (std::size_t mode = 0; mode < static_cast<std::size_t>(modes); ++mode)
        worst =
            std::max(worst, std::abs(600 * std::log2(live.at(mode) / anew.eigenvalues.at(mode))));
    return worst;
}

/// A hemispherical bowl of 0.1 m radius.
Mesh bowl() {
    std::vector<LathePoint> section;
    for (int k = 0; k <= 24; ++k) {
        const double angle = 1.5707963267948966 * k / 24;
        section.push_back({.radiusMetres = 0.1 * std::sin(angle),
                           .heightMetres = -0.1 * std::cos(angle),
                           .thicknessMetres = 0.002});
    }
    section.front().radiusMetres = 0;
    return latheMesh(section, 0.012).mesh;
}

} // namespace

TEST_CASE("A plate's ten lowest modes are within 20 cents at half to twice its thickness") {
    for (const double ratio : {0.5, 0.8, 1.25, 2.0})
        CHECK(errorCents(sheetMesh(0.3, 0.2, 400), 0.003, 3000, ratio, 10) < 20);
}

TEST_CASE("A hoop's ten lowest modes are within 80 cents at half and twice its thickness, and "
          "within 25 in between") {
    for (const double ratio : {0.5, 0.8, 1.25, 2.0})
        CHECK(errorCents(hoopMesh(0.1, 0.03, 90, 4), 0.002, 2500, ratio, 10) <
              (ratio == 0.5 || ratio == 2 ? 80 : 25));
}

TEST_CASE("A bowl's ten lowest modes are within 50 cents at 3/4 to 4/3 of its thickness") {
    for (const double ratio : {0.75, 1.3333})
        CHECK(errorCents(bowl(), 0.002, 6000, ratio, 10) < 50);
}
