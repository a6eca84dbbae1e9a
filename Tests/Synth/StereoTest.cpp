// Tests radiation: the sound of the whole surface in two directions.
#include "ModalReference.h"
#include "Object/RadiationTable.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 44100;

ModalObject radiatingObject() {
    ModalObject object = ringingObject({300, 700, 1900}, 10);
    object.radiation.directions = {{0.8f, -0.6f, 0}, {0.8f, 0.6f, 0}};
    object.radiation.frequencyRatios = {0.5, 1, 2};
    object.radiation.weights = {
        0, 0, 0, {0.2f, 0.1f},  {0.1f, 0.5f}, {-0.1f, 0.3f}, 0.3f, 0.3f, 0.3f,
        0, 0, 0, {0.6f, -0.2f}, 0.1f,         {0, 0.4f},     0.3f, 0.3f, 0.3f};
    return object;
}

const std::array<std::complex<float>, 9> thirdWeights{0,    0,    0,    {-0.7f, 0.1f}, {0, -0.2f},
                                                      0.5f, 0.3f, 0.3f, 0.3f};

void addThirdDirection(ModalObject& object) {
    object.radiation.directions.push_back({0, 0, 1});
    object.radiation.weights.insert(object.radiation.weights.end(), thirdWeights.begin(),
                                    thirdWeights.end());
}

struct Stereo {
    std::vector<float> left, right;
};

Stereo play(const ModalObject& object, int cells, const std::function<double(int)>& radiationAt) {
    Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
    SynthesisSettings settings = exactSettings();
    Stereo sound;
    for (int c = 0; c < cells; ++c) {
        std::array<float, cellSamples> left{}, right{};
        const CellOutput cell(left, right);
        settings.radiation = radiationAt(c);
        synthesiser.setSettings(settings);
        synthesiser.beginCell(cell);
        if (c == 0 || c == 40)
            synthesiser.strike(0, unitStrike(c == 0 ? 0 : 0.003), 0, cell);
        sound.left.insert(sound.left.end(), left.begin(), left.end());
        sound.right.insert(sound.right.end(), right.begin(), right.end());
    }
    return sound;
}

double reference(const ModalObject& object, std::size_t direction, double share, double sample) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto weight = -object.radiation.weights[9 * direction + 3 + i];
        const std::complex<double> residue = phasorBetween(1, weight, static_cast<float>(share));
        const double hz = std::sqrt(object.eigenvalues[i]) / (2 * std::numbers::pi);
        sum += impulseVelocity(referenceMode(object.material, hz, residue), sample / sampleRate);
    }
    return sum;
}

} // namespace

TEST_CASE("Each channel has its own direction's weights, at the requested share") {
    const ModalObject object = radiatingObject();
    for (const double share : {1.0, 0.4}) {
        const Stereo sound = play(object, 40, [&](int) { return share; });
        CHECK(errorDb(sound.left, [&](double n) { return reference(object, 0, share, n); }) < -110);
        CHECK(errorDb(sound.right, [&](double n) { return reference(object, 1, share, n); }) <
              -110);
    }
}

TEST_CASE("A strike with a direction sounds the same in every channel and does not affect later "
          "strikes") {
    ModalObject object = radiatingObject();
    addThirdDirection(object);
    SynthesisSettings settings = exactSettings();
    settings.radiation = 1;
    for (const std::size_t channels : {1u, 2u}) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate, channels);
        synthesiser.setSettings(settings);
        std::vector<float> first, second;
        for (int c = 0; c < 40; ++c) {
            std::array<float, cellSamples> left{}, right{};
            const CellOutput cell = channels == 1 ? CellOutput(left) : CellOutput(left, right);
            synthesiser.beginCell(cell);
            Strike strike = unitStrike();
            strike.point.radiationDirection = c == 0 ? 2 : 3;
            CHECK(synthesiser.strike(0, strike, 0, cell) ==
                  (c == 0)); // a fourth direction does not exist
            strike.point.radiationDirection = -1;
            if (c == 20)
                synthesiser.strike(0, strike, 0, cell);
            auto& sound = c < 20 ? first : second;
            sound.insert(sound.end(), left.begin(), left.end());
            if (channels == 2 && c < 20)
                CHECK(left == right);
        }
        CHECK(errorDb(first, [&](double n) { return reference(object, 2, 1, n); }) < -110);
        CHECK(errorDb(second, [&](double n) {
                  const double own =
                      channels == 2 ? reference(object, 0, 1, n)
                                    : (reference(object, 0, 1, n) + reference(object, 1, 1, n)) / 2;
                  return own + reference(object, 2, 1, n + 20 * cellSamples);
              }) < -110);
    }
}

TEST_CASE("Simultaneous strikes are each heard from their own direction") {
    ModalObject object = radiatingObject();
    addThirdDirection(object);
    const auto played = [&](bool first, bool second) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate, 1);
        SynthesisSettings settings = exactSettings();
        settings.radiation = 1;
        std::vector<float> sound;
        for (int c = 0; c < 30; ++c) {
            std::array<float, cellSamples> cell{};
            settings.frequencyRatio = c < 6 ? 1 : 1.01; // contacts follow the moving poles
            synthesiser.setSettings(settings);
            synthesiser.beginCell(CellOutput(cell));
            Strike strike = unitStrike(0.012);
            strike.point.radiationDirection = c == 1 ? 2 : 0;
            if ((c == 1 && first) || (c == 3 && second))
                synthesiser.strike(0, strike, 5, CellOutput(cell));
            sound.insert(sound.end(), cell.begin(), cell.end());
        }
        return sound;
    };
    const auto both = played(true, true), one = played(true, false), other = played(false, true);
    double worst = 0, peak = 0;
    for (std::size_t n = 0; n < both.size(); ++n) {
        worst = larger(worst, std::abs(double(both[n]) - double(one[n]) - double(other[n])));
        peak = larger(peak, std::abs(double(both[n])));
    }
    CHECK(worst < 1e-5 * peak);
    CHECK(peak > 0);
}

TEST_CASE("A force with a radiation direction sounds as heard from that direction") {
    ModalObject all = radiatingObject(), alone = radiatingObject();
    addThirdDirection(all);
    alone.radiation.weights.assign(thirdWeights.begin(), thirdWeights.end());
    alone.radiation.weights.insert(alone.radiation.weights.end(), thirdWeights.begin(),
                                   thirdWeights.end());
    const auto pressed = [](const ModalObject& object, std::int32_t radiationDirection) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate, 1);
        SynthesisSettings settings = exactSettings();
        settings.radiation = 1;
        synthesiser.setSettings(settings);
        std::vector<float> sound;
        for (int c = 0; c < 20; ++c) {
            std::array<float, cellSamples> cell{}, newtons{};
            for (std::size_t i = 0; i < cellSamples; ++i)
                newtons[i] = static_cast<float>((c * 64 + static_cast<int>(i)) * 7919 % 101) / 101;
            synthesiser.beginCell(CellOutput(cell));
            ForcePlace place;
            place.points[0].point.radiationDirection = radiationDirection;
            CHECK(synthesiser.applyForce(
                0, {.contact = 0, .start = place, .end = place, .newtons = newtons},
                CellOutput(cell)));
            sound.insert(sound.end(), cell.begin(), cell.end());
        }
        return sound;
    };
    const auto found = pressed(all, 2), expected = pressed(alone, -1), own = pressed(all, -1);
    double worst = 0, peak = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
        worst = larger(worst, std::abs(double(found[n]) - double(expected[n])));
        peak = larger(peak, std::abs(double(found[n])));
    }
    CHECK(worst < 1e-5 * peak);
    CHECK(found != own);
}

TEST_CASE("An object heard from nearby sounds the same in both channels as in mono") {
    const ModalObject object = radiatingObject();
    const Stereo sound = play(object, 60, [](int) { return 0.0; });
    CHECK(sound.left == sound.right);
    Synthesiser mono({slotOf(object)}, sampleRate);
    mono.setSettings(exactSettings());
    CHECK(sound.left == render(mono, {{0, unitStrike()}, {40 * 64, unitStrike(0.003)}}, 60));
}

TEST_CASE("A second strike heard from afar leaves the ringing sound unchanged") {
    const ModalObject object = radiatingObject();
    const auto later = [](int cell) { return cell < 20 ? 0.0 : 1.0; };
    const Stereo sound = play(object, 80, later);
    const Stereo near = play(object, 80, [](int) { return 0.0; });
    const Stereo alone = play(object, 80, [](int) { return 1.0; });
    for (std::size_t n = 0; n < 40 * 64; ++n)
        REQUIRE(sound.left[n] == near.left[n]);
    // Compare from the second strike on: the first one is heard from nearby, the second one from
    // afar.
    double worst = 0, peak = 0;
    for (std::size_t n = 40 * 64; n < sound.left.size(); ++n) {
        const double first = reference(object, 0, 0, double(n));
        const double firstFar = reference(object, 0, 1, double(n));
        const double expected = first + double(alone.left[n]) - firstFar;
        worst = larger(worst, std::abs(double(sound.left[n]) - expected));
        peak = larger(peak, std::abs(expected));
    }
    CHECK(worst < 1e-5 * peak);
    CHECK(sound.left != sound.right);
}

TEST_CASE("A contact's force sounds at once, and its motion sounds through complex weights") {
    const ModalObject object = radiatingObject();
    for (const double milliseconds : {0.4, 3.0, 20.0}) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
        SynthesisSettings settings = exactSettings();
        settings.radiation = 1;
        synthesiser.setSettings(settings);
        std::vector<float> sound;
        for (int c = 0; c < 40; ++c) {
            std::array<float, cellSamples> left{}, right{};
            const CellOutput cell(left, right);
            synthesiser.beginCell(cell);
            if (c == 0)
                synthesiser.strike(0, unitStrike(milliseconds / 1000), 2.25, cell);
            sound.insert(sound.end(), left.begin(), left.end());
        }
        CHECK(errorDb(sound, [&](double n) {
                  double sum = 0;
                  for (std::size_t i = 0; i < 3; ++i) {
                      const double hz = std::sqrt(object.eigenvalues[i]) / (2 * std::numbers::pi);
                      sum += pulseVelocity(
                          referenceMode(object.material, hz,
                                        -std::complex<double>(object.radiation.weights[3 + i])),
                          milliseconds / 1000, (n - 2.25) / sampleRate);
                  }
                  return sum;
              }) < -95);
    }
}

TEST_CASE("A constant force is silent from afar, because pressure follows acceleration") {
    const ModalObject object = radiatingObject();
    Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
    SynthesisSettings settings = exactSettings();
    settings.radiation = 1;
    synthesiser.setSettings(settings);
    double loudest = 0, last = 0;
    for (int c = 0; c < 1400; ++c) { // a ramp of 0.15 s to 1 N, then constant
        std::array<float, cellSamples> left{}, right{}, newtons{};
        for (std::size_t i = 0; i < cellSamples; ++i)
            newtons[i] = std::min(1.0f, static_cast<float>(c * 64 + static_cast<int>(i)) / 6615);
        const CellOutput cell(left, right);
        synthesiser.beginCell(cell);
        ForcePlace place;
        REQUIRE(synthesiser.applyForce(
            0, {.contact = 0, .start = place, .end = place, .newtons = newtons}, cell));
        for (const float sample : left) {
            loudest = larger(loudest, std::abs(double(sample)));
            last = c == 1399 ? larger(last, std::abs(double(sample))) : 0;
        }
    }
    CHECK(loudest > 0);
    CHECK(last < 1e-3 * loudest);
}

TEST_CASE("A blend of near and far has the blended magnitude at any phase difference") {
    for (double turn = 0; turn < 2 * std::numbers::pi; turn += 0.1)
        for (const float share : {0.0f, 0.2f, 0.5f, 0.7f, 1.0f}) {
            const std::complex<float> near(2, 0), far = std::polar(3.0f, static_cast<float>(turn));
            CHECK(std::abs(std::abs(phasorBetween(near, far, share)) - (2 + share)) < 1e-5f);
        }
}

TEST_CASE("A complex gain turns the phase of the near sound") {
    ModalObject object = ringingObject({440}, 10);
    object.gains = {{0.5f, -0.25f}};
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto sound = render(synthesiser, {{0, unitStrike(0.002)}}, 40);
    const auto mode = referenceMode(object.material, 440, {0.5, -0.25});
    CHECK(errorDb(sound, [&](double n) { return pulseVelocity(mode, 0.002, n / sampleRate); }) <
          -95);
}

TEST_CASE("Radiation weights are read at the current frequency times size") {
    const ModalObject object = radiatingObject();
    Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
    SynthesisSettings settings = exactSettings();
    settings.radiation = 1;
    settings.frequencyRatio = 2;
    synthesiser.setSettings(settings);
    std::array<float, cellSamples> left{}, right{};
    synthesiser.beginCell(CellOutput(left, right));
    synthesiser.strike(0, unitStrike(), 0, CellOutput(left, right));
    CHECK(std::abs(double(left[0]) + 3 * 0.3) < 1e-5);
    CHECK(left == right);
}

TEST_CASE("Weights that move during a contact cause no step") {
    ModalObject object = radiatingObject();
    for (std::size_t k = 0; k < 18; ++k)
        object.radiation.weights[k] = std::complex<float>(k / 3 % 3 == 1   ? 0.1f
                                                          : k / 3 % 3 == 2 ? 0.9f
                                                                           : 0.0f,
                                                          k / 3 % 3 == 2 ? 0.5f : 0.2f);
    // The frequency moves weights and poles; together with the size it moves the weights only.
    for (const bool polesMove : {true, false}) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
        SynthesisSettings settings = exactSettings();
        settings.radiation = 1;
        std::vector<float> sound;
        for (int c = 0; c < 12; ++c) {
            std::array<float, cellSamples> left{}, right{};
            const CellOutput cell(left, right);
            if (c == 4) {
                settings.frequencyRatio = 1.5;
                settings.sizeRatio = polesMove ? 1 : 1.5;
            }
            synthesiser.setSettings(settings);
            synthesiser.beginCell(cell);
            if (c == 0)
                synthesiser.strike(0, unitStrike(0.0122), 0, cell);
            sound.insert(sound.end(), left.begin(), left.end());
        }
        double steepest = 0;
        for (std::size_t n = 1; n < sound.size(); ++n)
            if (n != 4 * 64)
                steepest = larger(steepest, std::abs(double(sound[n]) - double(sound[n - 1])));
        const double step = std::abs(double(sound[4 * 64]) - double(sound[4 * 64 - 1]));
        CHECK(step < 0.05 * steepest);
    }
}

TEST_CASE("A two-channel fade stays in both channels when the object is struck in a new tuning") {
    ModalObject object = radiatingObject();
    object.radiation.weights = {1, 1, 1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
    Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
    SynthesisSettings settings = exactSettings();
    settings.radiation = 1;
    double loudest = 0;
    for (int c = 0; c < 30; ++c) {
        std::array<float, cellSamples> left{}, right{};
        const CellOutput cell(left, right);
        if (c == 20) { // all modes fade, and their frequencies move
            settings.tau = 100 / pascalsPerTau;
            settings.frequencyRatio = 1.001;
        }
        synthesiser.setSettings(settings);
        synthesiser.beginCell(cell);
        Strike faint = unitStrike(1e-3);
        faint.impulseNewtonSeconds[2] = -1e-9f;
        if (c == 0 || c == 20)
            synthesiser.strike(0, c == 0 ? unitStrike() : faint, 10, cell);
        for (std::size_t k = 0; k < cellSamples; ++k) {
            REQUIRE(std::abs(double(left[k]) + double(right[k])) < 1e-5);
            if (c == 21)
                loudest = larger(loudest, std::abs(double(right[k])));
        }
    }
    CHECK(loudest > 0.01);
}

TEST_CASE("A silent object returns to one channel when its next strike is heard from nearby") {
    std::vector<double> frequencies;
    for (int k = 0; k < 1000; ++k)
        frequencies.push_back(100 + 20 * k);
    ModalObject object = ringingObject(frequencies, 60);
    object.radiation.directions = {{1, 0, 0}, {0, 1, 0}};
    object.radiation.frequencyRatios = {1};
    object.radiation.weights.assign(2000, 0.5f);
    Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
    std::array<float, cellSamples> left{}, right{};
    const CellOutput cell(left, right);
    SynthesisSettings settings = exactSettings();
    settings.tau = 1;
    const auto strikeHeardFrom = [&](double radiation) {
        settings.radiation = radiation;
        synthesiser.setSettings(settings);
        synthesiser.beginCell(cell);
        synthesiser.strike(0, unitStrike(), 0, cell);
        synthesiser.beginCell(cell);
        return synthesiser.status()[0].channels;
    };
    CHECK(strikeHeardFrom(1) == 2);
    for (int c = 0; c < 2000 && !synthesiser.silent(); ++c)
        synthesiser.beginCell(cell);
    REQUIRE(synthesiser.silent());
    CHECK(strikeHeardFrom(0) == 1);
}
