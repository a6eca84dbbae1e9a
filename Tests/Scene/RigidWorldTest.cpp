// Tests falls, rebounds, weights and rolling against closed forms of mechanics.
#include "Scene/TestBodies.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double stepsPerSecond = 2000;

/// Returns the impacts of one body above the ground.
std::vector<Impact> impactsOf(RigidWorld& world, double seconds, std::size_t body) {
    std::vector<Impact> all;
    while (world.seconds() < seconds) {
        world.step();
        for (const auto& impact : world.impacts())
            if (impact.body == body)
                all.push_back(impact);
    }
    return all;
}

} // namespace

TEST_CASE("A bouncing ball meets the ground at the exact times and speeds") {
    const double radius = 0.01, height = 0.3, restitution = 0.6;
    RigidWorld world(
        {groundKind({.restitution = restitution}), ballKind(radius, {.restitution = restitution})},
        4 * stepsPerSecond, gravity); // a rebound loses the speed that gravity adds in a step
    world.add(0, at({0, 0, 0}));
    const auto ball = world.add(1, at({0.1, 0.2, radius + height}));
    const auto impacts = impactsOf(world, 2, ball);
    REQUIRE(impacts.size() > 3);

    const double mass = ballKind(radius).model->massKg;
    double time = std::sqrt(2 * height / gravity), speed = gravity * time;
    for (std::size_t k = 0; k < 4; ++k) {
        INFO(k);
        CHECK_THAT(impacts[k].seconds, WithinAbs(time, 2e-3));
        CHECK_THAT(impacts[k].speedMetresPerSecond, WithinRel(speed, 0.01));
        CHECK_THAT(impacts[k].impulseNewtonSeconds.z(),
                   WithinRel(mass * speed * (1 + restitution), 0.01));
        CHECK_THAT(impacts[k].impulseNewtonSeconds.head<2>().norm(), WithinAbs(0, 1e-9));
        CHECK_THAT((impacts[k].pointMetres - Eigen::Vector3d(0, 0, -radius)).norm(),
                   WithinAbs(0, 1e-3));
        speed *= restitution;
        time += 2 * speed / gravity;
    }
}

TEST_CASE("A contact lasts as long as Hertz predicts, with opposite impulses on both bodies") {
    const double radius = 0.01, height = 0.05;
    RigidWorld world({groundKind(), ballKind(radius)}, stepsPerSecond, gravity);
    const auto ground = world.add(0, at({0, 0, 0}));
    world.add(1, at({0, 0, radius + height}));
    while (world.impacts().empty())
        world.step();
    REQUIRE(world.impacts().size() == 2);
    const auto &one = world.impacts()[0], &other = world.impacts()[1];
    CHECK(one.body == ground);
    CHECK(one.seconds == other.seconds);
    CHECK((one.impulseNewtonSeconds + other.impulseNewtonSeconds).norm() < 1e-12);

    // T = 2.87 (m²/(R E*² v))^(1/5) of a steel ball on a heavy steel body.
    const auto& steel = *findMaterial("Steel");
    const double modulus =
        steel.youngsModulusPa / (2 * (1 - steel.poissonRatio * steel.poissonRatio));
    const double mass = ballKind(radius).model->massKg, speed = std::sqrt(2 * gravity * height);
    const double hertz = 2.87 * std::pow(mass * mass / (radius * modulus * modulus * speed), 0.2);
    CHECK_THAT(one.contactSeconds, WithinRel(hertz, 0.01));
}

TEST_CASE("A resting body causes no impacts and presses with its weight") {
    RigidWorld world({groundKind(), cubeKind(0.02)}, stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const auto cube = world.add(1, at({0, 0, 0.03}));
    impactsOf(world, 1, cube);
    world.setVelocity(cube, {0, 0, 0}, {0, 0, 0}); // a new velocity wakes the body
    double impulse = 0;
    int impacts = 0;
    const double from = world.seconds();
    while (world.seconds() < from + 0.2) {
        world.step();
        impacts += static_cast<int>(world.impacts().size());
        for (const auto& touch : world.touches())
            impulse += touch.forceNewtons * world.stepSeconds();
    }
    CHECK(impacts == 0);
    CHECK_THAT(impulse, WithinRel(0.2 * cubeKind(0.02).model->massKg * gravity, 0.02));
}

TEST_CASE("A body at rest sleeps within a second, until another one hits it") {
    RigidWorld world({groundKind(), cubeKind(0.02), ballKind(0.005)}, stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const auto cube = world.add(1, at({0, 0, 0.0101}));
    impactsOf(world, 0.1, cube);
    CHECK_FALSE(world.touches().empty());
    impactsOf(world, 1.1, cube);
    CHECK(world.touches().empty());
    world.add(2, at({0.009, 0, 0.05}, {0, 0, -1}));
    CHECK_FALSE(impactsOf(world, 1.3, cube).empty());
    CHECK_FALSE(world.touches().empty());
}

TEST_CASE("A sliding ball ends up rolling at 5/7 of its speed, without impacts") {
    const double radius = 0.02, speed = 1;
    RigidWorld world({groundKind({.friction = 0.3, .restitution = 0}),
                      ballKind(radius, {.friction = 0.3, .restitution = 0})},
                     stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const auto ball = world.add(1, at({0, 0, radius}, {speed, 0, 0}));
    impactsOf(world, 0.02, ball);
    REQUIRE(world.touches().size() == 1);
    // Sliding friction reduces the slip by 7/2 μ g: it ends after 0.1 s.
    CHECK_THAT(world.touches()[0].slideMetresPerSecond,
               WithinAbs(speed - 3.5 * 0.3 * gravity * 0.02, 0.01));
    impactsOf(world, 0.3, ball);
    CHECK_THAT(world.motion(ball).velocity.x(), WithinRel(5.0 / 7 * speed, 0.01));
    CHECK(impactsOf(world, 0.6, ball).empty());
    REQUIRE(world.touches().size() == 1);
    CHECK_THAT(world.touches()[0].rollMetresPerSecond, WithinRel(5.0 / 7 * speed, 0.02));
    CHECK(world.touches()[0].slideMetresPerSecond < 0.01);
}

TEST_CASE("Kinds whose groups do not collide pass through each other") {
    auto ground = groundKind(), ghost = ballKind(0.01);
    ghost.collidesWith = 2;
    RigidWorld world({ground, ghost}, stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const auto ball = world.add(1, at({0, 0, 0.05}));
    CHECK(impactsOf(world, 0.5, ball).empty());
    CHECK(world.motion(ball).pose.translation().z() < -0.5);
}

TEST_CASE("The same bodies fall in the same way, bit for bit") {
    const auto fall = [] {
        RigidWorld world({groundKind(), cubeKind(0.02), ballKind(0.01)}, stepsPerSecond, gravity);
        world.add(0, at({0, 0, 0}));
        for (int k = 0; k < 8; ++k)
            world.add(1 + static_cast<std::size_t>(k % 2),
                      at({0.005 * k, 0.004 * (k % 3), 0.05 + 0.03 * k}, {0, 0.1, 0}, {3, 2, 1}));
        std::vector<double> heard;
        while (world.seconds() < 1) {
            world.step();
            for (const auto& impact : world.impacts())
                heard.insert(heard.end(), {impact.seconds, impact.impulseNewtonSeconds.x(),
                                           impact.pointMetres.y()});
        }
        return heard;
    };
    const auto first = fall();
    CHECK(first.size() > 30);
    CHECK(fall() == first);
}

TEST_CASE("A world with too many pairs reports at once that it is crowded") {
    RigidWorld world({ballKind(0.01)}, stepsPerSecond, gravity);
    for (int k = 0; k < 300; ++k)
        world.add(0, at({0.1 * k, 0, 0}));
    world.step();
    CHECK_FALSE(world.isCrowded());
    CHECK(world.work() == 300);
    while (!world.isCrowded() && world.add(0, at({0, 0, 0})) < 1000)
        continue;
    CHECK(world.isCrowded());
}

TEST_CASE("The numbers of removed bodies are not reused") {
    RigidWorld world({groundKind(), ballKind(0.01)}, stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const auto first = world.add(1, at({0, 0, 0.05}));
    world.remove(first);
    const auto second = world.add(1, at({0, 0, 0.05}));
    CHECK(second != first);
    CHECK_FALSE(impactsOf(world, 0.3, second).empty());
}

TEST_CASE("An object without faces is refused as a surface") {
    const auto object = objectOf(sheetMesh(1, 1, 4), "Steel");
    object->faces.clear();
    BodyTemplate kind{.name = "floor", .object = "sheet", .form = BodyForm::surface};
    kind.isFixed = true;
    const auto model = makeRigidBodyModel(kind, object);
    REQUIRE_FALSE(model);
    CHECK(model.error().message == "'floor' is no surface: its object 'body' has no faces");
}
