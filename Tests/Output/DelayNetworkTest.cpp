#include "Output/DelayNetwork.h"

#include "Output/DecayTime.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double glideSeconds = 0.02;

struct Response {
    std::vector<float> left, right;
    bool operator==(const Response&) const = default;
};

DelayNetwork prepared(double rateHz, double decaySeconds) {
    DelayNetwork network;
    network.prepare(rateHz, glideSeconds);
    network.setDecay(decaySeconds);
    return network;
}

void process(DelayNetwork& network, Response& sound, std::size_t blockSize) {
    for (std::size_t start = 0; start < sound.left.size(); start += blockSize) {
        const auto count = std::min(blockSize, sound.left.size() - start);
        network.process(std::span(sound.left).subspan(start, count),
                        std::span(sound.right).subspan(start, count));
    }
}

/// Returns the response to an impulse in the left channel or in both.
Response impulseResponse(double rateHz, double decaySeconds, double seconds, bool isMono = false) {
    auto network = prepared(rateHz, decaySeconds);
    Response response;
    for (auto* side : {&response.left, &response.right})
        side->resize(static_cast<std::size_t>(seconds * rateHz));
    response.left[0] = 1;
    response.right[0] = isMono ? 1.0f : 0.0f;
    process(network, response, 4096);
    return response;
}

/// Returns the echo density of Abel & Huang 2006 (AES preprint 6985), eq. 1, in a Hann window of 20
/// ms around a time.
double echoDensity(const std::vector<float>& response, double rateHz, double seconds) {
    const auto half = static_cast<int>(0.01 * rateHz);
    const auto centre = static_cast<int>(seconds * rateHz);
    double weights = 0, power = 0, outside = 0;
    const auto each = [&](auto visit) {
        for (int i = -half; i <= half; ++i)
            visit(0.5 + 0.5 * std::cos(std::numbers::pi * i / half),
                  static_cast<double>(response[static_cast<std::size_t>(centre + i)]));
    };
    each([&](double weight, double sample) {
        weights += weight;
        power += weight * sample * sample;
    });
    const double deviation = std::sqrt(power / weights);
    each([&](double weight, double sample) {
        outside += std::abs(sample) > deviation ? weight : 0;
    });
    return outside / weights / std::erfc(1 / std::numbers::sqrt2);
}

/// Applies two band-passes in series. They are an octave wide unless `quality` (centre over width)
/// differs.
std::vector<double> bandOf(const std::vector<float>& samples,
                           double rateHz,
                           double centreHz,
                           double quality = std::numbers::sqrt2) {
    std::vector<double> band(samples.begin(), samples.end());
    const double angle = 2 * std::numbers::pi * centreHz / rateHz;
    const double alpha = std::sin(angle) / (2 * quality);
    for (int pass = 0; pass < 2; ++pass) {
        double in1 = 0, in2 = 0, out1 = 0, out2 = 0;
        for (double& sample : band) {
            const double out =
                (alpha * (sample - in2) + 2 * std::cos(angle) * out1 - (1 - alpha) * out2) /
                (1 + alpha);
            in2 = std::exchange(in1, sample);
            out2 = std::exchange(out1, out);
            sample = out;
        }
    }
    return band;
}

} // namespace

TEST_CASE("The network fades by 60 dB in its decay time in every octave up to 1 kHz") {
    const double rateHz = GENERATE(22050.0, 44100.0, 48000.0, 96000.0, 192000.0);
    const double decaySeconds = GENERATE(0.4, 0.6, 1.0, 3.0);
    const auto response = impulseResponse(rateHz, decaySeconds, 1.6 * decaySeconds);
    for (const double centreHz : {250.0, 500.0, 1000.0}) {
        CAPTURE(rateHz, decaySeconds, centreHz);
        CHECK_THAT(decaySecondsOf(bandOf(response.left, rateHz, centreHz), rateHz, 30),
                   WithinRel(decaySeconds, 0.12));
    }
}

TEST_CASE("At 8 kHz the network fades as walls and air absorb, at every sample rate") {
    const double rateHz = GENERATE(44100.0, 48000.0, 96000.0, 192000.0);
    const double decaySeconds = GENERATE(0.6, 1.0, 3.0, 10.0);
    const double wanted = 1 / (1 / (0.6 * decaySeconds) + 1 / 1.7);
    const auto response = impulseResponse(rateHz, decaySeconds, 1.6 * wanted);
    CAPTURE(rateHz, decaySeconds);
    CHECK_THAT(decaySecondsOf(bandOf(response.left, rateHz, 8000, 16), rateHz, 30),
               WithinRel(wanted, 0.25));
}

TEST_CASE("The first echo comes after 20 ms, and after 80 ms echoes are as dense as noise") {
    const double rateHz = GENERATE(44100.0, 48000.0, 96000.0);
    const bool isMono = GENERATE(false, true);
    const auto response = impulseResponse(rateHz, 0.6, 0.5, isMono);
    for (const auto* side : {&response.left, &response.right}) {
        const auto first = std::ranges::find_if(*side, [](float x) { return x != 0; });
        CHECK(static_cast<double>(first - side->begin()) >=
              std::floor(DelayNetwork::shortestSeconds * rateHz));
        for (double seconds = 0.08; seconds < 0.4; seconds += 0.01) {
            CAPTURE(rateHz, isMono, seconds);
            CHECK(echoDensity(*side, rateHz, seconds) > 0.8);
        }
    }
}

TEST_CASE("The tail is close to Gaussian and differs between the channels") {
    const double rateHz = 48000, decaySeconds = 1;
    const auto response = impulseResponse(rateHz, decaySeconds, 0.6, true);
    double second = 0, fourth = 0, product = 0, otherSecond = 0, count = 0;
    for (auto i = static_cast<std::size_t>(0.1 * rateHz); i < response.left.size(); ++i) {
        const double undone = std::pow(10, 3 * static_cast<double>(i) / rateHz / decaySeconds);
        const double left = undone * static_cast<double>(response.left[i]);
        const double right = undone * static_cast<double>(response.right[i]);
        second += left * left;
        otherSecond += right * right;
        fourth += left * left * left * left;
        product += left * right;
        ++count;
    }
    CHECK_THAT(fourth / count / std::pow(second / count, 2), WithinAbs(3, 0.6));
    CHECK_THAT(product / std::sqrt(second * otherSecond), WithinAbs(0, 0.05));
}

TEST_CASE("The response does not depend on the block size, even if the decay changes") {
    const auto played = [](std::size_t blockSize) {
        auto network = prepared(48000, 0.5);
        Response all;
        for (const double decaySeconds : {0.5, 4.0, 0.4, 1.0}) {
            network.setDecay(decaySeconds);
            Response part;
            for (auto* side : {&part.left, &part.right})
                for (int i = 0; i < 3000; ++i)
                    side->push_back(std::sin(0.05f * static_cast<float>(i)));
            process(network, part, blockSize);
            all.left.insert(all.left.end(), part.left.begin(), part.left.end());
            all.right.insert(all.right.end(), part.right.begin(), part.right.end());
        }
        return all;
    };
    const auto expected = played(3000);
    for (const std::size_t blockSize : {1u, 7u, 64u, 480u})
        CHECK(played(blockSize) == expected);
}

TEST_CASE("A change of decay time during a low tone makes no step") {
    auto network = prepared(48000, 10);
    const auto tone = [](int count, float level) {
        Response sound;
        for (auto* side : {&sound.left, &sound.right})
            for (int i = 0; i < count; ++i)
                side->push_back(level * std::sin(2 * std::numbers::pi_v<float> * 100 *
                                                 static_cast<float>(i) / 48000));
        return sound;
    };
    auto begun = tone(48000, 1);
    process(network, begun, 480);
    const auto [lowest, highest] = std::ranges::minmax(begun.left);
    const float most = std::max(-lowest, highest);
    auto tail = tone(9600, 0);
    process(network, tail, 480);
    float last = tail.left.back();
    for (int change = 0; change < 10; ++change) {
        network.setDecay(change % 2 == 0 ? 0.4 : 10);
        auto part = tone(480, 0);
        process(network, part, 480);
        for (const float sample : part.left) {
            // The maximum slope of 100 Hz and of the fastest glide.
            REQUIRE(std::abs(sample - last) <= 0.03f * most);
            last = sample;
        }
    }
}

TEST_CASE("A cleared network responds like a new one") {
    auto network = prepared(48000, 5), fresh = prepared(48000, 0.7);
    Response rung{std::vector<float>(5000, 1.0f), std::vector<float>(5000, -0.5f)};
    process(network, rung, 480);
    network.setDecay(0.7);
    network.clear();
    Response first{std::vector<float>(5000, 0.3f), std::vector<float>(5000, 0.2f)};
    auto second = first;
    process(network, first, 480);
    process(fresh, second, 480);
    CHECK(first == second);
}
