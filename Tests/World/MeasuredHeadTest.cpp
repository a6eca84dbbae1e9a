// Tests a measured head with the responses of the spherical one.
#include "World/MeasuredSource.h"
#include "World/SphereSource.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;

namespace {

const Listener listener{.positionMetres = {0, 0, 0}, .towardsMetres = {0, 1, 0}};
constexpr std::size_t lateSamples = 60;

/// Returns the place in a direction (ahead, left, up) of the listener, who looks along y.
Eigen::Vector3d placeOf(const Eigen::Vector3d& direction) {
    return {-direction.y(), direction.x(), direction.z()};
}

/// Returns the responses of the spherical head with delays rounded to samples, all late by
/// `lateSamples`.
HeadMeasurement measuredSphere(double rateHz, std::size_t length) {
    const HeadModel head(listener);
    HeadMeasurement measured{
        .measuredRateHz = rateHz, .sampleRateHz = rateHz, .lengthSamples = length, .responses = {}};
    for (std::size_t index = 0; index < HeadResponses::directionCount; ++index)
        for (const auto& ear : head.path(placeOf(HeadResponses::direction(index))).ears) {
            const auto shadow = headShadow(ear.highFrequencyGain, rateHz);
            const auto start =
                lateSamples + static_cast<std::size_t>(std::lround(ear.delaySeconds * rateHz));
            double output = 0;
            for (std::size_t n = 0; n < length; ++n) {
                output = (n == start       ? shadow.direct
                          : n == start + 1 ? shadow.previous
                                           : 0) -
                         shadow.feedback * output;
                measured.responses.push_back(static_cast<float>(output));
            }
        }
    return measured;
}

std::shared_ptr<const HeadResponses> sphereAt(double rateHz) {
    auto head = HeadResponses::make(measuredSphere(rateHz, 4 * lateSamples));
    REQUIRE(head);
    return *head;
}

using Ears = std::array<std::vector<float>, 2>;

/// Renders a source whose place changes from cell to cell.
Ears heard(PlacedSource& source,
           const std::vector<float>& sound,
           const std::function<Eigen::Vector3d(std::size_t cell)>& place) {
    const HeadModel head(listener);
    Ears ears;
    for (std::size_t start = 0; start + cellSamples <= sound.size(); start += cellSamples) {
        alignas(64) std::array<float, cellSamples> left{}, right{};
        source.add(std::span<const float, cellSamples>(&sound[start], cellSamples),
                   head.path(place(start / cellSamples)), CellOutput(left, right));
        ears[0].insert(ears[0].end(), left.begin(), left.end());
        ears[1].insert(ears[1].end(), right.begin(), right.end());
    }
    return ears;
}

double energy(const std::vector<float>& samples) {
    double sum = 0;
    for (const double sample : samples)
        sum += sample * sample;
    return sum;
}

std::ptrdiff_t highest(const std::vector<float>& samples) {
    return std::ranges::max_element(samples, {}, [](float x) { return std::abs(x); }) -
           samples.begin();
}

} // namespace

TEST_CASE("A measured sphere sounds like the spherical head at both ears from all directions") {
    const auto head = sphereAt(48000);
    std::vector<float> click(20 * cellSamples);
    for (int i = 0; i < 12; ++i) // below about 8 kHz, where the sphere's cubic is flat
        click[static_cast<std::size_t>(i)] =
            static_cast<float>(std::pow(std::sin(std::numbers::pi * (i + 0.5) / 12), 2));
    std::ptrdiff_t common = -1;
    for (int azimuth = 0; azimuth < 360; azimuth += 30)
        for (int elevation = -60; elevation <= 60; elevation += 30) {
            const double left = azimuth * std::numbers::pi / 180,
                         up = elevation * std::numbers::pi / 180;
            const auto place = placeOf(
                {std::cos(up) * std::cos(left), std::cos(up) * std::sin(left), std::sin(up)});
            SphereSource sphere(48000);
            MeasuredSource measured(head, 48000);
            const auto expected = heard(sphere, click, [&](auto) { return place; });
            const auto found = heard(measured, click, [&](auto) { return place; });
            INFO(azimuth << " " << elevation);
            for (std::size_t ear = 0; ear < 2; ++ear) {
                CHECK_THAT(10 * std::log10(energy(found[ear]) / energy(expected[ear])),
                           WithinAbs(0, 0.3));
                // Both ears have their delays, apart from one common delay that is removed.
                const auto late = highest(found[ear]) - highest(expected[ear]);
                if (common < 0)
                    common = late;
                CHECK(std::abs(late - common) <= 1);
            }
        }
    CHECK(common >= 0);
    CHECK(common < 20);
}

TEST_CASE("The nearest direction is that of the listener, also at the poles") {
    const auto head = sphereAt(48000);
    for (std::size_t index = 0; index < HeadResponses::directionCount; ++index) {
        const auto direction = HeadResponses::direction(index);
        const auto found = HeadResponses::direction(head->nearest(7 * direction));
        CHECK_THAT((found - direction).norm(), WithinAbs(0, 1e-9));
    }
    CHECK(head->nearest({1, 0.03, 0}) == head->nearest({1, -0.03, 0}));
    CHECK(head->nearest({-1, 0.01, 0}) == head->nearest({-1, -0.01, 0}));
    CHECK(head->nearest(Eigen::Vector3d::Zero()) < HeadResponses::directionCount);
}

TEST_CASE("Responses fade out at their maximum length") {
    auto measured = measuredSphere(48000, 1000);
    for (std::size_t i = 0; i < measured.responses.size(); i += 1000)
        measured.responses[i + 700] = 0.5f;
    const auto head = HeadResponses::make(measured);
    REQUIRE(head);
    CHECK((*head)->lengthSamples() ==
          static_cast<std::size_t>(48000 * HeadResponses::longestSeconds));
    for (std::size_t index = 0; index < HeadResponses::directionCount; ++index)
        CHECK((*head)->response(index, 0).back() == 0);
}

TEST_CASE("A source that flies past a measured head does not click, and falls silent") {
    MeasuredSource source(sphereAt(48000), 48000);
    std::vector<float> tone(400 * cellSamples);
    for (std::size_t i = 0; i < 380 * cellSamples; ++i)
        tone[i] = std::sin(0.05f * static_cast<float>(i));
    const auto ears = heard(source, tone, [](std::size_t cell) {
        return Eigen::Vector3d(-2 + 0.01 * static_cast<double>(cell), 0.5, 0.3);
    });
    CHECK(source.silent());
    for (const auto& ear : ears) {
        for (std::size_t i = 1000; i < 380 * cellSamples; ++i)
            REQUIRE(std::abs(ear[i] - 2 * ear[i - 1] + ear[i - 2]) < 0.02f);
        CHECK(ear.back() == 0);
        CHECK(energy(ear) > 1000);
    }
}

TEST_CASE("An invalid head is refused with one sentence") {
    const auto refusal = [](const std::function<void(HeadMeasurement&)>& change) {
        auto measured = measuredSphere(48000, 200);
        change(measured);
        const auto head = HeadResponses::make(measured);
        REQUIRE_FALSE(head);
        return head.error().message;
    };
    CHECK_THAT(refusal([](auto& m) { m.responses.pop_back(); }), ContainsSubstring("all around"));
    CHECK_THAT(refusal([](auto& m) { m.lengthSamples = 0; }), ContainsSubstring("all around"));
    CHECK_THAT(refusal([](auto& m) { m.measuredRateHz = NAN; }), ContainsSubstring("all around"));
    CHECK_THAT(refusal([](auto& m) { m.responses[7] = INFINITY; }),
               ContainsSubstring("not a finite number"));
    CHECK_THAT(refusal([](auto& m) { std::ranges::fill(m.responses, 0.0f); }),
               ContainsSubstring("nothing is heard from straight ahead"));
    CHECK_THAT(refusal([](auto& m) { // louder than a float can represent
                   for (float& sample : m.responses)
                       sample *= 1e-35f;
                   m.responses[150] = 1e10f;
               }),
               ContainsSubstring("louder from elsewhere"));
}

TEST_CASE("A head's responses can be passed on and restored unchanged") {
    const auto head = sphereAt(48000);
    const auto samples = head->allSamples();
    const auto again = HeadResponses::of({samples.begin(), samples.end()});
    REQUIRE(again);
    CHECK(std::ranges::equal((*again)->allSamples(), samples));
    CHECK((*again)->lengthSamples() == head->lengthSamples());
    std::vector<float> wrong(samples.begin(), samples.end());
    wrong[3] = NAN;
    CHECK_FALSE(HeadResponses::of(wrong));
    CHECK_FALSE(HeadResponses::of({}));
    CHECK_FALSE(HeadResponses::of(std::vector<float>(7)));
}

TEST_CASE("A head is equally loud at a sample rate above that of its measurement") {
    auto measured = measuredSphere(48000, 240);
    measured.sampleRateHz = 96000; // each sample twice at half the height
    measured.lengthSamples = 480;
    std::vector<float> doubled;
    for (const float sample : measured.responses)
        doubled.insert(doubled.end(), 2, sample / 2);
    measured.responses = doubled;
    const auto head = HeadResponses::make(measured);
    REQUIRE(head);
    const auto low = [](std::span<const float> response) {
        double sum = 0;
        for (const float sample : response)
            sum += static_cast<double>(sample);
        return sum;
    };
    const auto ahead = (*head)->nearest(Eigen::Vector3d::UnitX());
    const auto usual = sphereAt(48000);
    CHECK_THAT(low((*head)->response(ahead, 0)), WithinAbs(low(usual->response(ahead, 0)), 0.05));
}
