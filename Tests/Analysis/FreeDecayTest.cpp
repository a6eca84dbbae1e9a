#include "Analysis/FreeDecay.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace idiophone;

namespace {

constexpr double rate = 48000;

/// Adds a strike of a plate-like sound at a sample.
void strike(std::vector<float>& samples, std::size_t at, double gain) {
    for (std::size_t n = at; n < samples.size(); ++n) {
        const double t = static_cast<double>(n - at) / rate;
        for (const double hz : {210.0, 540.0, 1130.0, 3300.0, 6100.0})
            samples[n] += static_cast<float>(0.2 * gain * std::exp(-(3 + hz / 100) * t) *
                                             std::cos(2 * std::numbers::pi * hz * t));
    }
}

std::size_t apart(std::size_t a, std::size_t b) {
    return a > b ? a - b : b - a;
}

} // namespace

TEST_CASE("The onset is found within half a millisecond under noise at -60 dB") {
    for (const std::size_t at : {std::size_t{0}, std::size_t{777}, std::size_t{30000}}) {
        std::vector<float> samples(72000);
        strike(samples, at, 0.8);
        std::mt19937 random(1);
        std::normal_distribution<float> hiss(0, 8e-4f);
        for (float& sample : samples)
            sample += hiss(random);
        const auto decay = findFreeDecay(samples, rate);
        REQUIRE(decay);
        CAPTURE(at, decay->onset);
        CHECK(apart(decay->onset, at) < 24);
        CHECK(decay->begin > decay->onset);
        CHECK(decay->begin < at + 500);
        CHECK(decay->end == samples.size());
        CHECK_FALSE(decay->others);
        CHECK_FALSE(decay->clipped);
    }
}

TEST_CASE("The strongest of three strikes is used, up to the next one") {
    std::vector<float> samples(144000);
    strike(samples, 10000, 0.3);
    strike(samples, 60000, 0.8);
    strike(samples, 110000, 0.5);
    const auto decay = findFreeDecay(samples, rate);
    REQUIRE(decay);
    CHECK(apart(decay->onset, 60000) < 24);
    CHECK(apart(decay->end, 110000) < 300);
    CHECK(decay->end <= 110000);
    CHECK(decay->others);
}

TEST_CASE("A given contact time sets the start of the free decay") {
    std::vector<float> samples(48000);
    strike(samples, 1000, 0.8);
    const auto decay = findFreeDecay(samples, rate, 0.003);
    REQUIRE(decay);
    CHECK(decay->begin == decay->onset + 144);
}

TEST_CASE("A strike clipped at full scale is detected") {
    std::vector<float> samples(48000);
    strike(samples, 1000, 3);
    for (float& sample : samples)
        sample = std::clamp(sample, -1.0f, 1.0f);
    const auto decay = findFreeDecay(samples, rate);
    REQUIRE(decay);
    CHECK(decay->clipped);
}

TEST_CASE("A clipped strike that was attenuated later is detected") {
    std::vector<float> samples(48000);
    strike(samples, 1000, 3);
    for (float& sample : samples)
        sample = std::round(0.1f * std::clamp(sample, -1.0f, 1.0f) * 32767) / 32767;
    const auto decay = findFreeDecay(samples, rate);
    REQUIRE(decay);
    CHECK(decay->clipped);
}

TEST_CASE("Flat tops from 16-bit quantisation of a quiet low tone do not count as clipping") {
    for (const double level : {0.002, 0.02, 0.2}) {
        std::vector<float> samples(48000);
        for (std::size_t i = 1000; i < samples.size(); ++i) {
            const double t = static_cast<double>(i - 1000) / rate;
            samples[i] = static_cast<float>(std::round(32767 * level * std::exp(-3 * t) *
                                                       std::sin(2 * std::numbers::pi * 60 * t)) /
                                            32767);
        }
        const auto decay = findFreeDecay(samples, rate);
        REQUIRE(decay);
        CAPTURE(level);
        CHECK_FALSE(decay->clipped);
    }
}
