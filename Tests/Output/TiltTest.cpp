#include "Output/Tilt.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double rateHz = 48000;
constexpr int maximumBlock = 4096;

std::vector<float> sine(double hz, std::size_t count = 48000) {
    std::vector<float> samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = static_cast<float>(
            0.5 * std::sin(2 * std::numbers::pi * hz * static_cast<double>(i) / rateHz));
    return samples;
}

Tilt prepared() {
    Tilt tilt;
    tilt.prepare(rateHz, maximumBlock, 0.02);
    return tilt;
}

/// The left channel; the right one is silent and must remain so.
std::vector<float>
tilted(Tilt& tilt, const std::vector<float>& input, double brightness, std::size_t blockSize) {
    const std::vector<float> silence(input.size());
    std::vector<float> output;
    for (std::size_t start = 0; start < input.size(); start += blockSize) {
        const auto count = std::min(blockSize, input.size() - start);
        const auto sound = tilt.process(
            {std::span(input).subspan(start, count), std::span(silence).first(count)}, brightness);
        output.insert(output.end(), sound.left.begin(), sound.left.end());
        CHECK(std::ranges::all_of(sound.right, [](float sample) { return sample == 0; }));
    }
    return output;
}

double decibels(const std::vector<float>& output, const std::vector<float>& input) {
    const auto energy = [](const std::vector<float>& samples) {
        double sum = 0;
        for (std::size_t i = samples.size() / 2; i < samples.size(); ++i)
            sum += double{samples[i]} * samples[i];
        return sum;
    };
    return 10 * std::log10(energy(output) / energy(input));
}

/// The response of low/h + h·high with a filter of first order by the bilinear transform.
double expectedDecibels(double hz, double brightness) {
    const double gain = std::pow(10, Tilt::maximumDecibels * brightness / 100 / 20);
    const double ratio = std::tan(std::numbers::pi * hz / rateHz) /
                         std::tan(std::numbers::pi * Tilt::middleHz / rateHz);
    return 10 * std::log10((1 / gain / gain + gain * gain * ratio * ratio) / (1 + ratio * ratio));
}

} // namespace

TEST_CASE("A brightness of 0 returns the bits of the sound") {
    auto tilt = prepared();
    const auto input = sine(3000);
    CHECK(tilted(tilt, input, 0, 100) == input);
}

TEST_CASE("Brightness raises high frequencies and lowers low ones as its filter does") {
    for (const double brightness : {-100.0, -40.0, 60.0, 100.0})
        for (const double hz : {60.0, 500.0, 1000.0, 4000.0, 15000.0}) {
            auto tilt = prepared();
            const auto input = sine(hz);
            CHECK_THAT(decibels(tilted(tilt, input, brightness, 512), input),
                       WithinAbs(expectedDecibels(hz, brightness), 0.02));
        }
    CHECK_THAT(expectedDecibels(15000, 100), WithinAbs(9, 0.1));
}

TEST_CASE("The tilt does not depend on the block size, and a change has no step") {
    auto whole = prepared(), pieces = prepared();
    const std::vector<float> constant(4800, 0.5f);
    auto expected = tilted(whole, constant, -100, 4096);
    auto output = tilted(pieces, constant, -100, 7);
    const auto after = tilted(whole, constant, 100, 512);
    const auto ofPieces = tilted(pieces, constant, 100, 512);
    expected.insert(expected.end(), after.begin(), after.end());
    output.insert(output.end(), ofPieces.begin(), ofPieces.end());
    CHECK(output == expected);
    for (std::size_t i = 4800; i < output.size(); ++i)
        CHECK(std::abs(output[i] - output[i - 1]) < 0.01f);
    // Low frequencies fall from +9 to −9 dB.
    CHECK_THAT(output[4799] / output.back(), WithinAbs(std::pow(10, 18.0 / 20), 0.01));
}

TEST_CASE("A fading sound is tilted to the same bits in all blocks") {
    auto fading = sine(997);
    for (std::size_t i = 0; i < fading.size(); ++i)
        fading[i] *= std::exp2(-static_cast<float>(i) / 1500); // to −190 dB
    auto whole = prepared();
    const auto expected = tilted(whole, fading, 50, 4096);
    for (const std::size_t blockSize : {1, 7, 64}) {
        auto pieces = prepared();
        CHECK(tilted(pieces, fading, 50, blockSize) == expected);
    }
}
