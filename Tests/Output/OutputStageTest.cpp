#include "Output/StageSounds.h"

#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

ParameterValues valuesWithWidth(double percent) {
    auto values = valuesWith(0);
    values.set(ParameterId::width, percent);
    return values;
}

} // namespace

TEST_CASE("At 0 dB a mono sound passes bit for bit at any width") {
    PreparedStage stage;
    const auto input = sine(1000);
    CHECK(processed(stage, input, 100, valuesWith(0)) == input);
    CHECK(processed(stage, input, 100, valuesWithWidth(200)) == input);
}

TEST_CASE("Width 100 changes nothing, 0 gives both channels the mid, and 200 doubles the side") {
    const Stereo input{sine(3000), sine(3000, 700)};
    const auto at = [&](double percent) {
        PreparedStage stage;
        return processed(stage, input, 480, valuesWithWidth(percent));
    };
    const auto unchanged = at(100), narrow = at(0), wide = at(200);
    CHECK(narrow.left == narrow.right);
    CHECK(wide.left != wide.right);
    for (std::size_t i = 0; i < input.left.size(); ++i) {
        const float l = input.left[i], r = input.right[i];
        CHECK_THAT(unchanged.left[i], WithinAbs(l, 2e-7));
        CHECK_THAT(unchanged.right[i], WithinAbs(r, 2e-7));
        CHECK(narrow.left[i] == (l + r) / 2);
        CHECK_THAT((wide.left[i] + wide.right[i]) / 2, WithinAbs((l + r) / 2, 3e-7));
        CHECK_THAT(wide.left[i] - wide.right[i], WithinAbs(2 * (l - r), 6e-7));
    }
}

TEST_CASE("A mono output gets the mid at any width") {
    const auto left = sine(1000), right = sine(1000, 700);
    for (const double percent : {0.0, 100.0, 200.0}) {
        PreparedStage stage;
        std::vector<float> output(left.size());
        const std::array<float*, 1> channels{output.data()};
        stage.process(left, right, channels, valuesWithWidth(percent));
        for (std::size_t i = 0; i < output.size(); ++i)
            CHECK(output[i] == (left[i] + right[i]) / 2);
    }
}

TEST_CASE("Automated width moves the side without steps, for all block sizes") {
    const Stereo ones{std::vector<float>(64, 1.0f), std::vector<float>(64, -1.0f)};
    PreparedStage stage, pieces;
    auto last = processed(stage, ones, 64, valuesWithWidth(0)).left.back();
    processed(pieces, ones, 64, valuesWithWidth(0));
    CHECK(last == 0);
    const float largest = static_cast<float>(1.01 * 2 / (OutputStage::rampSeconds * rateHz));
    for (int block = 0; block < 100; ++block) {
        const auto values = valuesWithWidth(block % 30 < 15 ? 200 : 0);
        const auto output = processed(stage, ones, 64, values);
        CHECK(processed(pieces, ones, 7, values) == output);
        for (const float sample : output.left) {
            REQUIRE(std::abs(sample - last) <= largest);
            last = sample;
        }
        if (block == 14)
            CHECK(last > 1.9f);
    }
}

TEST_CASE("The level is a gain of 10^(dB/20) from the first sample after a reset") {
    PreparedStage stage;
    const std::vector<float> input(100, 1.0f);
    for (const double decibels : {-60.0, -20.0, 6.0, 24.0}) {
        stage.reset();
        const auto output = processed(stage, input, 100, valuesWith(decibels));
        for (const float sample : output)
            CHECK_THAT(sample, WithinRel(std::pow(10, decibels / 20), 1e-6));
    }
}

TEST_CASE("A value that differs by rounding from an earlier one applies to the last bit") {
    using enum ParameterId;
    const Stereo input{sine(3000), sine(3000, 700)};
    for (const auto parameter : {level, width, brightness, room}) {
        auto values = valuesWith(-13.7);
        values.set(room, 20);
        values.set(brightness, 30);
        values.set(parameter, 17.3);
        for (double step = 1e-9; step < 1e-5; step *= 2) {
            auto before = values;
            before.set(parameter, values[parameter] * (1 + step));
            PreparedStage played, fresh;
            processed(played, input, 100, before);
            played.reset();
            INFO(parameterInfo(parameter).name << ", step " << step);
            REQUIRE(processed(played, input, 100, values) == processed(fresh, input, 100, values));
        }
    }
}

TEST_CASE("Volume adds to the preset's level") {
    const auto input = sine(1000);
    for (const double decibels : {-20.0, 6.0}) {
        PreparedStage together, level;
        auto values = valuesWith(-12);
        values.set(ParameterId::volume, decibels);
        CHECK(processed(together, input, 100, values) ==
              processed(level, input, 100, valuesWith(-12 + decibels)));
    }
}

TEST_CASE("From the lowest level and volume the sound comes back") {
    PreparedStage stage;
    const auto input = sine(4800);
    auto lowest = valuesWith(-60);
    lowest.set(ParameterId::volume, -60);
    processed(stage, input, 100, lowest);
    stage.changeSound(lowest);
    processed(stage, input, 100, lowest);
    stage.changeSound(valuesWith(0));
    processed(stage, input, 100, valuesWith(0));
    const auto output = processed(stage, input, 100, valuesWith(0));
    for (std::size_t i = 0; i < input.size(); ++i)
        CHECK_THAT(output[i], WithinAbs(input[i], 1e-4));
}

TEST_CASE("At constant parameters the output does not depend on the block size") {
    const auto input = sine(10000);
    PreparedStage whole;
    const auto expected = processed(whole, input, maximumBlock, valuesWith(-7.3));
    for (const std::size_t blockSize : {1u, 7u, 64u, 480u}) {
        PreparedStage stage;
        CHECK(processed(stage, input, blockSize, valuesWith(-7.3)) == expected);
    }
}

TEST_CASE("The ramp of a level change does not depend on the blocks that follow") {
    const auto input = sine(4000);
    PreparedStage whole;
    processed(whole, input, 4000, valuesWith(0));
    const auto expected = processed(whole, input, 4000, valuesWith(-12));
    PreparedStage pieces;
    processed(pieces, input, 4000, valuesWith(0));
    CHECK(processed(pieces, input, 7, valuesWith(-12)) == expected);
}

TEST_CASE("Automated level moves the gain without steps") {
    PreparedStage stage;
    const std::vector<float> ones(64, 1.0f);
    std::vector<float> output = processed(stage, ones, 64, valuesWith(-60));
    for (int block = 0; block < 200; ++block) {
        const auto next = processed(stage, ones, 64, valuesWith(block % 2 == 0 ? 0 : -60));
        output.insert(output.end(), next.begin(), next.end());
    }
    // The maximum step is that of a ramp over the whole range.
    const float largest = static_cast<float>(1 / (OutputStage::rampSeconds * rateHz)) + 1e-6f;
    for (std::size_t i = 1; i < output.size(); ++i)
        CHECK(std::abs(output[i] - output[i - 1]) <= largest);
}

TEST_CASE("Bypass is silent after its ramp, and its end restores the level") {
    PreparedStage stage;
    const std::vector<float> ones(2000, 1.0f);
    processed(stage, ones, 2000, valuesWith(0));
    const auto off = processed(stage, ones, 2000, valuesWith(0, true));
    CHECK(off.front() > 0.99f);
    const auto rampSamples = static_cast<std::size_t>(OutputStage::rampSeconds * rateHz);
    for (std::size_t i = rampSamples; i < off.size(); ++i)
        CHECK(off[i] == 0.0f);
    const auto on = processed(stage, ones, 2000, valuesWith(0));
    CHECK(on.front() < 0.01f);
    CHECK(on.back() == 1.0f);
}

TEST_CASE("A block that is not finite is silent, and the stage is reset after it") {
    const float bad =
        GENERATE(std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                 -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::max());
    const bool onBothSides = GENERATE(true, false);
    auto values = valuesWith(24);
    values.set(ParameterId::room, GENERATE(0.0, 50.0));
    values.set(ParameterId::roomDecay, 10);
    PreparedStage stage;
    const Stereo input{sine(48'000), sine(48'000, 700)};
    processed(stage, input, 480, values); // fills the room

    std::vector<float> left(480, 0.5f), right = left;
    left[100] = bad;
    if (onBothSides)
        right[100] = bad;
    const std::array<float*, 2> channels{left.data(), right.data()};
    CHECK_FALSE(stage.process(left, right, channels, values));
    CHECK(left == std::vector<float>(480));
    CHECK(right == left);
    CHECK(stage.silent());

    PreparedStage fresh;
    const bool same = processed(stage, input, 480, values) == processed(fresh, input, 480, values);
    CHECK(same);
}

TEST_CASE("Every output channel is checked for finite samples") {
    const std::array bad{std::numeric_limits<float>::quiet_NaN(), -1.0f};
    const std::array good{0.5f, std::numeric_limits<float>::denorm_min()};
    std::array<float, 2> first{}, second{};
    const std::array<float*, 2> channels{first.data(), second.data()};
    PreparedStage stage;
    CHECK(stage.process(good, good, channels, valuesWith(0)));
    CHECK_FALSE(stage.process(bad, good, channels, valuesWith(0)));
    CHECK_FALSE(stage.process(good, bad, channels, valuesWith(0)));
    CHECK_FALSE(stage.process(good, bad, std::span(channels).first(1), valuesWith(0)));
    CHECK(stage.process({}, {}, {}, valuesWith(0)));
}

TEST_CASE("A single channel that is also the input is processed in place") {
    PreparedStage stage;
    auto samples = sine(500);
    const auto original = samples;
    const std::array<float*, 1> channels{samples.data()};
    stage.process(samples, samples, channels, valuesWith(-20));
    for (std::size_t i = 0; i < samples.size(); ++i)
        CHECK_THAT(samples[i], WithinAbs(original[i] * 0.1, 1e-7));
}

TEST_CASE("A block without samples or channels is ignored") {
    PreparedStage stage;
    const auto input = sine(10);
    stage.process({}, {}, {}, valuesWith(0));
    stage.process(input, input, {}, valuesWith(0));
    CHECK(processed(stage, input, 10, valuesWith(0)) == input);
}

TEST_CASE("A stage that skips silence goes on as one that has processed it") {
    auto values = valuesWithWidth(120);
    values.set(ParameterId::room, 30);
    values.set(ParameterId::roomDecay, 0.4);
    values.set(ParameterId::brightness, 40);
    const Stereo silence{std::vector<float>(1000), std::vector<float>(1000)};
    PreparedStage skipping, processing;
    skipping.hush(1200);
    processing.hush(1200);
    skipping.skip(300);
    skipping.skip(700);
    processed(processing, silence, 100, values);
    for (int block = 0; block < 50; ++block) { // until the reverb ends at a point of its grid
        const auto input = block == 0 ? Stereo{sine(1000), sine(1000, 700)} : silence;
        REQUIRE(processed(skipping, input, 100, values) ==
                processed(processing, input, 100, values));
    }
    CHECK(skipping.silent());
    CHECK(processing.silent());
}
