#include "Instrument/ContactTrain.h"

#include "Instrument/StrikeSpectrum.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <vector>

using namespace idiophone;
using Catch::Approx;

namespace {

const Strike hardStrike{
    .point = {.shapeRows = {3, 0, 0}, .weights = {1, 0, 0}, .normal = {0, 0, 1}},
    .impulseNewtonSeconds = {0.01f, 0, -0.06f},
    .durationSeconds = 0.0002};

double impulse(const ContactTrain& train) {
    double sum = 0;
    for (const auto& contact : train)
        sum -= contact.strike.impulseNewtonSeconds[2];
    return sum;
}

bool isTheStrikeItself(const ContactTrain& train, const Strike& strike) {
    return train.size() == 1 && train.begin()->delaySeconds == 0 &&
           train.begin()->strike.impulseNewtonSeconds == strike.impulseNewtonSeconds &&
           train.begin()->strike.durationSeconds == strike.durationSeconds;
}

} // namespace

TEST_CASE("A train keeps the strike's impulse, gets weaker and ends within 15 ms") {
    std::set<std::size_t> numbers;
    const double scale = GENERATE(0.1, 0.5, 1, 8);
    const double percent = GENERATE(1, 50, 100);
    for (std::uint32_t number = 0; number < 500; ++number) {
        Strike strike = hardStrike;
        strike.durationSeconds *= scale;
        const auto train = contactTrain(strike, scale, percent, number);
        if (strike.durationSeconds >= 0.001) {
            CHECK(train.size() == 1);
            continue;
        }
        numbers.insert(train.size());
        REQUIRE(train.size() >= 3);
        REQUIRE(train.size() <= ContactTrain::maximumCollisions);
        CHECK(impulse(train) == Approx(0.06).epsilon(1e-5));
        CHECK(train.begin()->delaySeconds == 0);
        CHECK(train.begin()->strike.durationSeconds == strike.durationSeconds);
        double lastGap = 1;
        for (const auto* next = train.begin() + 1; next != train.end(); ++next) {
            const auto* before = next - 1;
            const double gap = next->delaySeconds - before->delaySeconds;
            CHECK(gap > 0);
            CHECK(gap < lastGap);
            lastGap = gap;
            CHECK(-next->strike.impulseNewtonSeconds[2] < -before->strike.impulseNewtonSeconds[2]);
            CHECK(next->strike.impulseNewtonSeconds[0] / next->strike.impulseNewtonSeconds[2] ==
                  Approx(-1 / 6.0));
            CHECK(next->strike.durationSeconds > before->strike.durationSeconds);
            CHECK(next->strike.point.shapeRows[0] == 3);
            CHECK(next->delaySeconds + next->strike.durationSeconds <=
                  0.015 * std::min(scale, 1.0));
        }
    }
    if (scale < 5)
        CHECK(numbers.size() == 4);
}

TEST_CASE("Without chatter, and for soft contacts, a train is the strike itself") {
    CHECK(isTheStrikeItself(contactTrain(hardStrike, 1, 0, 7), hardStrike));
    Strike soft = hardStrike;
    soft.durationSeconds = 0.001;
    CHECK(isTheStrikeItself(contactTrain(soft, 1, 100, 7), soft));
    soft.durationSeconds = 0.0005; // contact time of a mallet half the size
    CHECK(isTheStrikeItself(contactTrain(soft, 0.5, 100, 7), soft));
}

TEST_CASE("A shorter contact and more chatter put more of the impulse into later collisions") {
    const auto lateShare = [](double seconds, double percent) {
        Strike strike = hardStrike;
        strike.durationSeconds = seconds;
        const auto train = contactTrain(strike, 1, percent, 11);
        return 1 + train.begin()->strike.impulseNewtonSeconds[2] / 0.06;
    };
    CHECK(lateShare(1e-9, 100) == Approx(0.5).margin(1e-5));
    CHECK(lateShare(0.0005, 100) == Approx(0.25).margin(1e-5));
    CHECK(lateShare(0.0005, 40) == Approx(0.1).margin(1e-5));
    CHECK(lateShare(0.0009, 40) == Approx(0.02).margin(1e-5));
}

TEST_CASE("The same strike number gives the same train, and other numbers give other trains") {
    std::set<double> lastDelays;
    for (std::uint32_t number = 0; number < 1000; ++number) {
        const auto one = contactTrain(hardStrike, 1, 80, number);
        const auto again = contactTrain(hardStrike, 1, 80, number);
        REQUIRE(one.size() == again.size());
        for (std::size_t k = 0; k < one.size(); ++k) {
            CHECK(one.begin()[k].delaySeconds == again.begin()[k].delaySeconds);
            CHECK(one.begin()[k].strike.impulseNewtonSeconds ==
                  again.begin()[k].strike.impulseNewtonSeconds);
        }
        lastDelays.insert((one.end() - 1)->delaySeconds);
    }
    CHECK(lastDelays.size() > 990);
    CHECK(*lastDelays.begin() < 0.007);
    CHECK(*lastDelays.rbegin() > 0.013);
}

TEST_CASE("Modal pulses last one period each and share the first collision's impulse evenly") {
    const auto train = contactTrain(hardStrike, 1, 100, 5);
    const std::array<double, 5> frequenciesHz{200, 540, 1070, 1500, 2500};
    for (const std::size_t count : {2u, 4u, 5u}) {
        const auto pulses = withModalPulses(train, std::span(frequenciesHz).first(count));
        const std::size_t used = std::min<std::size_t>(count, 4);
        REQUIRE(pulses.size() == used + train.size() - 1);
        CHECK(impulse(pulses) == Approx(0.06).epsilon(1e-5));
        for (std::size_t k = 0; k < used; ++k) {
            const auto& pulse = pulses.begin()[k];
            CHECK(pulse.delaySeconds == 0);
            CHECK(pulse.strike.durationSeconds == Approx(1 / frequenciesHz[k]));
            CHECK(
                pulse.strike.impulseNewtonSeconds[2] ==
                Approx(train.begin()->strike.impulseNewtonSeconds[2] / static_cast<double>(used)));
        }
        for (std::size_t k = 1; k < train.size(); ++k) {
            const auto& further = pulses.begin()[used + k - 1];
            CHECK(further.delaySeconds == train.begin()[k].delaySeconds);
            CHECK(further.strike.durationSeconds == train.begin()[k].strike.durationSeconds);
        }
    }
    CHECK(withModalPulses(train, {}).size() == train.size());
}

namespace {

constexpr double pi = std::numbers::pi;

double spectrumDb(const ContactTrain& train, double hz) {
    return 20 * std::log10(std::abs(ringingVelocity(train, 1e-6, 2 * pi * hz)));
}

/// Returns the upper hull of 20 lg of the spectrum of F ∝ sin^(3/2) (πt), of impulse 1, over
/// octaves of the frequency.
std::vector<double> hertzHullDb(const std::vector<double>& octaves) {
    constexpr int steps = 4000;
    std::vector<double> pulse;
    double sum = 0;
    for (int k = 0; k < steps; ++k)
        sum += pulse.emplace_back(std::pow(std::sin(pi * (k + 0.5) / steps), 1.5));
    std::vector<double> levels;
    for (const double octave : octaves) {
        std::complex<double> total = 0;
        for (int k = 0; k < steps; ++k)
            total += pulse[static_cast<std::size_t>(k)] *
                     std::polar(1.0, -2 * pi * std::exp2(octave) * (k + 0.5) / steps);
        levels.push_back(20 * std::log10(std::abs(total) / sum));
    }
    auto hull = levels;
    for (std::size_t i = 0; i < levels.size(); ++i)
        for (std::size_t from = 0; from <= i; ++from)
            for (std::size_t to = i + 1; to < levels.size(); ++to)
                hull[i] = std::max(hull[i], levels[from] + (levels[to] - levels[from]) *
                                                               (octaves[i] - octaves[from]) /
                                                               (octaves[to] - octaves[from]));
    return hull;
}

} // namespace

TEST_CASE("A pulse with filled nulls keeps impulse, contact time and further collisions") {
    const auto chattering = contactTrain(hardStrike, 1, 100, 5);
    const auto train = withFilledNulls(chattering);
    REQUIRE(train.size() == chattering.size() + 2);
    CHECK(impulse(train) == Approx(0.06).epsilon(1e-5));
    CHECK(train.begin()->delaySeconds == 0);
    for (const auto* part = train.begin(); part != train.begin() + 3; ++part) {
        CHECK(part->strike.impulseNewtonSeconds[0] * -6 ==
              Approx(part->strike.impulseNewtonSeconds[2]));
        CHECK(part->strike.impulseNewtonSeconds[2] < 0);
        CHECK(part->delaySeconds + part->strike.durationSeconds <=
              hardStrike.durationSeconds * (1 + 1e-9));
    }
    for (std::size_t k = 1; k < chattering.size(); ++k)
        CHECK((train.begin() + 2 + k)->delaySeconds == (chattering.begin() + k)->delaySeconds);
}

TEST_CASE("A pulse with filled nulls follows the hull of the spectrum of Hertz within 5 dB") {
    const Strike unit{.point = {}, .impulseNewtonSeconds = {0, 0, -1}, .durationSeconds = 1};
    ContactTrain single;
    single.add({.delaySeconds = 0, .strike = unit});
    const auto filled = withFilledNulls(single);
    std::vector<double> octaves;
    for (double octave = -4; octave <= 4.6; octave += 0.03)
        octaves.push_back(octave);
    const auto hull = hertzHullDb(octaves);
    double deepest = 0;
    for (std::size_t i = 0; octaves[i] <= 4; ++i) { // the hull ends in a null
        INFO("f T = " << std::exp2(octaves[i]));
        CHECK(spectrumDb(filled, std::exp2(octaves[i])) == Approx(hull[i]).margin(5));
        deepest = std::min(deepest, spectrumDb(single, std::exp2(octaves[i])) - hull[i]);
    }
    CHECK(deepest < -30); // the nulls of a single pulse
}
