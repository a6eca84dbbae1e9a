#include "Output/DryWet.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <numeric>
#include <vector>

using namespace idiophone;

namespace {

constexpr double rateHz = 48000, rampSeconds = 0.02;

ParameterValues mixed(double percent) {
    ParameterValues values;
    values.set(ParameterId::dryWet, percent);
    return values;
}

/// Mixes a dry sound of 1 into a wet one of 0, as if each block had its own values.
std::vector<float>
dryShares(DryWet& mix, const std::vector<ParameterValues>& values, std::size_t blockSize) {
    std::vector<float> result;
    for (const auto& block : values) {
        const std::vector<float> dry(blockSize, 1);
        std::vector<float> wet(blockSize, 0);
        float* channel = wet.data();
        const std::array<std::span<const float>, 1> heard{dry};
        mix.process(heard, {&channel, 1}, block);
        result.insert(result.end(), wet.begin(), wet.end());
    }
    return result;
}

} // namespace

TEST_CASE("Dry and wet add up, and the first block has its mix at once") {
    DryWet mix;
    mix.prepare(rateHz, rampSeconds);
    CHECK(dryShares(mix, {mixed(25)}, 10) == std::vector<float>(10, 0.75f));
    mix.reset();
    CHECK(dryShares(mix, {mixed(100)}, 10) == std::vector<float>(10, 0.0f));
    mix.reset();
    auto bypassed = mixed(100);
    bypassed.set(ParameterId::bypass, 1);
    CHECK(dryShares(mix, {bypassed}, 10) == std::vector<float>(10, 1.0f));
}

TEST_CASE("A change of the mix is a ramp that does not depend on blocks") {
    DryWet whole, parts;
    for (DryWet* mix : {&whole, &parts}) {
        mix->prepare(rateHz, rampSeconds);
        dryShares(*mix, {mixed(0)}, 1);
    }
    const auto ramp = dryShares(whole, {mixed(100)}, 1200);
    CHECK(dryShares(parts, std::vector(12, mixed(100)), 100) == ramp);
    CHECK(ramp.front() > 0.99f);
    CHECK(std::abs(ramp[480] - 0.5f) < 0.01f);
    CHECK(ramp.back() == 0.0f);
}

TEST_CASE("Each channel keeps its own dry sound; mono goes to both") {
    DryWet mix;
    mix.prepare(rateHz, rampSeconds);
    const std::array<float, 2> left{1, 2}, right{3, 4};
    std::array<float, 2> wetLeft{}, wetRight{};
    const std::array<float*, 2> channels{wetLeft.data(), wetRight.data()};
    const std::array<std::span<const float>, 2> both{left, right};
    mix.process(both, channels, mixed(0));
    CHECK(wetLeft == left);
    CHECK(wetRight == right);
    mix.process(std::span(both).first(1), channels, mixed(0));
    CHECK(wetRight == left);
    wetLeft = right;
    mix.process({}, channels, mixed(0)); // without input nothing changes
    CHECK(wetLeft == right);
}
