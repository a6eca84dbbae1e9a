#include "Analysis/ModalAnalysis.h"
#include "Geometry/MeshRepair.h"
#include "HostileMeshes.h"
#include "TestMaterials.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

namespace {

bool allFinite(const auto& values) {
    return std::ranges::all_of(values, [](auto value) { return std::isfinite(value); });
}

void checkSentence(const std::string& message) {
    CHECK(message.size() > 10);
    CHECK(message.ends_with("."));
    CHECK(message.find('\n') == std::string::npos);
}

void checkObject(const ModalObject& object, const AnalysisSettings& settings) {
    REQUIRE(object.modeCount() > 0);
    CHECK(allFinite(object.eigenvalues));
    CHECK(allFinite(object.shapes));
    CHECK(allFinite(object.vertices));
    CHECK(object.mass.massKg > 0);
    const double lowestHz = frequenciesHz(Eigen::VectorXd::Constant(1, object.eigenvalues[0]))(0);
    CHECK(lowestHz >= 0.999 * settings.lowestFrequencyHz);
    CHECK(object.bandHz <= settings.maxFrequencyHz);
}

/// Returns true if the analysis gives an object. The automatic method and finite elements are each
/// used twice as often as any other method.
bool makesAnObject(std::uint32_t seed) {
    const auto hostile = hostileMesh(seed);
    CAPTURE(seed, hostile.name);
    AnalysisSettings settings;
    settings.name = "Hostile";
    settings.source = hostile.name;
    settings.material = referenceWood();
    settings.thicknessMetres = seed % 3 == 0 ? 0.05 : 0.002;
    settings.maxFrequencyHz = 400;
    settings.maximumModes = 100;
    settings.elementBudget = 200;
    settings.largestComponentOnly = seed % 5 == 0;
    switch (seed % 6) {
    case 0:
    case 1:
        break;
    case 2:
        settings.method = AnalysisMethod::twoLayer;
        break;
    case 3:
        settings.method = AnalysisMethod::springMass;
        break;
    default:
        settings.method = AnalysisMethod::tetrahedra;
    }
    const auto object = analyse(hostile.mesh, settings);
    if (object)
        checkObject(*object, settings);
    else
        checkSentence(object.error().message);
    return object.has_value();
}

} // namespace

TEST_CASE("Hostile meshes give a valid object or a one-sentence error") {
    int objects = 0;
    for (std::uint32_t seed = 0; seed < 30; ++seed)
        objects += makesAnObject(seed) ? 1 : 0;
    CHECK(objects >= 2);
    CHECK(objects <= 25);
}
