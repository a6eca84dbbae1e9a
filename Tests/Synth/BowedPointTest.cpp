// Tests the friction of a bow: its bounds, its work, and when it makes a mode speak.
#include "Synth/BowedPoint.h"

#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <span>
#include <vector>

using namespace idiophone;
using Catch::Approx;

namespace {

constexpr double rateHz = 48000;
using Cell = std::array<float, cellSamples>;
constexpr Cell even{};

struct TestMode {
    double hz = 0;
    double decay = 0;    ///< [1/s]
    double mobility = 0; ///< [1/kg]
};

PointModes pointModes(std::span<const TestMode> modes) {
    PointModes result;
    for (const auto& [hz, decay, mobility] : modes) {
        const double omega = 2 * std::numbers::pi * hz;
        const auto rotation = std::exp(std::complex(-decay, omega) / rateHz);
        const std::size_t i = result.count++;
        result.numbers[i] = static_cast<std::int32_t>(i);
        result.rotationRe[i] = static_cast<float>(rotation.real());
        result.rotationIm[i] = static_cast<float>(rotation.imag());
        result.pushRe[i] = static_cast<float>(mobility);
        result.pushIm[i] = static_cast<float>(mobility * decay / omega);
        result.softestRadians = 2 * std::numbers::pi * modes.front().hz / rateHz;
    }
    return result;
}

/// The modes of a vibraphone's bar at its end.
PointModes bar() {
    return pointModes(std::array{TestMode{349, 0.8, 10}, TestMode{1396, 3, 10},
                                 TestMode{3200, 8, 10}, TestMode{5600, 14, 10}});
}

/// Returns the largest velocity of the point in the last tenth of some seconds of bowing.
double steadyVelocity(double speed, double pressure, double seconds = 3) {
    const auto modes = bar();
    BowedPoint bow(rateHz);
    Cell newtons;
    const auto cells = static_cast<int>(seconds * rateHz / cellSamples);
    double fastest = 0;
    for (int cell = 0; cell < cells; ++cell) {
        bow.render(modes, {speed, pressure}, even, newtons);
        if (cell > cells * 9 / 10)
            fastest = std::max(fastest, std::abs(bow.velocity()));
    }
    return fastest;
}

/// Plays the part of the modes: the energy in undamped modes after impulses.
class Energy {
public:
    explicit Energy(const PointModes& bowed) : modes(bowed) {}
    /// Moves by a sample and returns the velocity of the point before the force.
    void push(double newtons) {
        for (std::size_t i = 0; i < modes.count; ++i)
            states[i] = (states[i] + modes.pushRe[i] * newtons / rateHz) *
                        std::complex<double>(modes.rotationRe[i], modes.rotationIm[i]);
    }
    double joules() const {
        double sum = 0;
        for (std::size_t i = 0; i < modes.count; ++i)
            sum += std::norm(states[i]) / (2 * modes.pushRe[i]);
        return sum;
    }

private:
    const PointModes& modes;
    std::array<std::complex<double>, PointModes::capacity> states{};
};

} // namespace

TEST_CASE("A bow brings its place to its own speed") {
    for (const double speed : {0.05, 0.1, 0.3})
        CHECK(steadyVelocity(speed, 30 * speed) == Approx(1.2 * speed).epsilon(0.2));
}

TEST_CASE("Below its minimum force a note does not speak; a faster bow needs more") {
    double lastMinimum = 0;
    for (const double speed : {0.1, 0.2, 0.4}) {
        double minimum = 0.02;
        while (steadyVelocity(speed, minimum, 6) < speed / 2)
            minimum *= 1.3;
        INFO(speed << " m/s: " << minimum << " N");
        CHECK(minimum > 1.5 * lastMinimum);
        CHECK(minimum < 10 * speed);
        CHECK(steadyVelocity(speed, minimum / 2, 6) < speed / 10);
        lastMinimum = minimum;
    }
}

TEST_CASE("The touch of a bow excites modes at any frequency") {
    const double cellHz = rateHz / cellSamples;
    for (const double hz : {cellHz, 2 * cellHz, 3 * cellHz}) {
        const auto modes = pointModes(std::array{TestMode{hz, 1, 10}});
        BowedPoint bow(rateHz);
        Cell newtons;
        bow.render(modes, {0.2, 1}, even, newtons);
        double fastest = 0;
        for (int cell = 0; cell < 4; ++cell) {
            bow.render(modes, {0.2, 1}, even, newtons);
            fastest = std::max(fastest, std::abs(bow.velocity()));
        }
        CHECK(fastest > 0.05 * 10 / (2 * std::numbers::pi * hz));
    }
}

TEST_CASE("The force is at most the cold coefficient times the pressure, and 0 without pressure") {
    const auto modes = bar();
    BowedPoint bow(rateHz);
    Cell newtons;
    const auto largest = [&] {
        float found = 0;
        for (const float newton : newtons)
            found = std::max(found, std::abs(newton));
        return static_cast<double>(found);
    };
    CHECK_FALSE(bow.render(modes, {0.5, 0}, even, newtons));
    CHECK(largest() == 0);
    CHECK(bow.render(modes, {0.5, 4}, even, newtons));
    CHECK(largest() <= 4 * BowFriction::cold);
    CHECK(largest() >= 4 * BowFriction::hot);
    CHECK(bow.render(modes, {0.5, 0}, even, newtons));
    CHECK(newtons.back() == 0);
    CHECK_FALSE(bow.render(modes, {0.5, NAN}, even, newtons));
    CHECK(bow.velocity() != 0);
}

TEST_CASE("A bow that stands still only damps") {
    const auto modes = bar();
    BowedPoint bow(rateHz);
    Cell newtons;
    for (int cell = 0; cell < 1000; ++cell)
        bow.render(modes, {0.2, 5}, even, newtons);
    const double moving = std::abs(bow.velocity());
    for (int cell = 0; cell < 200; ++cell)
        bow.render(modes, {0, 5}, even, newtons);
    double fastest = 0;
    for (int cell = 0; cell < 50; ++cell) {
        bow.render(modes, {0, 5}, even, newtons);
        fastest = std::max(fastest, std::abs(bow.velocity()));
    }
    CHECK(moving > 1e-3);
    CHECK(fastest < 1e-3);
}

TEST_CASE("Modes never take more energy from a bow than it gives, whatever it does") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    for (int object = 0; object < 200; ++object) {
        std::vector<TestMode> free(1 + random() % PointModes::capacity);
        for (auto& mode : free)
            mode = {20 * std::pow(1000, share(random)), 0, std::pow(10, 4 * share(random) - 2)};
        const auto modes = pointModes(free);
        BowedPoint bow(rateHz);
        Energy energy(modes);
        double work = 0, lastSpeed = 0, lastPressure = 0;
        Cell newtons, uneven;
        for (int cell = 0; cell < 20; ++cell) {
            const double speed = std::pow(10, 4 * share(random) - 3);
            const double pressure = random() % 5 == 0 ? 0 : std::pow(10, 5 * share(random) - 2);
            for (float& value : uneven)
                value = static_cast<float>(4 * share(random) - 2);
            bow.render(modes, {speed, pressure}, uneven, newtons);
            const double from = lastPressure == 0 ? speed : lastSpeed;
            for (std::size_t n = 0; n < newtons.size(); ++n) {
                const double fraction = static_cast<double>(n + 1) / cellSamples;
                work += static_cast<double>(newtons[n]) * std::lerp(from, speed, fraction) / rateHz;
                energy.push(static_cast<double>(newtons[n]));
            }
            lastSpeed = speed;
            lastPressure = pressure;
            INFO("object " << object << ", cell " << cell << ": " << work << " J");
            REQUIRE(energy.joules() <= work * (1 + 1e-3) + 1e-9);
        }
    }
}

TEST_CASE("No setting of 20000 makes a bow run away") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    Cell newtons, uneven;
    for (int setting = 0; setting < 20000; ++setting) {
        std::vector<TestMode> some(1 + random() % PointModes::capacity);
        double perNewton = 0; // velocity
        for (auto& mode : some) {
            mode = {20 * std::pow(1000, share(random)), std::pow(10, 4 * share(random) - 1),
                    std::pow(10, 4 * share(random) - 2)};
            perNewton += mode.mobility / (2 * std::numbers::pi * mode.hz);
        }
        const auto modes = pointModes(some);
        const double speed = std::pow(10, 4 * share(random) - 3);
        const double pressure = std::pow(10, 5 * share(random) - 2);
        for (float& value : uneven)
            value = static_cast<float>(share(random) - 0.5);
        BowedPoint bow(rateHz);
        for (int cell = 0; cell < 8; ++cell)
            bow.render(modes, {speed, pressure}, uneven, newtons);
        const double velocity = std::abs(bow.velocity());
        INFO("setting " << setting << ": " << speed << " m/s, " << pressure << " N");
        REQUIRE(velocity < 5 * (speed + 1.2 * pressure * perNewton));
    }
}

TEST_CASE("Modes keep their motion when others join or leave") {
    std::vector<TestMode> all{{300, 1, 5}, {700, 2, 5}, {1500, 4, 5}};
    const auto three = pointModes(all);
    auto two = pointModes(std::span(all).last(2));
    two.numbers[0] = 1;
    two.numbers[1] = 2;
    BowedPoint bow(rateHz), same(rateHz);
    Cell newtons;
    for (auto* each : {&bow, &same}) {
        for (int cell = 0; cell < 500; ++cell)
            each->render(three, {0.2, 3}, even, newtons);
        each->render(three, {0.2, 0}, even, newtons);
    }
    bow.render(two, {0.2, 0}, even, newtons);
    same.render(three, {0.2, 0}, even, newtons);
    const double withoutFirst = bow.velocity();
    CHECK(withoutFirst != same.velocity());
    // The first mode begins at rest when it comes back, and the others have never stopped.
    bow.render(three, {0.2, 0}, even, newtons);
    BowedPoint further(rateHz);
    for (int cell = 0; cell < 500; ++cell)
        further.render(three, {0.2, 3}, even, newtons);
    further.render(three, {0.2, 0}, even, newtons);
    further.render(two, {0.2, 0}, even, newtons);
    further.render(two, {0.2, 0}, even, newtons);
    CHECK(bow.velocity() == further.velocity());
}
