#include "Analysis/SurfaceFit.h"

#include "Synth/ContactForce.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>
#include <random>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double rateHz = 48000;

std::vector<float>
scrapeOf(const Surface& surface, double speed, double seconds, std::uint64_t seed = 9) {
    ContactForce contact(std::make_shared<const SurfaceProfile>(surface, rateHz, seed), 1);
    std::vector<float> result;
    std::array<float, cellSamples> cell{};
    while (static_cast<double>(result.size()) < seconds * rateHz) {
        contact.render({speed, 1}, cell);
        result.insert(result.end(), cell.begin(), cell.end());
    }
    return result;
}

void checkFit(const std::vector<float>& samples, const Surface& surface, double speedRatio) {
    const auto fit = fitSurface(samples, rateHz);
    REQUIRE(fit);
    CHECK_THAT(fit->spectrumExponent, WithinAbs(surface.spectrumExponent, 0.1));
    CHECK_THAT(fit->resonFrequencyHz, WithinRel(surface.resonFrequencyHz * speedRatio, 0.05));
    CHECK_THAT(fit->resonDampingPerSecond,
               WithinRel(surface.resonDampingPerSecond * speedRatio, 0.2));
}

std::string faultOf(const std::vector<float>& samples) {
    const auto fit = fitSurface(samples, rateHz);
    return fit ? std::string() : fit.error().message;
}

} // namespace

TEST_CASE(
    "A scrape's fit recovers beta within 0.1, reson frequency within 5 % and damping within 20 %") {
    const double exponent = GENERATE(-1.66, -1.22, -0.6);
    const auto [frequencyHz, damping] =
        GENERATE(std::pair{500.0, 1000.0}, std::pair{300.0, 200.0}, std::pair{2500.0, 600.0},
                 std::pair{8000.0, 3000.0});
    CAPTURE(exponent, frequencyHz, damping);
    const Surface surface{.spectrumExponent = exponent,
                          .resonFrequencyHz = frequencyHz,
                          .resonDampingPerSecond = damping};
    checkFit(scrapeOf(surface, 1, 6), surface, 1);
}

TEST_CASE("A slower scrape, cut off in mid-band, is fitted at its own speed") {
    const Surface surface{
        .spectrumExponent = -1.4, .resonFrequencyHz = 2000, .resonDampingPerSecond = 800};
    checkFit(scrapeOf(surface, 0.5, 6), surface, 0.5);
}

TEST_CASE("A scrape of one second in 16 bits with a constant offset is fitted") {
    const Surface surface{
        .spectrumExponent = -1.4, .resonFrequencyHz = 1000, .resonDampingPerSecond = 700};
    auto samples = scrapeOf(surface, 1, 1);
    for (float& sample : samples)
        sample = std::round(sample * 8000) / 32768 + 0.01f;
    checkFit(samples, surface, 1);
}

TEST_CASE("The surface fit does not depend on the recording's level") {
    const Surface surface{.resonFrequencyHz = 1000, .resonDampingPerSecond = 700};
    auto samples = scrapeOf(surface, 1, 2);
    const auto loud = fitSurface(samples, rateHz);
    for (float& sample : samples)
        sample *= 0.001f;
    const auto quiet = fitSurface(samples, rateHz);
    REQUIRE((loud && quiet));
    CHECK_THAT(quiet->spectrumExponent, WithinAbs(loud->spectrumExponent, 1e-3));
    CHECK_THAT(quiet->resonFrequencyHz, WithinRel(loud->resonFrequencyHz, 1e-3));
}

TEST_CASE("A recording without a scrape gives an error with the reason") {
    const auto second = static_cast<std::size_t>(rateHz);
    CHECK(faultOf({}).find("shorter") != std::string::npos);
    CHECK(faultOf(std::vector<float>(second / 5, 0.1f)).find("shorter") != std::string::npos);
    CHECK(faultOf(std::vector<float>(second)).find("silent") != std::string::npos);
    CHECK(faultOf(std::vector<float>(second, 0.5f)).find("silent") != std::string::npos);
    std::vector<float> broken(second, 0.1f);
    broken[1000] = std::numeric_limits<float>::quiet_NaN();
    CHECK(faultOf(broken).find("not numbers") != std::string::npos);
}

TEST_CASE("Noise of any length is fitted without failure or refused") {
    std::mt19937 random(3);
    for (const std::size_t length : {12000u, 12001u, 20011u, 65537u}) {
        std::vector<float> noise(length);
        for (float& sample : noise)
            sample = static_cast<float>(static_cast<double>(random()) / 4294967296.0 - 0.5);
        const auto fit = fitSurface(noise, rateHz);
        if (fit)
            CHECK_THAT(fit->spectrumExponent, WithinAbs(0, 0.3));
        else
            CHECK(fit.error().message.find("resonance") != std::string::npos);
    }
}
