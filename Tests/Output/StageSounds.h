// An output stage for tests, and sounds through it.
#pragma once

#include "Output/OutputStage.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace idiophone::test {

inline constexpr double rateHz = 48000;
inline constexpr int maximumBlock = 4096;

/// Switches the limiter off, so that the stage is linear.
inline ParameterValues valuesWith(double levelDecibels, bool bypassed = false) {
    ParameterValues values;
    values.set(ParameterId::level, levelDecibels);
    values.set(ParameterId::bypass, bypassed ? 1 : 0);
    values.set(ParameterId::limiter, 0);
    return values;
}

inline std::vector<float> sine(std::size_t count, double frequencyHz = 440) {
    std::vector<float> samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = static_cast<float>(
            std::sin(2 * std::numbers::pi * frequencyHz * static_cast<double>(i) / rateHz));
    return samples;
}

struct Stereo {
    std::vector<float> left, right;
    bool operator==(const Stereo&) const = default;
};

/// Processes two different channels in place, in blocks of one size.
inline Stereo processed(OutputStage& stage,
                        const Stereo& input,
                        std::size_t blockSize,
                        const ParameterValues& values) {
    Stereo output = input;
    for (std::size_t start = 0; start < input.left.size(); start += blockSize) {
        const auto count = std::min(blockSize, input.left.size() - start);
        const std::array<float*, 2> channels{&output.left[start], &output.right[start]};
        CHECK(stage.process({channels[0], count}, {channels[1], count}, channels, values));
    }
    return output;
}

/// Processes a mono sound in blocks of one size. Both output channels must agree.
inline std::vector<float> processed(OutputStage& stage,
                                    const std::vector<float>& input,
                                    std::size_t blockSize,
                                    const ParameterValues& values) {
    std::vector<float> left(input.size()), right(input.size());
    for (std::size_t start = 0; start < input.size(); start += blockSize) {
        const auto count = std::min(blockSize, input.size() - start);
        const std::array<float*, 2> channels{&left[start], &right[start]};
        const auto block = std::span(input).subspan(start, count);
        CHECK(stage.process(block, block, channels, values));
    }
    CHECK(left == right);
    return left;
}

struct PreparedStage : OutputStage {
    PreparedStage() { prepare(rateHz, maximumBlock); }
};

} // namespace idiophone::test
