// Tests discs over the tubes: the tubes' part of the sound pulses, and nothing else does.
#include "ModalReference.h"
#include "Synth/TubeShares.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <random>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;
constexpr std::complex<float> sharedGain{1.5f, 0.4f};
constexpr double sharedHz = 300, higherSharedHz = 312, ownHz = 1220;

/// A bar with a pair of modes that it shares with its tube, and one separate mode.
ModalObject barOverTube() {
    ModalObject bar = ringingObject({sharedHz, higherSharedHz, ownHz}, 10);
    bar.gains = {sharedGain, -sharedGain, 1};
    return bar;
}

/// Objects with only the pair, and with only the separate mode.
ModalObject pairAlone() {
    ModalObject pair = ringingObject({sharedHz, higherSharedHz}, 10);
    pair.gains = {sharedGain, -sharedGain};
    return pair;
}
ModalObject ownAlone() {
    return ringingObject({ownHz}, 10);
}

/// Open, closed and open again within 80 cells. At 24 Hz, for a motor's maximum of 12 turns a
/// second, the period is 31 cells.
double openingAfter(double cells) {
    return (1 + std::cos(2 * std::numbers::pi * cells / 80)) / 2;
}

/// The opening, linear from cell to cell.
double openingAt(double sample) {
    const double cells = (sample + 1) / cellSamples;
    const double before = std::floor(cells);
    return std::lerp(openingAfter(before), openingAfter(before + 1), cells - before);
}

TubeOpening openingOf(int cell) {
    return {.start = static_cast<float>(openingAfter(cell)),
            .end = static_cast<float>(openingAfter(cell + 1))};
}

std::vector<float> struck(const ModalObject& object,
                          const std::vector<TimedStrike>& strikes,
                          const std::function<TubeOpening(int cell)>& opening,
                          double damping = 0,
                          const SynthesisSettings& settings = exactSettings()) {
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(settings);
    synthesiser.setDamping(0, damping);
    return render(synthesiser, strikes, 240,
                  [&](int cell) { synthesiser.setTubeOpening(opening(cell)); });
}

std::vector<float> forced(const ModalObject& object,
                          const std::function<TubeOpening(int cell)>& opening) {
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    std::mt19937 random(5);
    std::vector<float> output;
    for (int c = 0; c < 240; ++c) {
        std::array<float, cellSamples> cell{}, newtons;
        for (float& newton : newtons)
            newton = static_cast<float>(random()) / 2147483648.0f - 1;
        synthesiser.setTubeOpening(opening(c));
        synthesiser.beginCell(cell);
        synthesiser.applyForce(0, {.start = {}, .end = {}, .newtons = newtons}, cell);
        output.insert(output.end(), cell.begin(), cell.end());
    }
    return output;
}

TubeOpening full(int) {
    return {};
}
TubeOpening closed(int) {
    return {.start = 0, .end = 0};
}

} // namespace

TEST_CASE("A tube's share is its part of a shared mode's radiation, and 0 for other modes") {
    auto bar = barOverTube();
    CHECK(tubeShares(ownAlone()).empty());
    CHECK(tubeShares(bar) == std::vector<float>{1, 1, 0});

    const std::complex<float> gain{0.7f, 0.2f}, otherGain = 1.0f - gain;
    bar.gains = {gain, otherGain, 1};
    bar.radiation.directions = {{0, 0, 1}, {1, 0, 0}};
    bar.radiation.frequencyRatios = {1};
    const auto radiate = [&](std::complex<float> ofBar, std::complex<float> ofTube) {
        bar.radiation.weights = {gain * ofBar + ofTube, otherGain * ofBar - ofTube, 0.3f,
                                 gain * ofBar + ofTube, otherGain * ofBar - ofTube, 0.1f};
        return tubeShares(bar);
    };
    for (const float share : radiate(0, {0.5f, -0.2f}))
        CHECK((share == 0 || std::abs(share - 1) < 1e-6f));
    CHECK(std::abs(radiate({0.4f, 0.3f}, 0)[0]) < 1e-6f);
    // The tube radiates in phase with the bar.
    const auto half = radiate(1.0f / gain, 1);
    CHECK_THAT(half[0], Catch::Matchers::WithinAbs(0.5, 1e-6));
    CHECK(half[2] == 0);
}

TEST_CASE("Discs multiply the shared modes by their opening and leave all other modes unchanged") {
    const auto [contactSeconds, damping] =
        GENERATE(std::pair{0.0, 20.0}, std::pair{4e-4, 0.0}, std::pair{0.03, 20.0});
    CAPTURE(contactSeconds, damping);
    constexpr std::array times{5.5, 2000.25, 2583.0};
    std::vector<TimedStrike> strikes;
    for (const double time : times)
        strikes.push_back({time, unitStrike(contactSeconds)});
    const auto sound = struck(barOverTube(), strikes, openingOf, damping);

    const auto& material = barOverTube().material;
    const std::complex<double> gain(sharedGain);
    const std::array shared{referenceMode(material, sharedHz, gain),
                            referenceMode(material, higherSharedHz, -gain)};
    const auto own = referenceMode(material, ownHz, 1);
    const auto velocity = [&](const ReferenceMode& mode, double seconds) {
        return contactSeconds > 0 ? pulseVelocity(mode, contactSeconds, seconds, damping)
                                  : std::exp(-damping * seconds) * impulseVelocity(mode, seconds);
    };
    CHECK(errorDb(sound, [&](double sample) {
              double sum = 0;
              for (const double time : times) {
                  const double seconds = (sample - time) / sampleRate;
                  if (seconds < 0)
                      continue;
                  sum += velocity(own, seconds) +
                         openingAt(sample) *
                             (velocity(shared[0], seconds) + velocity(shared[1], seconds));
              }
              return sum;
          }) < -105);
}

TEST_CASE("Discs multiply the shared modes of a continuous force by their opening") {
    const auto sound = forced(barOverTube(), openingOf);
    const auto shared = forced(pairAlone(), full);
    const auto own = forced(ownAlone(), full);
    CHECK(errorDb(sound, [&](double sample) {
              const auto k = static_cast<std::size_t>(sample);
              return double(own[k]) + openingAt(sample) * double(shared[k]);
          }) < -105);
}

TEST_CASE("From afar, discs block the tube's radiation and leave the bar's radiation unchanged") {
    const double contactSeconds = GENERATE(0.0, 0.03);
    auto bar = barOverTube();
    const std::complex<float> gain{0.7f, 0.2f}, otherGain = 1.0f - gain;
    const auto ofBar = 0.1f / gain, otherOfBar = ofBar * otherGain;
    bar.gains = {gain, otherGain, 1};
    bar.radiation.directions = {{0, 0, 1}};
    bar.radiation.frequencyRatios = {1};
    bar.radiation.weights = {0.1f + 0.4f, otherOfBar - 0.4f, 0.3f};
    const auto shares = tubeShares(bar);
    CHECK_THAT(shares[0], Catch::Matchers::WithinAbs(0.8, 1e-6));

    auto settings = exactSettings();
    settings.radiation = 1;
    const std::vector<TimedStrike> strikes{{5.5, unitStrike(contactSeconds)}};
    const auto sound = struck(bar, strikes, openingOf, 0, settings);
    std::vector<std::vector<float>> ofModes; // with open tubes
    for (std::size_t heard = 0; heard < 3; ++heard) {
        auto alone = bar;
        for (std::size_t mode = 0; mode < 3; ++mode)
            if (mode != heard)
                alone.radiation.weights[mode] = 0;
        ofModes.push_back(struck(alone, strikes, full, 0, settings));
    }
    CHECK(errorDb(sound, [&](double sample) {
              double sum = 0;
              for (std::size_t mode = 0; mode < 3; ++mode)
                  sum += (1 + double(shares[mode]) * (openingAt(sample) - 1)) *
                         double(ofModes[mode][static_cast<std::size_t>(sample)]);
              return sum;
          }) < -105);
}

TEST_CASE("Open discs, or an object without a tube, change no bit") {
    const std::vector<TimedStrike> strikes{{5.5, unitStrike()}, {900, unitStrike(0.003)}};
    const auto bar = barOverTube();
    Synthesiser without({slotOf(bar)}, sampleRate);
    without.setSettings(exactSettings());
    CHECK(struck(bar, strikes, full) == render(without, strikes, 240));

    ModalObject open = ringingObject({sharedHz, ownHz}, 10);
    const auto alone = struck(open, strikes, full), forcedAlone = forced(open, full);
    CHECK(struck(open, strikes, openingOf) == alone);
    CHECK(forced(open, openingOf) == forcedAlone);
    open.gains = {1, 1};
    CHECK(struck(open, strikes, openingOf) == alone);
    CHECK(forced(open, openingOf) == forcedAlone);
}

TEST_CASE("Shared modes that are dropped and restored under closed discs stay silent") {
    const std::vector<TimedStrike> strikes{{5.5, unitStrike(0.001)}};
    const auto pair = pairAlone();
    const auto loudest = [&](const TubeOpening& opening, const auto& changeBefore) {
        Synthesiser synthesiser({slotOf(pair)}, sampleRate);
        const auto sound = render(synthesiser, strikes, 240, [&](int cell) {
            auto settings = exactSettings();
            changeBefore(cell / 20 % 2 == 1, settings, synthesiser);
            synthesiser.setSettings(settings);
            synthesiser.setTubeOpening(opening);
        });
        return std::abs(
            *std::ranges::max_element(sound, {}, [](float sample) { return std::abs(sample); }));
    };
    const auto check = [&](const auto& changeBefore) {
        const float open = loudest({}, changeBefore);
        CHECK(open > 0.01f);
        CHECK(loudest(closed(0), changeBefore) < 1e-6f * open);
    };
    SECTION("beyond the budget") {
        check([](bool leaves, SynthesisSettings& settings, Synthesiser&) {
            settings.modeBudget = leaves ? 1 : 2;
        });
    }
    SECTION("silenced") {
        check([](bool leaves, SynthesisSettings&, Synthesiser& synthesiser) {
            const std::array<std::uint8_t, 2> both{1, 1};
            synthesiser.setSilencedModes(0, leaves ? std::span(both)
                                                   : std::span<const std::uint8_t>());
        });
    }
    SECTION("below tau") {
        check([](bool leaves, SynthesisSettings& settings, Synthesiser&) {
            settings.tau = leaves ? 1e6 : 0;
        });
    }
    SECTION("out of band") {
        check([](bool leaves, SynthesisSettings& settings, Synthesiser&) {
            settings.frequencyRatio = leaves ? 0.01 : 1;
        });
    }
}

TEST_CASE("Discs act on shared modes only, even while other modes merge and split") {
    const std::vector<TimedStrike> strikes{{5.5, unitStrike()}};
    const auto heard = [&](bool withPair) {
        auto object = ringingObject(withPair ? std::vector<double>{200, 200.05, 300, 312, 1220}
                                             : std::vector<double>{200, 200.05, 1220},
                                    10);
        if (withPair)
            object.gains = {1, 1, sharedGain, -sharedGain, 1};
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        return render(synthesiser, strikes, 240, [&](int cell) {
            auto settings = exactSettings();
            settings.compression = cell / 20 % 2;
            synthesiser.setSettings(settings);
            synthesiser.setTubeOpening(closed(cell));
        });
    };
    const auto own = heard(false);
    CHECK(errorDb(heard(true), [&](double n) { return double(own[static_cast<std::size_t>(n)]); }) <
          -110);
}
