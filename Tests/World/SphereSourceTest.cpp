// Tests distance, direction and air between a body and the ears of a spherical head.
#include "World/SphereSource.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <complex>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double rateHz = 48000;
const Listener listener{.positionMetres = {0, 0, 1.5}, .towardsMetres = {0, 1, 1.5}};
const Eigen::Vector3d ahead(0, 2, 1.5), left(-2, 0, 1.5), behind(0, -2, 1.5);

/// Returns the amplitude and phase of a tone at both ears once it has settled.
std::array<std::complex<double>, 2> heard(const Eigen::Vector3d& place, double frequencyHz) {
    const HeadModel head(listener);
    SphereSource source(rateHz);
    std::array<std::complex<double>, 2> sums{};
    const double omega = 2 * std::numbers::pi * frequencyHz / rateHz;
    constexpr int cells = 60, settled = 20;
    for (int cell = 0; cell < cells; ++cell) {
        alignas(64) std::array<float, cellSamples> sound, l{}, r{};
        for (std::size_t i = 0; i < cellSamples; ++i)
            sound[i] = static_cast<float>(
                std::cos(omega * static_cast<double>(cell * cellSamples + static_cast<int>(i))));
        source.add(sound, head.path(place), CellOutput(l, r));
        for (std::size_t i = 0; cell >= settled && i < cellSamples; ++i) {
            const auto turn =
                std::polar(2.0 / ((cells - settled) * cellSamples),
                           -omega * static_cast<double>(cell * cellSamples + static_cast<int>(i)));
            sums[0] += static_cast<double>(l[i]) * turn;
            sums[1] += static_cast<double>(r[i]) * turn;
        }
    }
    return sums;
}

double decibels(double ratio) {
    return 20 * std::log10(ratio);
}

} // namespace

TEST_CASE("Low tones fall with distance and are equally loud in both ears") {
    const auto near = heard({0, 1, 1.5}, 150), far = heard({0, 4, 1.5}, 150);
    CHECK_THAT(decibels(std::abs(near[0])), WithinAbs(0, 0.5));
    CHECK_THAT(decibels(std::abs(near[0]) / std::abs(far[0])), WithinAbs(12.04, 0.1));
    CHECK_THAT(decibels(std::abs(near[0]) / std::abs(near[1])), WithinAbs(0, 1e-3));
}

TEST_CASE("A source on the left is earlier and brighter in the left ear") {
    const auto low = heard(left, 300), high = heard(left, 6000);
    // Around a sphere, low tones are late by 3 a/c sin θ (Kuhn 1977): 0.77 ms.
    const double lateSeconds = std::arg(low[0] / low[1]) / (2 * std::numbers::pi * 300);
    CHECK_THAT(lateSeconds, WithinRel(0.77e-3, 0.1));
    CHECK(decibels(std::abs(high[0]) / std::abs(high[1])) > 10);
    CHECK(std::abs(decibels(std::abs(low[0]) / std::abs(low[1]))) < 4);
}

TEST_CASE("A source straight ahead or behind sounds the same in both ears") {
    for (const auto& place : {ahead, behind}) {
        const auto ears = heard(place, 8000);
        CHECK(std::abs(ears[0]) > 0.1);
        CHECK(std::abs(ears[0] - ears[1]) < 1e-4);
    }
}

TEST_CASE("Air absorbs 0.16 dB a metre at 10 kHz") {
    const auto near = heard({0, 1, 1.5}, 10000), far = heard({0, 51, 1.5}, 10000);
    CHECK_THAT(decibels(std::abs(near[0]) / std::abs(far[0])) - decibels(51), WithinAbs(8, 0.2));
}

TEST_CASE("A source that flies past does not bend a tone audibly or click") {
    const HeadModel head(listener);
    SphereSource source(rateHz);
    const double omega = 2 * std::numbers::pi * 500 / rateHz;
    double before[2] = {}, last[2] = {}, sharpest = 0;
    for (int cell = 0; cell < 750; ++cell) { // a second at 3 m/s
        alignas(64) std::array<float, cellSamples> sound, l{}, r{};
        for (std::size_t i = 0; i < cellSamples; ++i)
            sound[i] = static_cast<float>(
                std::cos(omega * static_cast<double>(cell * cellSamples + static_cast<int>(i))));
        source.add(sound, head.path({-1.5 + 3.0 * cell / 750, 0.5, 1.5}), CellOutput(l, r));
        for (std::size_t i = 0; i < cellSamples; ++i) {
            const double now[2] = {static_cast<double>(l[i]), static_cast<double>(r[i])};
            for (int ear = 0; ear < 2; ++ear) {
                if (cell > 2)
                    sharpest = std::max(sharpest, std::abs(now[ear] - 2 * last[ear] + before[ear]));
                before[ear] = last[ear];
                last[ear] = now[ear];
            }
        }
    }
    // The curvature of a tone is ω² times its amplitude: 2.4 at 0.5 m in front of an ear.
    CHECK(sharpest < 1.5 * 2.4 * omega * omega);
}

TEST_CASE("A source falls silent when the last of its sound has arrived") {
    const HeadModel head(listener);
    SphereSource source(rateHz);
    CHECK(source.silent());
    alignas(64) std::array<float, cellSamples> sound{}, l{}, r{};
    sound[0] = 1;
    source.add(sound, head.path(left), CellOutput(l, r));
    CHECK_FALSE(source.silent());
    sound[0] = 0;
    double late = 0;
    for (int cell = 0; cell < 10 && !source.silent(); ++cell) {
        r.fill(0);
        source.add(sound, head.path(left), CellOutput(l, r));
        late = std::max<double>(late, *std::ranges::max_element(r));
    }
    CHECK(source.silent());
    CHECK(late > 0);
}
