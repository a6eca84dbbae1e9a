#include "Analysis/MeasuredObject.h"
#include "Geometry/ParametricMesh.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

const RecordingFit threeStrikes{
    .modes = {{.frequencyHz = 200, .decayPerSecond = 4, .amplitudes = {0.4, 0.1, 0.0}},
              {.frequencyHz = 530, .decayPerSecond = 9, .amplitudes = {0.2, 0.3, 0.1}}},
    .modesFound = 2,
    .remarks = {},
    .noiseDecibels = {-60, -60, -60}};

ModalObject built(std::span<const StruckPlace> places, MeasuredObjectSettings settings = {}) {
    settings.name = "measured";
    auto object = measuredObject(threeStrikes, places, settings);
    REQUIRE(object);
    return *object;
}

/// Returns (φ · n)² at the vertex nearest to a point: the gain of a strike there.
double gain(const ModalObject& object, std::size_t mode, const std::array<double, 3>& point) {
    const auto row = nearestShapeRow(object, point);
    const auto normals = vertexNormals(object);
    double along = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        along += static_cast<double>(object.shapesAt(row)[3 * mode + axis]) *
                 static_cast<double>(
                     normals[static_cast<std::size_t>(object.shapeVertices[row]) * 3 + axis]);
    return along * along;
}

void checkGains(const ModalObject& object,
                const std::vector<std::array<double, 3>>& points,
                std::size_t mode) {
    const auto& amplitudes = threeStrikes.modes[mode].amplitudes;
    const double unit = gain(object, 1, points[1]) / 0.3;
    for (std::size_t r = 0; r < points.size(); ++r) {
        CAPTURE(mode, r);
        CHECK(gain(object, mode, points[r]) ==
              Approx(unit * amplitudes[r]).epsilon(1e-4).margin(1e-6));
    }
}

} // namespace

TEST_CASE("A measured object has the measured frequencies and decay rates") {
    const auto object = built(std::vector<StruckPlace>{0.0, 0.05, 0.1});
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& mode = threeStrikes.modes[i];
        const double decay = object.decayPerSecond(i);
        CHECK(decay == Approx(mode.decayPerSecond).epsilon(1e-12));
        CHECK(std::sqrt(object.eigenvalues[i] - decay * decay) / (2 * std::numbers::pi) ==
              Approx(mode.frequencyHz).epsilon(1e-12));
    }
    CHECK(object.method == "measured");
}

TEST_CASE("A measured object has the recorded gains at the recorded strike positions") {
    const std::vector<std::array<double, 3>> line{{-0.1, 0, 0}, {0, 0, 0}, {0.1, 0, 0}};
    const std::vector<std::array<double, 3>> triangle{{0, 0, 0}, {0.2, 0, 0.01}, {0.1, 0.1, 0}};
    for (const auto& points : {line, triangle}) {
        const auto object = built(std::vector<StruckPlace>(points.begin(), points.end()));
        for (std::size_t mode = 0; mode < 2; ++mode)
            checkGains(object, points, mode);
    }
    const auto disc = built(std::vector<StruckPlace>{0.02, 0.05, 0.1});
    for (const double angle : {0.0, 2.0, 4.5}) {
        std::vector<std::array<double, 3>> around;
        for (const double radius : {0.02, 0.05, 0.1})
            around.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
        for (std::size_t mode = 0; mode < 2; ++mode)
            checkGains(disc, around, mode);
    }
}

TEST_CASE("On a mesh, gains by radius are linear between the radii and constant beyond") {
    MeasuredObjectSettings settings;
    settings.mesh = discOfRadii(std::vector<double>{0.01, 0.03, 0.05, 0.075, 0.1, 0.2}).mesh;
    const auto object = built(std::vector<StruckPlace>{0.02, 0.05, 0.1}, settings);
    const double unit = gain(object, 0, {0.05, 0, 0}) / 0.1;
    CHECK(gain(object, 0, {0.01, 0, 0}) == Approx(unit * 0.4).epsilon(1e-4));
    CHECK(gain(object, 0, {0.03, 0, 0}) == Approx(unit * 0.3).epsilon(1e-4));
    CHECK(gain(object, 0, {0, 0.075, 0}) == Approx(unit * 0.05).epsilon(1e-4));
    CHECK(gain(object, 0, {0, 0.2, 0}) < 1e-6 * unit);
}

TEST_CASE("Strikes at one position count by the mean of their energies") {
    const std::array<double, 3> a{0, 0, 0}, b{0.1, 0, 0};
    const auto object = built(std::vector<StruckPlace>{a, a, b});
    const double unit = gain(object, 1, b) / 0.1;
    CHECK(gain(object, 0, a) == Approx(unit * std::sqrt((0.16 + 0.01) / 2)).epsilon(1e-4));
}

TEST_CASE(
    "A closed mesh of a known material has its volume's mass, and gains scale with the mass") {
    MeasuredObjectSettings settings;
    settings.mesh = icosphereMesh(0.05, 2);
    settings.material = *findMaterial("Glass");
    const std::vector<StruckPlace> places{std::array<double, 3>{0.05, 0, 0},
                                          std::array<double, 3>{0, 0.05, 0},
                                          std::array<double, 3>{0, 0, 0.05}};
    const auto known = built(places, settings);
    CHECK(known.mass.massKg ==
          Approx(settings.material->densityKgPerM3 * signedVolumeM3(*settings.mesh)));
    settings.massKg = 4 * known.mass.massKg;
    const auto heavy = built(places, settings);
    CHECK(heavy.shapes[3] == Approx(known.shapes[3] / 2));
    CHECK(known.material == *settings.material);
}

TEST_CASE("Inputs that cannot make one object give a one-sentence error") {
    const auto refused = [](std::vector<StruckPlace> places, const MeasuredObjectSettings& settings,
                            const char* sentence) {
        const auto object = measuredObject(threeStrikes, places, settings);
        REQUIRE_FALSE(object);
        CHECK_THAT(object.error().message, ContainsSubstring(sentence));
    };
    refused({0.1, 0.2, std::array<double, 3>{0, 0, 0}}, {}, "all of them X,Y,Z or all a radius");
    MeasuredObjectSettings undamped;
    undamped.material = *findMaterial("Steel");
    undamped.material->damping = {};
    refused({0.1, 0.2, 0.3}, undamped, "no damping");
    MeasuredObjectSettings empty;
    empty.mesh = Mesh{};
    refused({0.1, 0.2, 0.3}, empty, "no faces");
}

TEST_CASE("Missing modes, missing places and too few places give a one-sentence error") {
    const std::vector<StruckPlace> three{0.0, 0.05, 0.1};
    const auto sentence = [](const RecordingFit& fit, std::span<const StruckPlace> places) {
        const auto object = measuredObject(fit, places, {});
        REQUIRE_FALSE(object);
        return object.error().message;
    };
    CHECK_THAT(sentence({}, three), ContainsSubstring("no modes"));
    CHECK_THAT(sentence(threeStrikes, {}), ContainsSubstring("0 places"));
    CHECK_THAT(sentence(threeStrikes, std::span(three).first(2)), ContainsSubstring("2 places"));
}
