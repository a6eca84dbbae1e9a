// Tests rings that touch planes, faces and other rings.
#include "Scene/RelativeCircle.h"
#include "Scene/TestBodies.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double stepsPerSecond = 2000;
constexpr double radius = 0.05, sectionRadius = 0.005;

RigidWorld::Kind ringKind(Contactful with = {}, bool isFixed = false) {
    auto object = objectOf(torusMesh(radius, sectionRadius, 96, 24), "Steel");
    const double mass = 0.2, along = mass * radius * radius, across = along / 2;
    object->mass = {.massKg = mass, .inertiaKgM2 = {across, 0, 0, 0, across, 0, 0, 0, along}};
    return kindOf(object, BodyForm::ring, isFixed, with);
}

/// Returns a table whose top is at z = 0.
RigidWorld::Kind tableKind(Contactful with = {}) {
    Mesh box = boxMesh({0.6, 0.4, 0.02}, {2, 2, 2});
    box.vertices.col(2).array() -= box.vertices.col(2).maxCoeff();
    return kindOf(objectOf(box, "Steel"), BodyForm::hull, true, with);
}

BodyMotion tilted(double degrees, const Eigen::Vector3d& place) {
    auto motion = at(place);
    motion.pose.rotate(
        Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Eigen::Vector3d::UnitX()));
    return motion;
}

void run(RigidWorld& world, double seconds) {
    const double end = world.seconds() + seconds;
    while (world.seconds() < end)
        world.step();
}

} // namespace

TEST_CASE("A ring comes to rest flat, at the height of its section") {
    const bool isTable = GENERATE(true, false);
    const double degrees = GENERATE(0.0, 1.0, 20.0);
    RigidWorld world({isTable ? tableKind({.restitution = 0}) : groundKind({.restitution = 0}),
                      ringKind({.restitution = 0})},
                     stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const auto ring = world.add(1, tilted(degrees, {0.02, 0.01, 0.04}));
    run(world, 2);
    CHECK_THAT(world.centre(ring).z(), WithinAbs(sectionRadius, 1e-4));
    CHECK(std::abs(world.motion(ring).pose.linear()(2, 2)) > 0.9999);
    CHECK(world.impacts().empty());
}

TEST_CASE("A ring on its edge rolls without impacts at a constant speed") {
    const double speed = 0.5;
    RigidWorld world({groundKind(), ringKind()}, stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    auto rolling = tilted(90, {0, 0, radius + sectionRadius});
    rolling.velocity = {speed, 0, 0};
    rolling.spin = {0, speed / (radius + sectionRadius), 0};
    const auto ring = world.add(1, rolling);
    run(world, 0.05); // to settle into the ground
    int impacts = 0;
    while (world.seconds() < 0.8) {
        world.step();
        impacts += static_cast<int>(world.impacts().size());
        CHECK_THAT(world.centre(ring).z(), WithinAbs(radius + sectionRadius, 1e-4));
    }
    CHECK(impacts == 0);
    CHECK_THAT(world.motion(ring).velocity.x(), WithinAbs(speed, 0.01 * speed));
}

TEST_CASE("A ring falls off a table's edge, and rests across a fixed ring") {
    SECTION("table") {
        RigidWorld world({tableKind(), ringKind()}, stepsPerSecond, gravity);
        world.add(0, at({0, 0, 0}));
        const auto ring = world.add(1, at({0.32, 0, 0.01}));
        run(world, 1);
        CHECK(world.centre(ring).z() < -1);
    }
    SECTION("ring") {
        RigidWorld world({ringKind({.restitution = 0}, true), ringKind({.restitution = 0})},
                         stepsPerSecond, gravity);
        world.add(0, at({0, 0, 0}));
        const auto ring = world.add(1, at({0.003, 0, 0.02}));
        run(world, 0.1);
        CHECK_THAT(world.centre(ring).z(), WithinAbs(2 * sectionRadius, 1e-3));
    }
}

TEST_CASE("A ring that hangs in a fixed ring swings, and does not pass through it") {
    RigidWorld world({ringKind({}, true), ringKind()}, stepsPerSecond, gravity);
    world.add(0, tilted(90, {0, 0, 0}));
    auto hanging = at({0, 0, -radius - 0.01}); // linked: each goes through the other
    hanging.pose.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()));
    const auto ring = world.add(1, hanging);
    for (int tenth = 0; tenth < 20; ++tenth) {
        run(world, 0.1);
        CHECK(world.centre(ring).norm() < 2 * radius);
    }
    CHECK(world.centre(ring).z() < -radius);
}

TEST_CASE("Two rings that meet edge to edge in one plane exchange their speeds") {
    const double speed = 1;
    RigidWorld world({ringKind({.friction = 0, .restitution = 1})}, stepsPerSecond, 0);
    const auto first = world.add(0, at({0, 0, 0}, {speed, 0, 0}));
    const auto second = world.add(0, at({2 * (radius + sectionRadius) + 0.01, 0, 0}));
    std::vector<Impact> impacts;
    while (world.seconds() < 0.05) {
        world.step();
        impacts.insert(impacts.end(), world.impacts().begin(), world.impacts().end());
    }
    REQUIRE(impacts.size() == 2);
    CHECK_THAT(impacts[0].seconds, WithinAbs(0.01, 1e-4));
    CHECK_THAT(std::abs(impacts[0].pointMetres.x()), WithinAbs(radius + sectionRadius, 2e-3));
    CHECK_THAT(world.motion(first).velocity.x(), WithinAbs(0, 0.01));
    CHECK_THAT(world.motion(second).velocity.x(), WithinAbs(speed, 0.01));
}

TEST_CASE("A ring sleeps while a ball rolls inside it, and wakes as the ball touches it") {
    const double ballRadius = 0.004, speed = 0.05;
    RigidWorld world({groundKind(), ringKind(), ballKind(ballRadius)}, stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const auto ring = world.add(1, at({0, 0, sectionRadius}));
    const auto ball =
        world.add(2, at({0, 0, ballRadius}, {speed, 0, 0}, {0, speed / ballRadius, 0}));
    run(world, 0.75); // the ball meets the ring at 0.8 s
    CHECK(world.motion(ring).velocity.norm() == 0);
    CHECK(world.motion(ring).spin.norm() == 0);
    CHECK(world.motion(ball).velocity.x() > 0.9 * speed);
    const double before = world.centre(ring).x();
    run(world, 0.25);
    CHECK(world.centre(ring).x() > before);
}

TEST_CASE("A ring on a ring that is removed falls, although both slept") {
    RigidWorld world({groundKind({.restitution = 0}), ringKind({.restitution = 0})}, stepsPerSecond,
                     gravity);
    world.add(0, at({0, 0, 0}));
    const auto lower = world.add(1, at({0, 0, sectionRadius}));
    const auto upper = world.add(1, at({0, 0, 3 * sectionRadius}));
    run(world, 1);
    REQUIRE(world.motion(upper).velocity.norm() == 0);
    world.remove(lower);
    run(world, 0.5);
    CHECK_THAT(world.centre(upper).z(), WithinAbs(sectionRadius, 1e-4));
}

TEST_CASE("A ring at rest on a ring sleeps wherever it lies") {
    for (int micrometres = 0; micrometres < 32; ++micrometres) {
        INFO("moved by " << micrometres << " micrometres");
        RigidWorld world({groundKind({.restitution = 0}), ringKind({.restitution = 0})},
                         stepsPerSecond, gravity);
        world.add(0, at({0, 0, 0}));
        world.add(1, at({0, 0, sectionRadius}));
        const auto upper = world.add(1, at({1e-6 * micrometres, 0, 3 * sectionRadius}));
        run(world, 1);
        CHECK(world.motion(upper).velocity.norm() == 0);
    }
}

TEST_CASE("The nearest place of two circles is nearer than every place beside it") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> part(-1, 1);
    const auto anyRing = [&] {
        const btVector3 axis(part(random), part(random), part(random));
        return RoundRing{.pose = btTransform(btQuaternion(axis, 3 * part(random)),
                                             btVector3(part(random), part(random), part(random))),
                         .radius = 1.5 + part(random)};
    };
    for (int pair = 0; pair < 200; ++pair) {
        const RelativeCircle circle(anyRing(), anyRing());
        const auto at = [](double degrees) {
            const double angle = degrees * std::numbers::pi / 180;
            return Direction{std::cos(angle), std::sin(angle)};
        };
        double nearest = 0; // in degrees
        for (double degrees = 0; degrees < 360; degrees += 1)
            if (circle.squaredDistance(at(degrees)) < circle.squaredDistance(at(nearest)))
                nearest = degrees;
        const auto found = circle.minimumBetween(at(nearest - 7), at(nearest + 7));
        INFO(pair << ", near " << nearest << " degrees");
        CHECK(circle.squaredDistance(found) <= circle.squaredDistance(at(nearest)));
        for (const double beside : {-0.01, 0.01}) {
            const double angle = std::atan2(found.sine, found.cosine) * 180 / std::numbers::pi;
            CHECK(circle.squaredDistance(found) < circle.squaredDistance(at(angle + beside)));
        }
    }
}
