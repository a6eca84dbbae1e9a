#include "Instrument/StrikeStrip.h"

#include "Instrument/ObjectLibrary.h"
#include "Support/SyntheticObject.h"
#include "Synth/PlaceBetween.h"
#include "World/ObjectSurface.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>

using namespace idiophone;
using Catch::Approx;
using test::syntheticObject;

namespace {

/// Returns φ·n of a mode at a place.
double gain(const ModalObject& object, const StrikePoint& point, std::size_t mode) {
    double sum = 0;
    for (std::size_t k = 0; k < maximumShapeRows; ++k) {
        if (point.weights[k] == 0)
            continue;
        const auto shapes = object.shapesAt(static_cast<std::size_t>(point.shapeRows[k]));
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum += static_cast<double>(point.weights[k] * shapes[3 * mode + axis] *
                                       point.normal[axis]);
    }
    return sum;
}

double weightSum(const StrikePoint& point) {
    double sum = 0;
    for (const float weight : point.weights)
        sum += static_cast<double>(weight);
    return sum;
}

StrikePoint atRows(std::array<std::int32_t, 3> rows, std::array<float, 3> weights) {
    return {.shapeRows = {rows[0], rows[1], rows[2]},
            .weights = {weights[0], weights[1], weights[2]},
            .normal = {0, 0, 1}};
}

/// A flat box around the origin with shapes at its corners.
ModalObject flatBox() {
    auto object = syntheticObject({100});
    object.vertices.clear();
    for (const float z : {-0.05f, 0.05f})
        for (const auto& [x, y] :
             {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
            object.vertices.insert(object.vertices.end(), {x, y, z});
    object.faces = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                    1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    object.shapeVertices = {0, 1, 2, 3, 4, 5, 6, 7};
    object.shapes.assign(24, 1);
    return object;
}

KeyMap mapAlong(std::vector<std::array<double, 3>> path, double width = 1) {
    KeyMap map;
    map.strikePath = std::move(path);
    map.strikeWidth = width;
    return map;
}

} // namespace

TEST_CASE("A shape that is linear over the surface is exact at every place of the strip") {
    auto object = syntheticObject({200});
    for (std::size_t row = 0; row < 4; ++row)
        object.shapes[3 * row + 2] =
            2 + 3 * object.vertices[3 * row] - object.vertices[3 * row + 1];
    const auto strip = strikeStrip(object, mapAlong({{-0.8, -0.6, 0}, {0.7, 0.5, 0}}, 0.3));
    for (double along = 0; along <= 1; along += 0.0073) {
        const double x = 0.5 + 0.5 * (-0.8 + 1.5 * along), y = 0.5 + 0.5 * (-0.6 + 1.1 * along);
        REQUIRE(gain(object, strip.between(along, 0).point, 0) ==
                Approx(2 + 3 * x - y).epsilon(1e-5));
    }
    // A place to the left of the path, whose direction is (1.5, 1.1).
    const double norm = std::hypot(1.5, 1.1), reach = 0.3 * 0.5 * (1.5 + 1.1) / norm;
    const double x = 0.5 + 0.5 * (-0.8 + 0.75) - 0.37 * reach * 1.1 / norm;
    const double y = 0.5 + 0.5 * (-0.6 + 0.55) + 0.37 * reach * 1.5 / norm;
    CHECK(gain(object, strip.between(0.5, 0.37).point, 0) == Approx(2 + 3 * x - y).epsilon(1e-5));
}

TEST_CASE("Along the plate's paths every mode's gain is the surface's within 2 %, without steps") {
    const auto plate = ObjectLibrary::shared().find("plate").value();
    using Corner = std::array<double, 2>; // in half lengths and widths
    const auto [from, to] = GENERATE(std::pair(Corner{-1, -1}, Corner{1, 1}),
                                     std::pair(Corner{-0.9, 0.9}, Corner{0, 0.9}));
    const auto strip =
        strikeStrip(*plate, mapAlong({{from[0], from[1], 0}, {to[0], to[1], 0}}, 0.6));
    const ObjectSurface surface(*plate);
    constexpr int places = 3000;
    for (const std::size_t mode : {0u, 3u, 10u, 25u}) {
        double error = 0, power = 0, last = 0, furthest = 0, strongest = 0;
        int distinct = 0;
        for (int i = 0; i <= places; ++i) {
            const double way = static_cast<double>(i) / places;
            const auto point = strip.between(way, 0).point;
            REQUIRE(weightSum(point) == Approx(1).epsilon(1e-5));
            const double found = gain(*plate, point, mode);
            const double expected =
                gain(*plate,
                     surface.nearest({0.15 * (from[0] + way * (to[0] - from[0])),
                                      0.1 * (from[1] + way * (to[1] - from[1])), 0}),
                     mode);
            error += (found - expected) * (found - expected);
            power += expected * expected;
            strongest = std::max(strongest, std::abs(found));
            distinct += i > 0 && found != last ? 1 : 0;
            if (i > 0)
                furthest = std::max(furthest, std::abs(found - last));
            last = found;
        }
        INFO("mode " << mode << ": error " << std::sqrt(error / power) << ", largest step "
                     << furthest / strongest);
        CHECK(std::sqrt(error / power) < 0.02);
        CHECK(furthest < 0.01 * strongest);
        CHECK(distinct > 0.98 * places);
    }
}

TEST_CASE("Places beside the path move without steps too") {
    const auto plate = ObjectLibrary::shared().find("plate").value();
    const auto strip = strikeStrip(*plate, mapAlong({{-1, -1, 0}, {1, 1, 0}}, 0.6));
    for (const double along : {0.2, 0.503, 0.77}) {
        double last = 0;
        for (int i = 0; i <= 1000; ++i) {
            const double now = gain(*plate, strip.between(along, i / 500.0 - 1).point, 0);
            if (i > 0)
                REQUIRE(std::abs(now - last) < 0.02);
            last = now;
        }
    }
}

TEST_CASE(
    "The path's direction and the normal are unit vectors, and the direction lies in the surface") {
    const auto ring = ObjectLibrary::shared().find("ring").value();
    const auto strip = strikeStrip(*ring, mapAlong({{0, -1, 0}, {1, 0, 0}, {0, 1, 0}}));
    for (double along = 0.01; along < 1; along += 0.0313)
        for (const double across : {-0.7, 0.0, 0.33}) {
            const auto [point, direction] = strip.between(along, across);
            const auto& normal = point.normal;
            REQUIRE(std::hypot(normal[0], normal[1], normal[2]) == Approx(1));
            REQUIRE(std::hypot(direction[0], direction[1], direction[2]) == Approx(1));
            REQUIRE(std::abs(normal[0] * direction[0] + normal[1] * direction[1] +
                             normal[2] * direction[2]) < 0.02f);
            REQUIRE(direction[1] > 0);
        }
}

TEST_CASE("Places of the table are exact, and places beyond the ends are the ends") {
    const auto plate = ObjectLibrary::shared().find("plate").value();
    const auto strip = strikeStrip(*plate, mapAlong({{-1, -1, 0}, {1, 1, 0}}));
    for (const int i : {0, 1, 77, strip.alongCount - 1}) {
        const double along = static_cast<double>(i) / (strip.alongCount - 1);
        CHECK(strip.between(along, 0).point == strip.at(along, 0));
    }
    CHECK(strip.between(2, 7).point == strip.between(1, 1).point);
    CHECK(strip.between(-2, -7).point == strip.between(0, -1).point);
}

TEST_CASE("A path through the middle of a solid stays on its upper side") {
    const auto strip = strikeStrip(flatBox(), mapAlong({{-0.9, 0.05, 0}, {0.9, -0.05, 0}}));
    for (double along = 0.2; along <= 0.8; along += 0.01) {
        const auto point = strip.between(along, 0).point;
        double above = 0;
        for (std::size_t k = 0; k < maximumShapeRows; ++k)
            above += point.shapeRows[k] >= 4 ? static_cast<double>(point.weights[k]) : 0;
        REQUIRE(above == Approx(1).epsilon(1e-5));
    }
}

TEST_CASE("Rows of several places count once in the place between them") {
    PlaceBetween between;
    between.add(atRows({3, 5, 8}, {0.5f, 0.25f, 0.25f}), 0.5);
    between.add(atRows({5, 3, 9}, {0.5f, 0.5f, 0}), 0.5);
    const auto point = between.point();
    CHECK(point.shapeRows == std::array{3, 5, 8, 0, 0, 0});
    CHECK(point.weights == std::array{0.5f, 0.375f, 0.125f, 0.0f, 0.0f, 0.0f});
}

TEST_CASE("If a strike has too many rows, the lightest are left out without a step") {
    const auto first = atRows({0, 1, 2}, {0.5f, 0.3f, 0.2f});
    const auto second = atRows({3, 4, 5}, {0.4f, 0.4f, 0.2f});
    const auto third = atRows({6, 7, 8}, {0.6f, 0.3f, 0.1f});
    std::array<double, 9> last{};
    for (int i = 0; i <= 1000; ++i) {
        const double way = i / 1000.0;
        PlaceBetween between;
        between.add(first, 0.6 * (1 - way));
        between.add(second, 0.4);
        between.add(third, 0.6 * way);
        const auto point = between.point();
        REQUIRE(weightSum(point) == Approx(1).epsilon(1e-5));
        std::array<double, 9> weights{};
        for (std::size_t k = 0; k < maximumShapeRows; ++k)
            weights[static_cast<std::size_t>(point.shapeRows[k])] +=
                static_cast<double>(point.weights[k]);
        if (i > 0)
            for (std::size_t row = 0; row < weights.size(); ++row)
                REQUIRE(std::abs(weights[row] - last[row]) < 0.01);
        last = weights;
    }
    CHECK(last[6] > 0.3);
}
