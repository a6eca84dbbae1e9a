#include "Analysis/RecordingFit.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double pi = std::numbers::pi;

struct Partial {
    double frequencyHz = 0;
    double decayPerSecond = 0;
};

struct Scene {
    std::vector<Partial> partials;
    double seconds = 1.5;
    double noise = 0; ///< rms as a fraction of the peak
    std::mt19937 random{7};

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }

    /// Returns silence, then all partials at once, with the given gains and random phases; peak
    /// 0.5.
    std::vector<float> strike(const std::vector<double>& gains, double rateHz, double quiet = 0.1) {
        const auto start = static_cast<std::size_t>(quiet * rateHz);
        std::vector<double> sum(start + static_cast<std::size_t>(seconds * rateHz));
        for (std::size_t i = 0; i < partials.size(); ++i) {
            const double phase = uniform(0, 2 * pi);
            for (std::size_t n = start; n < sum.size(); ++n) {
                const double t = static_cast<double>(n - start) / rateHz;
                sum[n] += gains[i] * std::exp(-partials[i].decayPerSecond * t) *
                          std::cos(2 * pi * partials[i].frequencyHz * t + phase);
            }
        }
        double peak = 0;
        for (const double value : sum)
            peak = std::max(peak, std::abs(value));
        std::normal_distribution<double> hiss(0, std::max(noise, 1e-30));
        std::vector<float> samples;
        for (const double value : sum)
            samples.push_back(static_cast<float>(0.5 * (value / peak + hiss(random))));
        return samples;
    }

    std::vector<double> anyGains(double lowest = 0.1) {
        std::vector<double> gains;
        for (std::size_t i = 0; i < partials.size(); ++i)
            gains.push_back(std::pow(lowest, uniform(0, 1)));
        return gains;
    }
};

double cents(double a, double b) {
    return 1200 * std::log2(a / b);
}

/// Checks that each partial is found within these tolerances, and no others.
void checkFound(const RecordingFit& fit,
                const std::vector<Partial>& partials,
                double centsOff,
                double decayOff) {
    REQUIRE(fit.modes.size() == partials.size());
    for (std::size_t i = 0; i < partials.size(); ++i) {
        CAPTURE(partials[i].frequencyHz, fit.modes[i].frequencyHz, partials[i].decayPerSecond,
                fit.modes[i].decayPerSecond);
        CHECK(std::abs(cents(fit.modes[i].frequencyHz, partials[i].frequencyHz)) < centsOff);
        CHECK(std::abs(fit.modes[i].decayPerSecond / partials[i].decayPerSecond - 1) < decayOff);
    }
}

std::vector<Partial> wokDoublets() {
    std::vector<Partial> partials;
    for (const double hz : {210.0, 345.0, 520.0, 790.0, 1130.0, 1490.0, 2210.0, 3105.0})
        for (const double apart : {0.0, 3.0})
            partials.push_back({.frequencyHz = hz + apart, .decayPerSecond = std::log(1000.0)});
    return partials;
}

} // namespace

TEST_CASE("Damped partials from 100 Hz to 15 kHz are found within 0.1 cents and 1 % of decay") {
    Scene scene{.partials = {{103, 2},
                             {440, 5},
                             {1234.5, 12},
                             {2750, 40},
                             {5403, 150},
                             {8933, 420},
                             {13345, 900},
                             {15100, 1100}}};
    const auto samples = scene.strike({1, 0.8, 0.5, 1, 0.6, 0.7, 0.5, 0.4}, 48000);
    const auto fit = fitRecordings(std::vector<StrikeRecording>{{"one.wav", samples, 48000}});
    REQUIRE(fit);
    checkFound(*fit, scene.partials, 0.1, 0.01);
}

TEST_CASE(
    "Doublets 3 Hz apart are separated within 0.1 cents and 1 % of decay under -60 dB noise") {
    Scene scene{.partials = wokDoublets(), .seconds = 1.2, .noise = 1e-3};
    std::vector<std::vector<float>> samples;
    for (int strike = 0; strike < 3; ++strike)
        samples.push_back(scene.strike(scene.anyGains(), 44100));
    std::vector<StrikeRecording> recordings;
    for (const auto& each : samples)
        recordings.push_back({"wok.wav", each, 44100});
    const auto fit = fitRecordings(recordings);
    REQUIRE(fit);
    checkFound(*fit, scene.partials, 0.1, 0.01);
    for (const double level : fit->noiseDecibels)
        CHECK(level < -25);
}

TEST_CASE("A partial at -50 dB is found within 2 cents and 10 % under -60 dB noise") {
    Scene scene{.partials = {{300, 6}, {870, 9}, {2100, 20}}, .noise = 1e-3};
    std::vector<std::vector<float>> samples;
    for (int strike = 0; strike < 3; ++strike)
        samples.push_back(scene.strike({1, 0.00316, 0.5}, 48000));
    std::vector<StrikeRecording> recordings;
    for (const auto& each : samples)
        recordings.push_back({"r.wav", each, 48000});
    const auto fit = fitRecordings(recordings);
    REQUIRE(fit);
    checkFound(*fit, scene.partials, 2, 0.1);
}

TEST_CASE("Recordings at 44.1, 48 and 96 kHz share their modes and keep their own gains") {
    Scene scene{.partials = {{250, 5}, {690, 11}, {1800, 30}, {4400, 90}}};
    const std::vector<std::vector<double>> gains{
        {1, 0.5, 0.2, 0.1}, {0, 1, 0.5, 0.3}, {0.3, 0, 0, 1}};
    const std::vector<double> rates{44100, 48000, 96000};
    std::vector<std::vector<float>> samples;
    std::vector<StrikeRecording> recordings;
    for (std::size_t r = 0; r < rates.size(); ++r)
        samples.push_back(scene.strike(gains[r], rates[r], 0.05 + 0.03 * double(r)));
    for (std::size_t r = 0; r < rates.size(); ++r)
        recordings.push_back({"r.wav", samples[r], rates[r]});
    const auto fit = fitRecordings(recordings);
    REQUIRE(fit);
    checkFound(*fit, scene.partials, 0.1, 0.01);
    for (std::size_t r = 0; r < rates.size(); ++r) {
        const double strongest = *std::ranges::max_element(gains[r]);
        const auto loudest =
            static_cast<std::size_t>(std::ranges::max_element(gains[r]) - gains[r].begin());
        for (std::size_t i = 0; i < scene.partials.size(); ++i) {
            CAPTURE(r, i);
            const double ratio = fit->modes[i].amplitudes[r] / fit->modes[loudest].amplitudes[r];
            CHECK(std::abs(ratio - gains[r][i] / strongest) < 0.02);
        }
    }
}

TEST_CASE("The strongest modes are kept if there are more than requested") {
    Scene scene{.partials = {{200, 5}, {500, 5}, {900, 5}, {1500, 5}}};
    const auto samples = scene.strike({0.1, 1, 0.05, 0.8}, 48000);
    const auto fit =
        fitRecordings(std::vector<StrikeRecording>{{"r.wav", samples, 48000}}, {.modeCount = 2});
    REQUIRE(fit);
    CHECK(fit->modesFound == 4);
    checkFound(*fit, {{500, 5}, {1500, 5}}, 0.1, 0.01);
}

TEST_CASE("The fit restores high modes that the contact time attenuated") {
    // Modes of equal gain excited by a raised cosine of 1 ms, convolved in 1000 steps.
    constexpr double rate = 48000, contact = 1e-3;
    const std::vector<Partial> partials{{200, 8}, {600, 8}, {1100, 8}};
    std::vector<float> samples(static_cast<std::size_t>(rate), 0.0f);
    for (std::size_t n = 0; n < samples.size(); ++n)
        for (const auto& [hz, decay] : partials)
            for (int step = 0; step < 1000; ++step) {
                const double past = contact * (step + 0.5) / 1000;
                const double t = static_cast<double>(n) / rate - past;
                if (t >= 0 && n < 12000)
                    samples[n] +=
                        static_cast<float>(1e-4 * (1 - std::cos(2 * pi * past / contact)) *
                                           std::exp(-decay * t) * std::cos(2 * pi * hz * t));
            }
    samples.resize(12000);
    const auto fit = fitRecordings(std::vector<StrikeRecording>{{"r.wav", samples, rate}},
                                   {.contactSeconds = contact});
    REQUIRE(fit);
    REQUIRE(fit->modes.size() == 3);
    for (const auto& mode : fit->modes)
        CHECK(std::abs(mode.amplitudes[0] / fit->modes[0].amplitudes[0] - 1) < 0.02);
}

TEST_CASE("A recording that cannot be fitted gives an error with its name and the reason") {
    const auto refused = [](const std::vector<float>& samples, const char* sentence) {
        INFO(sentence);
        const auto fit = fitRecordings(std::vector<StrikeRecording>{{"bad.wav", samples, 48000}});
        REQUIRE_FALSE(fit);
        CHECK_THAT(fit.error().message, ContainsSubstring("bad.wav"));
        CHECK_THAT(fit.error().message, ContainsSubstring(sentence));
    };
    refused(std::vector<float>(48000, 0.0f), "silent");
    refused(std::vector<float>(100, 0.5f), "shorter than 20 ms");
    refused({}, "shorter than 20 ms");
    std::vector<float> broken(48000, 0.1f);
    broken[5] = std::numeric_limits<float>::quiet_NaN();
    refused(broken, "not numbers");
    std::vector<float> click(48000, 0.0f);
    click[47990] = 1;
    refused(click, "less than 20 ms");
    std::mt19937 random(3);
    std::vector<float> hiss;
    for (int n = 0; n < 24000; ++n)
        hiss.push_back(std::uniform_real_distribution<float>(-0.5f, 0.5f)(random));
    refused(hiss, "nothing in it rings");
}

TEST_CASE("An empty list of recordings is refused") {
    CHECK_FALSE(fitRecordings({}));
}
