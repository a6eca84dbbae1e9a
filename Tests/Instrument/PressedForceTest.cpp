#include "Instrument/PressedForce.h"

#include "Synth/SharedSurfaceProfile.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;

namespace {

constexpr double rateHz = 48000;
constexpr ContactMotion scrape{.speedMetresPerSecond = 0.2, .normalForceNewtons = 1};
using Cell = std::array<float, cellSamples>;

PressedForce begun() {
    PressedForce force(sharedSurfaceProfile({}, rateHz), 3);
    force.begin();
    return force;
}

Cell cellOf(PressedForce& force, double gain) {
    Cell newtons{};
    CHECK(force.render(scrape, gain, newtons));
    return newtons;
}

bool near(float a, float b) {
    return std::abs(a - b) <= 1e-6f * std::max(std::abs(a), 1.0f);
}

} // namespace

TEST_CASE("A new contact has its gain from the first sample on") {
    auto force = begun(), twice = begun();
    const Cell once = cellOf(force, 1), doubled = cellOf(twice, 2);
    CHECK(std::ranges::any_of(once, [](float newton) { return newton != 0; }));
    for (std::size_t i = 0; i < cellSamples; ++i)
        CHECK(near(doubled[i], 2 * once[i]));
}

TEST_CASE("The gain of a pressed force moves on a line from cell to cell") {
    auto force = begun(), steady = begun();
    CHECK(cellOf(force, 1) == cellOf(steady, 1));
    const Cell rising = cellOf(force, 3), reference = cellOf(steady, 1);
    for (std::size_t i = 0; i < cellSamples; ++i)
        CHECK(near(rising[i], reference[i] * (1 + 2 * static_cast<float>(i + 1) / cellSamples)));
}

TEST_CASE("A released force fades to zero within its time and ends") {
    auto force = begun(), held = begun();
    force.release();
    CHECK(force.isActive());
    CHECK_FALSE(force.isHeld());
    // The wait for a grid point takes up to a cell of the time.
    const int cells = static_cast<int>(PressedForce::fadeSeconds * rateHz) / cellSamples;
    double last = 1;
    Cell newtons{}, reference{};
    for (int cell = 0; cell < cells; ++cell) {
        CHECK(force.isActive());
        newtons = cellOf(force, 1);
        reference = cellOf(held, 1);
        CHECK(force.fade() < last);
        last = force.fade();
        for (std::size_t i = 0; i < cellSamples; ++i)
            CHECK(std::abs(newtons[i]) <= std::abs(reference[i]));
    }
    CHECK_FALSE(force.isActive());
    CHECK(newtons.back() == 0);
    CHECK(held.isHeld());
}

TEST_CASE("A force that ends at once begins again with its full gain") {
    auto force = begun(), fresh = begun();
    const Cell first = cellOf(force, 0.5);
    force.end();
    CHECK_FALSE(force.isActive());
    CHECK(force.fade() == 0);
    force.begin();
    CHECK(force.begins());
    CHECK(cellOf(force, 0.5) == first);
    CHECK_FALSE(force.begins());
    CHECK(cellOf(fresh, 0.5) == first);
}
