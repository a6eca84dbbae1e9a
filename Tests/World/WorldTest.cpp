// Tests the bodies that another program moves, strikes and presses.
#include "World/World.h"

#include "Support/AllocationCounter.h"
#include "Support/SyntheticObject.h"
#include "Synth/Synthesiser.h"
#include "World/TouchVoices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr double rateHz = 48000;

std::shared_ptr<const ModalObject> square() {
    static const auto object =
        std::make_shared<const ModalObject>(syntheticObject({400, 1100, 2900}, {1, 0.7f, 0.4f}));
    return object;
}

std::unique_ptr<World> worldOf(std::size_t bodies, const WorldSettings& settings = {}) {
    return std::move(
        World::make(std::vector<SynthesiserSlot>(bodies, {.object = square()}), settings).value());
}

/// Radiation plays no part, so that sounds can be compared with strikes.
WorldSettings flat() {
    return {.listener = {}, .synthesis = {.tau = 0}};
}

WorldImpact hit(std::size_t body = 0, double seconds = 0) {
    return {.body = body,
            .seconds = seconds,
            .pointMetres = {0.2, 0.3, 0},
            .impulseNewtonSeconds = {0, 0, -0.02}};
}

struct Ears {
    std::vector<float> left, right;

    double energy(const std::vector<float>& ear) const {
        double sum = 0;
        for (const float x : ear)
            sum += double{x} * x;
        return sum;
    }
};

Ears rendered(World& world, std::size_t samples, std::size_t block = 64) {
    Ears ears{std::vector<float>(samples), std::vector<float>(samples)};
    for (std::size_t done = 0; done < samples; done += block) {
        const auto count = std::min(block, samples - done);
        world.render(std::span(ears.left).subspan(done, count),
                     std::span(ears.right).subspan(done, count));
    }
    return ears;
}

} // namespace

TEST_CASE("Without a listener an impact sounds bit for bit as a strike at its sample") {
    const auto world = worldOf(1, flat());
    auto impact = hit(0, 100.25 / rateHz);
    impact.vertex = 2;
    impact.contactSeconds = 0.001;
    REQUIRE(world->strike(impact) == WorldAnswer::done);
    const auto ears = rendered(*world, 4096);

    Synthesiser synthesiser({{.object = square()}}, rateHz, 2);
    synthesiser.setSettings({.tau = 0});
    std::vector<float> expected;
    for (int cell = 0; cell < 64; ++cell) {
        std::array<float, cellSamples> left{}, right{};
        synthesiser.beginCell(CellOutput(left, right));
        if (cell == 1)
            synthesiser.strike(0,
                               {.point = {.shapeRows = {2}, .weights = {1}},
                                .impulseNewtonSeconds = {0, 0, -0.02f},
                                .durationSeconds = 0.001},
                               36.25, CellOutput(left, right));
        expected.insert(expected.end(), left.begin(), left.end());
    }
    CHECK(ears.left == expected);
    CHECK(ears.right == expected);
}

TEST_CASE("The sound of a world does not depend on the size of its blocks") {
    const auto play = [](std::size_t block) {
        const auto world = worldOf(3);
        world->place(1, {.originMetres = {2, 0, 0}});
        for (std::size_t body = 0; body < 3; ++body)
            world->strike(hit(body, 0.003 * static_cast<double>(body)));
        const auto touch = world->beginTouch();
        world->touch(*touch, {.body = 2, .forceNewtons = 3, .slideMetresPerSecond = {0.4, 0, 0}});
        return rendered(*world, 6000, block).left;
    };
    const auto expected = play(6000);
    for (const std::size_t block : {1u, 7u, 64u, 500u})
        CHECK(play(block) == expected);
}

TEST_CASE("A body sounds louder when it is near, and at the ear that it is on") {
    const auto play = [](double xMetres, double yMetres) {
        const auto world = worldOf(1);
        world->placeListener({.positionMetres = {0, 0, 0}, .towardsMetres = {0, 1, 0}});
        world->place(0, {.originMetres = {xMetres - 0.5, yMetres - 0.5, 0}}); // its middle
        rendered(*world, 9600);                                               // arrive there
        auto impact = hit();
        impact.pointMetres += Eigen::Vector3d(xMetres - 0.5, yMetres - 0.5, 0);
        world->strike(impact);
        return rendered(*world, 9600);
    };
    const auto near = play(0, 2), far = play(0, 4), right = play(2, 0);
    CHECK_THAT(near.energy(near.left) / far.energy(far.left), WithinRel(4, 0.1));
    CHECK_THAT(near.energy(near.left) / near.energy(near.right), WithinRel(1, 0.01));
    CHECK(right.energy(right.right) > 1.5 * right.energy(right.left));
}

TEST_CASE("A listener may take any direction as up") {
    const auto play = [](const Eigen::Matrix3d& turn) {
        const auto world = worldOf(1);
        const Eigen::Vector3d place = turn * Eigen::Vector3d(1.5, 1, 0.2);
        world->placeListener({.positionMetres = {0, 0, 0},
                              .towardsMetres = turn * Eigen::Vector3d::UnitY(),
                              .up = turn * Eigen::Vector3d::UnitZ()});
        world->place(0, {.originMetres = place, .axes = turn});
        rendered(*world, 9600);
        auto impact = hit();
        impact.pointMetres = place + turn * impact.pointMetres;
        impact.impulseNewtonSeconds = turn * impact.impulseNewtonSeconds;
        world->strike(impact);
        return rendered(*world, 2400);
    };
    const auto upright = play(Eigen::Matrix3d::Identity());
    const auto turned =
        play(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()).matrix());
    CHECK_THAT(turned.energy(turned.left), WithinRel(upright.energy(upright.left), 1e-3));
    CHECK_THAT(turned.energy(turned.right), WithinRel(upright.energy(upright.right), 1e-3));
}

TEST_CASE("A turned body is struck where and as its own coordinates say") {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    const Eigen::Vector3d origin(3, -2, 1);
    const auto upright = worldOf(1, flat()), turned = worldOf(1, flat());
    auto impact = hit();
    upright->strike(impact);
    turned->place(0, {.originMetres = origin, .axes = turn});
    impact.pointMetres = origin + turn * impact.pointMetres;
    impact.impulseNewtonSeconds = turn * impact.impulseNewtonSeconds;
    turned->strike(impact);
    const auto one = rendered(*upright, 2000), other = rendered(*turned, 2000);
    for (std::size_t k = 0; k < one.left.size(); k += 10)
        CHECK(std::abs(one.left[k] - other.left[k]) < 1e-5 * std::abs(0.02));
}

TEST_CASE("Damping, material and gain change what sounds") {
    const auto play = [](auto change) {
        const auto world = worldOf(1, flat());
        change(*world);
        world->strike(hit());
        const auto ears = rendered(*world, 24000);
        return ears.energy(ears.left);
    };
    const double plain = play([](World&) {});
    CHECK_THAT(play([](World& world) { world.setGain(0.5); }), WithinRel(plain / 4, 0.02));
    CHECK(play([](World& world) { world.setDamping(0, 50); }) < plain / 4);
    CHECK(play([](World& world) {
              world.setMaterial(0, LiveMaterial{1e10, 4000, {}});
          }) < plain / 2);
}

TEST_CASE("A touch sounds until it ends, and another may take its place") {
    const auto world = worldOf(2);
    CHECK(world->silent());
    const WorldTouch slide{.body = 0,
                           .other = 1,
                           .pointMetres = {0.5, 0.5, 0},
                           .forceNewtons = 4,
                           .slideMetresPerSecond = {0.5, 0, 0}};
    for (int round = 0; round < 60; ++round) {
        const auto number = world->beginTouch();
        REQUIRE(number);
        REQUIRE(world->touch(*number, slide) == WorldAnswer::done);
        const auto ears = rendered(*world, 960);
        CHECK(ears.energy(ears.left) > 0);
        REQUIRE(world->endTouch(*number) == WorldAnswer::done);
        CHECK(world->endTouch(*number) == WorldAnswer::invalid);
        CHECK(world->touch(*number, slide) == WorldAnswer::invalid);
    }
    for (std::size_t body = 0; body < 2; ++body)
        world->setDamping(body, 500);
    rendered(*world, 48000);
    CHECK(world->silent());
}

TEST_CASE("All touches in use, and too many calls, are busy; nothing is lost") {
    auto settings = flat();
    settings.eventCapacity = 16;
    const auto world = worldOf(1, settings), roomy = worldOf(1, flat());
    std::size_t touches = 0;
    while (world->beginTouch())
        ++touches;
    CHECK(touches == touchVoices);

    int taken = 0;
    for (; world->strike(hit(0, 0.001 * taken)) == WorldAnswer::done; ++taken)
        roomy->strike(hit(0, 0.001 * taken));
    CHECK(taken >= 16);
    CHECK(world->setGain(2) == WorldAnswer::busy);
    CHECK(rendered(*world, 4800).left == rendered(*roomy, 4800).left);
    CHECK(world->setGain(2) == WorldAnswer::done);
}

TEST_CASE("Worlds and calls out of range are refused") {
    CHECK_FALSE(World::make({}));
    CHECK_FALSE(World::make({{.object = nullptr}}));
    CHECK_FALSE(World::make({{.object = square(), .sizeRatio = 0}}));
    CHECK_FALSE(World::make({{.object = square()}}, {.sampleRateHz = 100}));
    CHECK_FALSE(World::make({{.object = square()}}, {.surfaces = {}}));
    CHECK_FALSE(World::make({{.object = square()}}, {.surfaces = {{.roughness = -1}}}));
    CHECK_FALSE(World::make({{.object = square()}}, {.eventCapacity = 1}));

    const auto world = worldOf(1);
    const double nan = std::nan("");
    auto impact = hit(1);
    CHECK(world->strike(impact) == WorldAnswer::invalid);
    impact = hit(0, nan);
    CHECK(world->strike(impact) == WorldAnswer::invalid);
    impact = hit();
    impact.vertex = 9;
    CHECK(world->strike(impact) == WorldAnswer::invalid);
    impact = hit();
    impact.contactSeconds = 2;
    CHECK(world->strike(impact) == WorldAnswer::invalid);
    CHECK(world->place(0, {.originMetres = {nan, 0, 0}}) == WorldAnswer::invalid);
    CHECK(world->place(0, {.axes = 2 * Eigen::Matrix3d::Identity()}) == WorldAnswer::invalid);
    CHECK(world->placeListener({.positionMetres = {nan, 0, 0}}) == WorldAnswer::invalid);
    CHECK(worldOf(1, flat())->placeListener({}) == WorldAnswer::invalid);
    CHECK(world->setSynthesis({.tau = -1}) == WorldAnswer::invalid);
    CHECK(world->setDamping(0, nan) == WorldAnswer::invalid);
    CHECK(world->setMaterial(0, LiveMaterial{}) == WorldAnswer::invalid);
    CHECK(world->setGain(-1) == WorldAnswer::invalid);
    const auto touch = world->beginTouch();
    CHECK(world->touch(*touch, {.body = 1}) == WorldAnswer::invalid);
    CHECK(world->touch(*touch, {.other = 1}) == WorldAnswer::invalid);
    CHECK(world->touch(*touch, {.surface = 1}) == WorldAnswer::invalid);
    CHECK(world->touch(*touch, {.forceNewtons = nan}) == WorldAnswer::invalid);
    world->endTouch(*touch);
    const auto ears = rendered(*world, 64);
    CHECK(ears.energy(ears.left) == 0);
    CHECK(world->silent());
}

TEST_CASE("Rendering allocates nothing, whatever was said") {
    const auto world = worldOf(8);
    for (int round = 0; round < 20; ++round) {
        for (std::size_t body = 0; body < 8; ++body) {
            world->place(body, {.originMetres = {0.1 * round, 0, 0}});
            world->strike(hit(body, 0.001));
            world->setDamping(body, round);
        }
        if (const auto touch = world->beginTouch())
            world->touch(*touch,
                         {.other = 1, .forceNewtons = 1, .slideMetresPerSecond = {0.3, 0, 0}});
        world->placeListener({.positionMetres = {0, 0.1 * round, 1}});
        world->setSynthesis({.modeBudget = 100.0 + round, .radiation = 1});
        world->setMaterial(1, LiveMaterial{1e10 + round, 1000, {}});
        std::array<float, 200> left, right;
        const AllocationCounter counter;
        world->render(left, right);
        const long allocations = counter.allocations();
        CHECK(allocations == 0);
    }
}

TEST_CASE("One thread plays 64 bodies while another renders them") {
    const auto world = worldOf(64);
    std::atomic<bool> plays{true};
    std::thread game([&] {
        std::minstd_rand random(1);
        const auto number = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random() % 1000) / 1000;
        };
        int done = 0;
        while (done < 20000) {
            const std::size_t body = random() % 64;
            const auto answer =
                random() % 3 == 0
                    ? world->place(body, {.originMetres = {number(-3, 3), number(-3, 3), 0}})
                    : world->strike(hit(body, world->seconds() + number(0, 0.01)));
            done += answer == WorldAnswer::done ? 1 : 0;
            if (answer == WorldAnswer::busy)
                std::this_thread::yield();
        }
        plays = false;
    });
    bool isFinite = true;
    double energy = 0;
    while (plays) {
        const auto ears = rendered(*world, 256, 256);
        energy += ears.energy(ears.left);
        for (const float x : ears.left)
            isFinite = isFinite && std::isfinite(x);
    }
    game.join();
    CHECK(isFinite);
    CHECK(energy > 0);
}
