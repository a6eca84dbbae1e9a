// Tests how contact voices follow pairs of bodies.
#include "Scene/TouchTracker.h"
#include "Instrument/ObjectLibrary.h"
#include "Scene/SilentBody.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double stepSeconds = 0.001;
constexpr std::size_t plate = 0, doubled = 1, ball = 2; // roles
constexpr std::size_t bodyCount = 100;

/// Loads two plates, the second twice as large and rougher, and a ball that is not heard.
std::shared_ptr<const SceneAssets> assetsOfThree() {
    Scene scene;
    scene.kinds = {
        {.name = "plate", .object = "plate", .surface = Surface{.roughness = 0.2}},
        {.name = "doubled",
         .object = "plate",
         .sizeRatio = 2,
         .surface = Surface{.roughness = 0.3}},
        {.name = "ball", .object = "", .given = silentBall(0.01, *findMaterial("Steel"))}};
    return SceneAssets::make(scene, ObjectLibrary::shared()).value();
}

/// Bodies that have the three roles in turn. Body k has slot 1000 + k.
class Rig {
public:
    Rig() {
        for (std::size_t body = 0; body < bodyCount; ++body) {
            roles.push_back(body % 3);
            slots.push_back(1000 + body);
        }
    }

    void follow(const std::vector<Touch>& touches, int steps = 1) {
        for (int step = 0; step < steps; ++step)
            tracker.follow(touches, roles, slots);
    }

    /// Returns the state of the voice of this pair, or nullptr.
    const TouchState* of(const Touch& touch) const {
        const std::array wanted{1000 + touch.bodies[0], 1000 + touch.bodies[1]};
        const auto found = std::ranges::find_if(tracker.states(), [&](const TouchState& state) {
            return state.pair != 0 && state.slots == wanted;
        });
        return found == tracker.states().end() ? nullptr : &*found;
    }

    std::shared_ptr<const SceneAssets> assets = assetsOfThree();
    TouchTracker tracker{assets, stepSeconds};
    std::vector<std::size_t> roles, slots;
};

Touch sliding(std::size_t first, std::size_t second, double newtons = 2) {
    Touch touch;
    touch.bodies = {first, second};
    touch.pointMetres.fill(Eigen::Vector3d::Zero());
    touch.inward = {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, 0, 1)};
    touch.forceNewtons = newtons;
    touch.slideMetresPerSecond = 0.3;
    touch.rollMetresPerSecond = 0.1;
    return touch;
}

} // namespace

TEST_CASE(
    "Force and speeds follow with a time constant of 4 ms, and the force fades in the same way") {
    Rig rig;
    const auto touch = sliding(0, 1);
    rig.follow({touch}, 8);
    const double near = 1 - std::exp(-2.0);
    const auto* state = rig.of(touch);
    REQUIRE(state != nullptr);
    CHECK_THAT(state->forceNewtons, WithinAbs(near * 2, 1e-12));
    CHECK_THAT(state->slideMetresPerSecond, WithinAbs(near * 0.3, 1e-12));
    CHECK_THAT(state->rollMetresPerSecond, WithinAbs(near * 0.1, 1e-12));
    rig.follow({}, 12);
    CHECK_THAT(state->forceNewtons, WithinAbs(near * 2 * std::exp(-3.0), 1e-12));
    CHECK_THAT(state->slideMetresPerSecond, WithinAbs(near * 0.3, 1e-12));
}

TEST_CASE(
    "A pair keeps its voice over a hop of less than 30 ms and starts again after a longer one") {
    Rig rig;
    const auto touch = sliding(0, 1), other = sliding(3, 4);
    rig.follow({touch});
    const auto pair = rig.of(touch)->pair;
    rig.follow({other}, 28);
    CHECK(rig.of(other)->pair != pair);
    rig.follow({touch, other});
    CHECK(rig.of(touch)->pair == pair);
    rig.follow({other}, 32);
    rig.follow({touch, other});
    CHECK(rig.of(touch)->pair != pair);
    CHECK(rig.of(touch)->pair != rig.of(other)->pair);
    CHECK_THAT(rig.of(touch)->forceNewtons,
               WithinAbs(2 * (1 - std::exp(-stepSeconds / 0.004)), 1e-12)); // starts again at 0
}

TEST_CASE("A contact that hardly moves has no voice") {
    Rig rig;
    auto touch = sliding(0, 1);
    touch.slideMetresPerSecond = touch.rollMetresPerSecond = 0.0009;
    rig.follow({touch}, 10);
    CHECK(rig.of(touch) == nullptr);
    touch.rollMetresPerSecond = 0.0011;
    rig.follow({touch}, 10);
    CHECK(rig.of(touch) != nullptr);
}

TEST_CASE("If there are more pairs than voices, the loudest get voices and keep them") {
    Rig rig;
    std::vector<Touch> touches; // from soft to loud
    for (std::size_t k = 0; k < 40; ++k)
        touches.push_back(sliding(2 * k, 2 * k + 1, 1 + static_cast<double>(k)));
    rig.follow(touches);
    for (std::size_t k = 0; k < touches.size(); ++k)
        CHECK((rig.of(touches[k]) != nullptr) == (k >= touches.size() - touchVoices));
    // A louder pair waits until a voice is free.
    const auto loudest = sliding(90, 91, 1000);
    touches.push_back(loudest);
    rig.follow(touches, 10);
    CHECK(rig.of(loudest) == nullptr);
    touches.erase(touches.end() - 2); // the loudest of the earlier pairs ends
    rig.follow(touches, 40);
    CHECK(rig.of(loudest) != nullptr);
}

TEST_CASE("A voice returns the slots of its bodies and the rougher surface") {
    Rig rig;
    for (const auto& [bodies, role] : {std::pair{std::array<std::size_t, 2>{0, 1}, doubled},
                                       {std::array<std::size_t, 2>{4, 6}, doubled}}) {
        const auto touch = sliding(bodies[0], bodies[1]);
        rig.follow({touch});
        REQUIRE(rig.of(touch) != nullptr);
        CHECK(rig.of(touch)->surface == rig.assets->roles()[role].surfaceIndex);
    }
}

TEST_CASE("Contact points follow the size of each body and are updated after 2 mm") {
    Rig rig;
    auto touch = sliding(0, 1);
    touch.pointMetres = {Eigen::Vector3d(0.02, 0.01, 0), Eigen::Vector3d(0.06, -0.02, 0)};
    rig.follow({touch});
    const auto onPlate = [&](double x, double y) {
        return rig.assets->roles()[plate].surface->nearest({x, y, 0});
    };
    const auto* state = rig.of(touch);
    CHECK(state->points[0].point == onPlate(0.02, 0.01));
    CHECK(state->points[1].point == onPlate(0.03, -0.01));
    CHECK(state->points[0].direction == std::array{0.0f, 0.0f, -1.0f});
    CHECK(state->points[1].direction == std::array{0.0f, 0.0f, 1.0f});

    const auto before = state->points;
    touch.pointMetres[0].x() += 0.0019;
    touch.pointMetres[1].x() += 0.0021;
    rig.follow({touch});
    CHECK(state->points[0].point == before[0].point);
    CHECK(state->points[1].point == onPlate(0.0621 / 2, -0.01));
    touch.pointMetres[0].x() += 0.0002;
    rig.follow({touch});
    CHECK(state->points[0].point == onPlate(0.0221, 0.01));
}

TEST_CASE("A ball that is not heard has no contact point") {
    Rig rig;
    const auto touch = sliding(0, 2);
    rig.follow({touch});
    const auto* state = rig.of(touch);
    REQUIRE(state != nullptr);
    CHECK(rig.roles[2] == ball);
    CHECK(state->points[0].direction == std::array{0.0f, 0.0f, -1.0f});
    CHECK(state->points[1] == ForcePoint());
}
