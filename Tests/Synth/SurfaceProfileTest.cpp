#include "Synth/SurfaceProfile.h"

#include "Support/Periodogram.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double rateHz = 48000;
constexpr auto period = static_cast<double>(SurfaceProfile::periodSamples);

/// Reads the profile at a fraction of the reference speed, from `start` on, periodically.
std::vector<float>
readAt(const SurfaceProfile& profile, double speedRatio, std::size_t count, double start = 0) {
    std::vector<float> result(count);
    for (std::size_t i = 0; i < count; ++i)
        result[i] = static_cast<float>(
            profile.at(std::fmod(start + static_cast<double>(i) * speedRatio, period)));
    return result;
}

/// Returns the slope of log power density over log frequency, by least squares on third octaves.
double spectralSlope(const Periodogram& spectrum, double lowHz, double highHz) {
    double n = 0, sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
    for (double centre = lowHz * 1.13; centre * 1.13 < highHz; centre *= 1.26) {
        const double width = centre * (1.1225 - 1 / 1.1225);
        const double x = std::log(centre);
        const double y = std::log(spectrum.power(centre / 1.1225, centre * 1.1225) / width);
        n += 1, sumX += x, sumY += y, sumXX += x * x, sumXY += x * y;
    }
    return (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
}

} // namespace

TEST_CASE("The profile's spectral slope is beta within 0.05 at any speed") {
    const double exponent = GENERATE(-1.66, -1.22, -0.5, 0.0);
    const double speedRatio = GENERATE(1.0, 0.37);
    const SurfaceProfile profile({.spectrumExponent = exponent}, rateHz, 11);
    const Periodogram spectrum(readAt(profile, speedRatio, std::size_t{1} << 20, 0.3), rateHz);
    CHECK_THAT(spectralSlope(spectrum, 60 * speedRatio, 20000 * speedRatio),
               WithinAbs(exponent, 0.05));
}

TEST_CASE("Over a period the profile's mean is 0 and its rms 1") {
    const SurfaceProfile profile({.spectrumExponent = GENERATE(-1.66, 0.0)}, rateHz, 3);
    double sum = 0, squares = 0;
    const auto samples = readAt(profile, 1, SurfaceProfile::periodSamples);
    for (const float sample : samples) {
        sum += sample;
        squares += static_cast<double>(sample) * sample;
    }
    CHECK_THAT(sum / period, WithinAbs(0, 1e-5));
    CHECK_THAT(std::sqrt(squares / period), WithinAbs(1, 1e-3));
}

TEST_CASE("The profile repeats without a seam") {
    const SurfaceProfile profile({.spectrumExponent = -1.4}, rateHz, 3);
    CHECK_THAT(profile.at(std::nextafter(period, 0.0)), WithinAbs(profile.at(0), 1e-6));
    // The curvature at the seam is as small as elsewhere.
    const auto bend = [&](double place) {
        const auto at = [&](double x) { return profile.at(std::fmod(x + period, period)); };
        return std::abs(at(place - 0.25) - 2 * at(place) + at(place + 0.25));
    };
    double usual = 0;
    for (double place = 100; place < 1100; place += 1)
        usual = std::max(usual, bend(place));
    CHECK(usual > 0);
    for (const double place : {-0.25, 0.0, 0.25})
        CHECK(bend(place) <= 1.5 * usual);
}

TEST_CASE("Equal seeds give equal profiles, and different seeds different ones") {
    const Surface surface;
    const SurfaceProfile first(surface, rateHz, 5), again(surface, rateHz, 5),
        other(surface, rateHz, 6);
    const auto samples = readAt(first, 1, SurfaceProfile::periodSamples);
    CHECK(samples == readAt(again, 1, SurfaceProfile::periodSamples));
    const auto others = readAt(other, 1, SurfaceProfile::periodSamples);
    double product = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        product += static_cast<double>(samples[i]) * others[i];
    CHECK(std::abs(product / period) < 0.2);
}

TEST_CASE("A white profile's images are 36 dB down when read at a thirtieth of v_max") {
    const SurfaceProfile profile({.spectrumExponent = 0}, rateHz, 5);
    const Periodogram spectrum(readAt(profile, 1.0 / 30, std::size_t{1} << 19), rateHz);
    const double bandHz = rateHz / 2 / 30;
    const double images = spectrum.power(1.2 * bandHz, rateHz / 2);
    CHECK(10 * std::log10(images / spectrum.power(0, bandHz)) < -36);
}

TEST_CASE("A surface with a value out of range is refused with a message that names it") {
    CHECK(validated(Surface{}));
    const auto refused = [](Surface surface) {
        const auto result = validated(surface);
        return result ? std::string() : result.error().message;
    };
    CHECK(refused({.spectrumExponent = std::nan("")}).find("exponent") != std::string::npos);
    CHECK(refused({.resonFrequencyHz = 5}).find("frequency") != std::string::npos);
    CHECK(refused({.resonDampingPerSecond = 0}).find("damping") != std::string::npos);
    CHECK(refused({.referenceSpeedMetresPerSecond = 0}).find("speed") != std::string::npos);
    CHECK(refused({.slowestSpeedMetresPerSecond = 2}).find("slowest") != std::string::npos);
    CHECK(refused({.roughness = -1}).find("roughness") != std::string::npos);
}
