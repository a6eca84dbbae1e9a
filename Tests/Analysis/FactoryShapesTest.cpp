// Tests of the stored factory shapes against theory and measured instruments.
#include "Analysis/BarTuning.h"
#include "Analysis/FactoryObjects.h"
#include "StoredObject.h"

#include <Eigen/QR>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

double frequencyHz(const ModalObject& object, std::size_t mode) {
    return std::sqrt(object.eigenvalues[mode]) / (2 * pi);
}

/// Returns the number of waves around the axis at the mouth in this mode; −1 if there is no such
/// wave. The mouth is the object's lowest or highest end.
int wavesAround(const ModalObject& object,
                std::size_t mode,
                double mouthHeightMetres,
                double reachMetres = 0.003) {
    std::vector<double> angles, outward;
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
        const float* at = &object.vertices[3 * static_cast<std::size_t>(object.shapeVertices[row])];
        const double x = static_cast<double>(at[0]), y = static_cast<double>(at[1]);
        if (std::abs(static_cast<double>(at[2]) - mouthHeightMetres) > reachMetres)
            continue;
        const auto shape = object.shapesAt(row).subspan(3 * mode, 3);
        angles.push_back(std::atan2(y, x));
        outward.push_back((static_cast<double>(shape[0]) * x + static_cast<double>(shape[1]) * y) /
                          std::hypot(x, y));
    }
    const auto count = static_cast<Eigen::Index>(angles.size());
    REQUIRE(count >= 10);
    const Eigen::VectorXd found = Eigen::Map<const Eigen::VectorXd>(outward.data(), count);
    for (int waves = 0; waves <= 4; ++waves) {
        Eigen::MatrixXd wave(count, 2);
        for (Eigen::Index k = 0; k < count; ++k)
            wave.row(k) << std::cos(waves * angles[static_cast<std::size_t>(k)]),
                std::sin(waves * angles[static_cast<std::size_t>(k)]);
        const Eigen::VectorXd amplitudes = wave.completeOrthogonalDecomposition().solve(found);
        if ((wave * amplitudes - found).squaredNorm() < 0.05 * found.squaredNorm())
            return waves;
    }
    return -1;
}

/// Checks that modes 2k and 2k + 1 have the same frequency: one mode in two directions.
void checkPairs(const ModalObject& object, std::size_t pairs) {
    for (std::size_t pair = 0; pair < pairs; ++pair)
        CHECK_THAT(frequencyHz(object, 2 * pair + 1),
                   WithinRel(frequencyHz(object, 2 * pair), 2e-4));
}

void checkFile(const ModalObject& object, std::size_t maximumBytes) {
    CHECK(validated(object));
    CHECK(object.provenance.zeroModes == 6);
    CHECK_FALSE(object.provenance.source.empty());
    CHECK((object.shapeVertexCount() >= 40 && object.shapeVertexCount() <= 240));
    CHECK_FALSE(object.radiation.empty());
    CHECK(encodeModalObject(object, ShapePrecision::half).size() <= maximumBytes);
}

/// Checks a free plate of 1.5 to 1, ν = 0.3, against Ritz's method, in units of √(D/ρh)/2πa².
void checkPlate(const ModalObject& object, double lengthMetres, double tolerance) {
    const auto& material = object.material;
    const double nu = material.poissonRatio;
    const double unitHz =
        object.thicknessMetres *
        std::sqrt(material.youngsModulusPa / (12 * (1 - nu * nu) * material.densityKgPerM3)) /
        (2 * pi * lengthMetres * lengthMetres);
    const double theory[] = {20.0955, 21.4133, 46.347, 49.9099, 57.7135, 67.0297};
    for (std::size_t mode = 0; mode < std::size(theory); ++mode)
        CHECK_THAT(frequencyHz(object, mode), WithinRel(theory[mode] * unitHz, tolerance));
}

/// Returns the frequency of (2,0) of a thin cylinder with free ends: that of its section's ring
/// with a stiffness higher by 1/(1 − ν²).
double cylinderHz(const Material& material, double radiusMetres, double thicknessMetres) {
    const double speed = std::sqrt(material.youngsModulusPa / material.densityKgPerM3 /
                                   (1 - material.poissonRatio * material.poissonRatio));
    return 2.68328 / (2 * pi) * thicknessMetres / std::sqrt(12.0) * speed /
           (radiusMetres * radiusMetres);
}

} // namespace

TEST_CASE("The steel plate has Kirchhoff's modes within 1 %") {
    const auto plate = stored("plate");
    checkPlate(plate, 0.30, 0.01);
    checkFile(plate, 330000);
}

TEST_CASE(
    "The wooden table top has Kirchhoff's modes within 2 % (theory for nu = 0.3, wood 0.25)") {
    const auto table = stored("table");
    checkPlate(table, 0.9, 0.02);
    checkFile(table, 220000);
}

TEST_CASE("The lowest pair of the steel ring is Hoppe's ring mode") {
    const auto ring = stored("ring");
    const double speed = std::sqrt(ring.material.youngsModulusPa / ring.material.densityKgPerM3);
    const double hoppeHz = 2.68328 / (2 * pi) * 0.004 / std::sqrt(12.0) * speed / (0.07 * 0.07);
    CHECK_THAT(frequencyHz(ring, 0), WithinRel(hoppeHz, 0.01));
    checkPairs(ring, 2);
    checkFile(ring, 160000);
}

TEST_CASE("The handbell sounds C5 and a twelfth above it, each as a pair of modes") {
    const auto bell = stored("handbell");
    CHECK(std::abs(cents(frequencyHz(bell, 0), 523.2511)) < 3);
    CHECK(std::abs(cents(frequencyHz(bell, 2), 3 * frequencyHz(bell, 0))) < 3);
    CHECK(wavesAround(bell, 0, 0) == 2);
    CHECK(wavesAround(bell, 2, 0) == 3);
    CHECK(wavesAround(bell, 4, 0) == 4);
    checkPairs(bell, 3);
    checkFile(bell, 170000);
}

TEST_CASE("The glass bowl's first five pairs match a wine glass's within 7 %") {
    const auto bowl = stored("glass-bowl");
    // Published ratios of a wine glass. (0,1) lies between the third and fifth pair.
    const double ratios[] = {1, 2.32, 4.25, 6.63, 9.38};
    for (const double ratio : ratios) {
        int near = 0;
        for (std::size_t mode = 0; mode < bowl.modeCount(); ++mode)
            near += std::abs(frequencyHz(bowl, mode) / frequencyHz(bowl, 0) / ratio - 1) < 0.07;
        CHECK(near >= 2);
    }
    CHECK(wavesAround(bowl, 0, 0.073) == 2);
    CHECK(wavesAround(bowl, 2, 0.073) == 3);
    CHECK(wavesAround(bowl, 4, 0.073) == 4);
    checkPairs(bowl, 3);
    checkFile(bowl, 130000);
}

TEST_CASE("The wok's lowest pairs have two, three and four waves around the rim") {
    const auto wok = stored("wok");
    CHECK(wavesAround(wok, 0, 0.1) == 2);
    CHECK(wavesAround(wok, 2, 0.1) == 3);
    CHECK(wavesAround(wok, 4, 0.1) == 4);
    checkPairs(wok, 5);
    CHECK((frequencyHz(wok, 0) > 50 && frequencyHz(wok, 0) < 150));
    checkFile(wok, 260000);
}

TEST_CASE(
    "The shell case's lowest mode lies between cylinders as thick as its mouth and as its wall") {
    const auto shellCase = stored("shell-case");
    CHECK(frequencyHz(shellCase, 0) > cylinderHz(shellCase.material, 0.045, 0.0013));
    CHECK(frequencyHz(shellCase, 0) < cylinderHz(shellCase.material, 0.045, 0.002));
    CHECK(wavesAround(shellCase, 0, 0.292, 0.028) == 2);
    CHECK(wavesAround(shellCase, 2, 0.292, 0.028) == 3);
    checkPairs(shellCase, 4);
    checkFile(shellCase, 450000); // has radiation all around
}

TEST_CASE("A tubular bell's fourth bending mode, a pair, is an octave above its note") {
    const auto bell = stored("tubular-bell-69");
    std::size_t near = 0;
    for (std::size_t mode = 0; mode < bell.modeCount(); ++mode)
        near += std::abs(cents(dampedFrequencyHz(bell.eigenvalues[mode], bell.material), 880)) < 5;
    CHECK(near == 2);
    checkFile(bell, 100000);
}

TEST_CASE("Every shape has a unique name, and unknown names give an error") {
    const auto names = factoryObjectNames();
    CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
    CHECK(std::ranges::count(names, "tubular-bell-60") == 1);
    CHECK(std::ranges::count(names, "tubular-bell-77") == 1);
    const auto refused = makeFactoryObject("tubular-bell-59");
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.find("tubular-bell-59") != std::string::npos);
}

TEST_CASE("A shape's analysis can be cancelled") {
    const std::atomic<bool> cancelled = true;
    for (const auto* name : {"ring", "handbell", "tubular-bell-60"}) {
        const auto object = makeFactoryObject(name, {.progress = {}, .cancelled = &cancelled});
        REQUIRE_FALSE(object);
        CHECK(object.error().message == cancelledMessage);
    }
}
