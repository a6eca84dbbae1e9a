#include "Output/Limiter.h"

#include "Output/OversampledPeak.h"
#include "Output/StageSounds.h"

#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>
#include <random>
#include <utility>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double bound = -0.3; ///< dBTP
const float threshold = Limiter::threshold;

Stereo limited(Limiter& limiter, Stereo sound, std::size_t blockSize = 4096, bool isOn = true) {
    for (std::size_t start = 0; start < sound.left.size(); start += blockSize) {
        const std::array<float*, 2> channels{&sound.left[start], &sound.right[start]};
        limiter.process(channels, std::min(blockSize, sound.left.size() - start), isOn);
    }
    return sound;
}

Limiter preparedLimiter(double sampleRateHz = rateHz) {
    Limiter limiter;
    limiter.prepare(sampleRateHz, 0.02);
    return limiter;
}

std::vector<float> limited(const std::vector<float>& sound) {
    auto limiter = preparedLimiter();
    return limited(limiter, {sound, sound}).left;
}

std::vector<float> scaled(std::vector<float> sound, double decibels) {
    for (float& sample : sound)
        sample *= static_cast<float>(std::pow(10, decibels / 20));
    return sound;
}

/// Returns ten keys of four partials each that start at the same sample, like struck bars.
std::vector<float> chord(unsigned seed, double highestHz, std::size_t count = 12000) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(std::log(200.0), std::log(highestHz)),
        decay(0.01, 0.1);
    std::vector<double> sum(count);
    for (int partial = 0; partial < 40; ++partial) {
        const double turn = 2 * std::numbers::pi * std::exp(place(random)) / rateHz;
        const double seconds = decay(random);
        for (std::size_t i = 100; i < count; ++i) {
            const auto time = static_cast<double>(i - 100);
            sum[i] += std::min(1.0, time / 20) * std::exp(-time / rateHz / seconds) *
                      std::sin(turn * time);
        }
    }
    return {sum.begin(), sum.end()};
}

std::vector<float> noise(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    std::vector<float> samples(count);
    std::ranges::generate(samples, [&] { return normal(random); });
    return samples;
}

/// Scales a sound to a true peak in decibels.
std::vector<float> atPeak(const std::vector<float>& sound, double decibels) {
    return scaled(sound, decibels - decibelsTruePeak(sound));
}

} // namespace

TEST_CASE("Sound with a true peak below -1 dBFS passes the limiter bit for bit") {
    const unsigned seed = GENERATE(range(1u, 11u));
    CAPTURE(seed);
    const auto passes = [](const std::vector<float>& sound) {
        const auto quiet = atPeak(sound, -1.01);
        auto limiter = preparedLimiter();
        const bool same = limited(limiter, {quiet, quiet}).left == quiet;
        return same;
    };
    CHECK(passes(chord(seed, 6000)));
    CHECK(passes(chord(seed, 18000)));
    CHECK(passes(noise(seed, 10000)));
    CHECK(passes(sine(10000, 30.0 * seed)));
    CHECK(passes(sine(10000, 1000.0 * seed)));
}

TEST_CASE("A chord of ten keys stays below -0.3 dBTP at any level") {
    const unsigned seed = GENERATE(range(1u, 13u));
    const double highestHz = GENERATE(2000.0, 6000.0, 18000.0);
    const auto sound = chord(seed, highestHz);
    for (const double peak : {-0.9, -0.5, 0.0, 1.0, 3.0, 6.0, 12.0, 24.0}) {
        CAPTURE(peak);
        CHECK(decibelsTruePeak(limited(atPeak(sound, peak))) <= bound);
    }
}

TEST_CASE("Impulses, square waves and low-passed noise stay below -0.3 dBTP") {
    const double decibels = GENERATE(-0.9, 0.0, 1.0, 3.0, 6.0, 12.0, 24.0, 60.0);
    CAPTURE(decibels);
    std::vector<float> impulse(300), pair = impulse, step = impulse;
    impulse[100] = pair[100] = pair[101] = 1;
    std::fill(step.begin() + 100, step.begin() + 200, 1.0f);
    for (const auto& sound : {impulse, pair, step})
        CHECK(decibelsTruePeak(limited(scaled(sound, decibels))) <= bound);
    for (const int halfPeriod : {1, 2, 3, 4, 7, 50, 441}) {
        CAPTURE(halfPeriod);
        std::vector<float> square(3000);
        for (std::size_t i = 100; i < 2900; ++i)
            square[i] = (static_cast<int>(i) / halfPeriod) % 2 == 0 ? 1.0f : -1.0f;
        CHECK(decibelsTruePeak(limited(scaled(square, decibels))) <= bound);
    }
    auto dull = noise(5, 20000);
    float first = 0, second = 0;
    for (float& sample : dull) {
        first += 0.3f * (sample - first);
        second += 0.3f * (first - second);
        sample = second;
    }
    CHECK(decibelsTruePeak(limited(atPeak(dull, decibels))) <= bound);
}

TEST_CASE("A slowly rising sine stays below -0.3 dBTP, or -0.15 dBTP above an eighth of the rate") {
    const double frequency = GENERATE(0.01, 0.05, 0.1, 0.125, 0.2, 0.25, 0.3, 0.4);
    const double decibels = GENERATE(-0.5, 0.0, 1.0, 2.0, 3.0, 6.0, 12.0, 24.0);
    for (int phase = 0; phase < 8; ++phase) {
        CAPTURE(frequency, decibels, phase);
        std::vector<float> sound(2500);
        for (std::size_t i = 0; i < sound.size(); ++i) {
            const double time = static_cast<double>(i);
            const double swell = std::clamp(std::min(time, 2499 - time) / 600, 0.0, 1.0);
            sound[i] = static_cast<float>(
                swell * std::sin(2 * std::numbers::pi * (frequency * time + phase / 16.0)));
        }
        CHECK(decibelsTruePeak(limited(scaled(sound, decibels))) <=
              (frequency <= 0.125 ? bound : -0.15));
    }
}

TEST_CASE(
    "A sine starting at full level stays below -0.3 dBTP, or 0.4 above an eighth of the rate") {
    const double frequency = GENERATE(0.01, 0.05, 0.1, 0.125, 0.2, 0.25, 0.3, 0.4);
    const double decibels = GENERATE(-0.5, 0.0, 1.0, 2.0, 3.0, 6.0, 12.0, 24.0);
    for (int phase = 0; phase < 16; ++phase) {
        CAPTURE(frequency, decibels, phase);
        std::vector<float> sound(1200);
        for (std::size_t i = 100; i < 1100; ++i)
            sound[i] = static_cast<float>(std::sin(
                2 * std::numbers::pi * (frequency * static_cast<double>(i - 100) + phase / 16.0)));
        CHECK(decibelsTruePeak(limited(scaled(sound, decibels))) <=
              (frequency <= 0.125 ? bound : 0.4));
    }
}

TEST_CASE("Once the limiter acts, its output stays below -0.3 dBTP for any input") {
    auto limiter = preparedLimiter();
    auto sound = scaled(noise(GENERATE(range(1u, 6u)), 20000), 12);
    sound[0] = 10;
    std::fill(sound.begin() + 10000, sound.begin() + 10400, 3.0f); // stops within a sample
    std::fill(sound.begin() + 10400, sound.begin() + 10500, 0.0f);
    CHECK(decibelsTruePeak(limited(limiter, {sound, sound}).left) <= bound);
}

TEST_CASE("The gain is at most 7.1 dB lower than needed to bring a peak to the threshold") {
    const double decibels = GENERATE(-0.6, 0.0, 3.0, 12.0, 24.0);
    for (const auto& sound : {chord(1, 6000), chord(2, 18000), sine(9600, 100), sine(9600, 1000),
                              sine(9600, 7000), noise(3, 9600)}) {
        const auto loud = atPeak(sound, decibels);
        const auto heard = limited(loud);
        float lowestGain = 1;
        for (std::size_t i = 0; i < loud.size(); ++i)
            if (std::abs(loud[i]) > 1e-3f) // rounding matters below
                lowestGain = std::min(lowestGain, heard[i] / loud[i]);
        CHECK(20 * std::log10(lowestGain) >= -1 - decibels - 7.1);
    }
}

TEST_CASE("Both channels get the gain of the louder one") {
    auto limiter = preparedLimiter();
    const Stereo sound{scaled(sine(4800, 300), 12), scaled(sine(4800, 500), -20)};
    const auto heard = limited(limiter, sound);
    std::size_t reduced = 0;
    for (std::size_t i = 0; i < sound.left.size(); ++i) {
        if (std::abs(sound.left[i]) < 0.01f || std::abs(sound.right[i]) < 0.01f)
            continue;
        const float gain = heard.left[i] / sound.left[i];
        CHECK_THAT(heard.right[i] / sound.right[i], WithinAbs(gain, 1e-5));
        reduced += gain < 0.9f;
    }
    CHECK(reduced > 3000);
}

TEST_CASE("The gain returns smoothly, and after 0.3 s every bit passes again") {
    auto limiter = preparedLimiter();
    const auto loud = scaled(sine(4800, 300), 24), soft = scaled(sine(24000, 250), -12);
    limited(limiter, {loud, loud});
    const auto heard = limited(limiter, {soft, soft});
    float last = 0;
    for (std::size_t i = 0; i < soft.size(); ++i) {
        if (std::abs(soft[i]) < 0.05f)
            continue;
        const float gain = heard.left[i] / soft[i];
        if (last > 0)
            REQUIRE(gain <= last * std::pow(10.0f, 120.0f / 20 / 48000 * 120) + 1e-5f);
        last = gain;
    }
    const auto returned = static_cast<std::size_t>(0.3 * rateHz);
    CHECK(heard.left[10] != soft[10]);
    CHECK(std::equal(soft.begin() + returned, soft.end(), heard.left.begin() + returned));
}

TEST_CASE("The limiter's output does not depend on the block size") {
    Stereo sound{chord(3, 8000), chord(4, 8000)};
    sound.left.insert(sound.left.end(), sound.left.begin(), sound.left.end());
    sound.right.insert(sound.right.end(), sound.right.begin(), sound.right.end());
    auto whole = preparedLimiter();
    const auto expected = limited(whole, sound);
    CHECK(expected != sound);
    for (const std::size_t blockSize : {1u, 7u, 64u, 480u}) {
        auto limiter = preparedLimiter();
        CHECK(limited(limiter, sound, blockSize) == expected);
    }
}

TEST_CASE("A limiter switched while it acts moves its gain over the ramp") {
    const auto loud = std::vector<float>(4800, 4.0f);
    auto limiter = preparedLimiter();
    const float on = limited(limiter, {loud, loud}).left.back();
    CHECK(on < 1);
    const auto off = limited(limiter, {loud, loud}, 4096, false).left;
    const auto again = limited(limiter, {loud, loud}).left;
    CHECK(off.back() == 4);
    CHECK(again.back() < 1);
    float last = on;
    for (const auto& part : {off, again})
        for (const float sample : part) {
            REQUIRE(std::abs(sample - last) <= 1.1f * 4 / (0.02f * 48000));
            last = sample;
        }
    auto never = preparedLimiter();
    CHECK(limited(never, {loud, loud}, 480, false).left == loud);
}

TEST_CASE("One huge sample silences the sound for at most 0.4 s") {
    auto limiter = preparedLimiter();
    const std::vector<float> enormous{std::numeric_limits<float>::max()};
    const auto heard = limited(limiter, {enormous, enormous});
    CHECK(heard.left.front() <= threshold);
    CHECK(heard.left.front() >= 0);
    const auto soft = scaled(sine(48000), -6);
    const auto after = limited(limiter, {soft, soft}).left;
    const auto returned = static_cast<std::size_t>(0.4 * rateHz);
    CHECK(std::equal(soft.begin() + returned, soft.end(), after.begin() + returned));
}
