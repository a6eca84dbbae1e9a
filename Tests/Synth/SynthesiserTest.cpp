// Compares the synthesiser's sound with equations 6 to 11, evaluated directly.
#include "Synth/Synthesiser.h"
#include "ModalReference.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 44100;

} // namespace

TEST_CASE("Modes of 30 Hz, 440 Hz and 15 kHz follow eq. 6 to 11 for 10 s within -110 dB") {
    const double hz = GENERATE(30.0, 440.0, 15000.0);
    const ModalObject object = ringingObject({hz});
    const ReferenceMode mode = referenceMode(object.material, hz, 1);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{0, unitStrike()}}, 7000);
    const auto expected = [&](double sample) { return impulseVelocity(mode, sample / sampleRate); };
    CHECK(errorDb(output, expected) < -110);
    CHECK(errorDb(output, expected, 441000) < -110);
}

TEST_CASE("A hundred modes together follow the closed form within -110 dB") {
    std::vector<double> frequencies;
    std::vector<ReferenceMode> modes;
    for (int k = 0; k < 100; ++k)
        frequencies.push_back(50 + 200.7 * k);
    const ModalObject object = syntheticObject(frequencies);
    for (const double hz : frequencies)
        modes.push_back(referenceMode(object.material, hz, 1));
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{0, unitStrike()}}, 700);
    CHECK(errorDb(output, [&](double sample) {
              double sum = 0;
              for (const ReferenceMode& mode : modes)
                  sum += impulseVelocity(mode, sample / sampleRate);
              return sum;
          }) < -110);
}

TEST_CASE("A strike at any sample, whole or fractional, acts at that sample") {
    const double start = GENERATE(0.0, 1.0, 15.0, 16.0, 63.0, 0.25, 17.5, 63.999, 130.125);
    const ModalObject object = syntheticObject({440, 3210});
    const ReferenceMode low = referenceMode(object.material, 440, 1);
    const ReferenceMode high = referenceMode(object.material, 3210, 1);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{start, unitStrike()}}, 40);
    CHECK(errorDb(output, [&](double sample) {
              const double t = (sample - start) / sampleRate;
              return impulseVelocity(low, t) + impulseVelocity(high, t);
          }) < -110);
}

TEST_CASE("Overlapping raised-cosine strikes equal quadrature of the convolution within -100 dB") {
    // Contacts within a cell, across a boundary, and longer than several cells.
    const double contactSeconds = GENERATE(5e-5, 1e-4, 4.7e-4, 2.3e-3, 6.4e-3);
    const ModalObject object = syntheticObject({97, 440, 5000});
    std::vector<ReferenceMode> modes;
    for (const double hz : {97.0, 440.0, 5000.0})
        modes.push_back(referenceMode(object.material, hz, 1));
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const std::vector<double> starts{3, 62.4, 100.7, 131, 300.5};
    std::vector<TimedStrike> strikes;
    for (const double start : starts)
        strikes.push_back({start, unitStrike(contactSeconds)});
    const auto output = render(synthesiser, strikes, 16);
    CHECK(errorDb(output, [&](double sample) {
              double sum = 0;
              for (const double start : starts)
                  for (const ReferenceMode& mode : modes)
                      sum += pulseVelocity(mode, contactSeconds, (sample - start) / sampleRate);
              return sum;
          }) < -100);
}

TEST_CASE("Contacts and impulses under a damper equal damped quadrature within -100 dB") {
    const ModalObject object = syntheticObject({440, 2000});
    std::vector<ReferenceMode> modes;
    for (const double hz : {440.0, 2000.0})
        modes.push_back(referenceMode(object.material, hz, 1));
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    synthesiser.setDamping(0, 150);
    const double contactSeconds = 3.1e-3;
    const auto output =
        render(synthesiser, {{20.5, unitStrike(contactSeconds)}, {200, unitStrike()}}, 14);
    CHECK(errorDb(output, [&](double sample) {
              double sum = 0;
              const double later = (sample - 200) / sampleRate;
              for (const ReferenceMode& mode : modes)
                  sum += pulseVelocity(mode, contactSeconds, (sample - 20.5) / sampleRate, 150) +
                         impulseVelocity(mode, later) * std::exp(-150 * later);
              return sum;
          }) < -100);
}

TEST_CASE("A damper multiplies ringing modes by exp(-dt) from its grid point until it lifts") {
    const ModalObject object = syntheticObject({440, 1234});
    const auto play = [&](bool damped) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        synthesiser.setSettings(exactSettings());
        return render(synthesiser, {{0, unitStrike()}}, 60, [&](int cell) {
            if (damped && cell == 10)
                synthesiser.setDamping(0, 80);
            if (damped && cell == 40)
                synthesiser.setDamping(0, 0);
        });
    };
    const auto free = play(false);
    const auto damped = play(true);
    CHECK(errorDb(damped, [&](double sample) {
              const double held = std::clamp(sample - 640, 0.0, 1920.0) / sampleRate;
              return static_cast<double>(free[static_cast<std::size_t>(sample)]) *
                     std::exp(-80 * held);
          }) < -120);
}

TEST_CASE("Over-damped and critically damped modes follow the closed form within -110 dB") {
    // √λ = 2π 100; damping ratios from just below critical to far beyond.
    const double ratio = GENERATE(0.99, 0.999, 1.001, 1.5, 20.0);
    ModalObject object = syntheticObject({100});
    object.material.damping.fluidPerSecond = 2 * ratio * 2 * std::numbers::pi * 100;
    object.material.damping.viscoelasticSeconds = 0;
    const ReferenceMode mode = referenceMode(object.material, 100, 1);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{9.3, unitStrike()}}, 60);
    CHECK(errorDb(output, [&](double sample) {
              return impulseVelocity(mode, (sample - 9.3) / sampleRate);
          }) < -110);
}

TEST_CASE("A degenerate pair sounds the same in any basis") {
    const double angle = GENERATE(0.3, 0.9, 2.2);
    const auto play = [](double turn) {
        ModalObject object = syntheticObject({440, 440});
        // Two shapes in the x-z plane, rotated into each other.
        for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
            float* shape = object.shapes.data() + row * 6;
            const double c = std::cos(turn);
            const double s = std::sin(turn);
            const std::array first{0.8, 0.0, 0.3};
            const std::array second{-0.2, 0.0, 0.9};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                shape[axis] = static_cast<float>(c * first[axis] + s * second[axis]);
                shape[3 + axis] = static_cast<float>(-s * first[axis] + c * second[axis]);
            }
        }
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        synthesiser.setSettings(exactSettings());
        Strike strike = unitStrike();
        strike.impulseNewtonSeconds = {0.5f, 0, -1};
        const auto output = render(synthesiser, {{0, strike}}, 100);
        REQUIRE(synthesiser.status()[0].modesRinging == 1);
        return output;
    };
    const auto straight = play(0);
    const auto turned = play(angle);
    CHECK(errorDb(turned, [&](double sample) {
              return double(straight[static_cast<std::size_t>(sample)]);
          }) < -130);
}

TEST_CASE("A strike between vertices uses the weighted shape, and zero weights read no row") {
    ModalObject object = ringingObject({440});
    for (std::size_t row = 0; row < 4; ++row)
        object.shapes[row * 3 + 2] = static_cast<float>(row);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    Strike strike = unitStrike();
    strike.point.shapeRows = {1, 3, 99};
    strike.point.weights = {0.75f, 0.25f, 0};
    const auto output = render(synthesiser, {{0, strike}}, 2);
    CHECK(std::abs(output[0] - 2.25f) < 1e-6f); // (0.75 · 1 + 0.25 · 3)²
}

TEST_CASE("A strike straight into the surface starts positive, whatever the shape's sign") {
    for (const float gain : {1.0f, -1.0f}) {
        Synthesiser synthesiser({slotOf(ringingObject({440}, 1, {gain}))}, sampleRate);
        const auto output = render(synthesiser, {{0, unitStrike()}}, 1);
        CHECK(output[0] > 0.99f);
    }
}

TEST_CASE("Repeated equal settings change no bit of the output") {
    const auto play = [](bool again) {
        Synthesiser synthesiser({slotOf(syntheticObject({440, 441, 2000}))}, sampleRate);
        SynthesisSettings settings;
        settings.tau = 0.5;
        synthesiser.setSettings(settings);
        synthesiser.setFrequencyRatio(0, 1.01);
        return render(synthesiser, {{3.3, unitStrike(1e-3)}, {700, unitStrike()}}, 400, [&](int) {
            if (!again)
                return;
            synthesiser.setSettings(settings);
            synthesiser.setFrequencyRatio(0, 1.01);
            synthesiser.setDamping(0, 0);
        });
    };
    CHECK(play(true) == play(false));
}

TEST_CASE("Slots that share an object sound independently and add up") {
    const auto object = std::make_shared<const ModalObject>(syntheticObject({440}));
    const auto play = [&](std::vector<TimedStrike> strikes) {
        Synthesiser synthesiser({{object, 1}, {object, 0.5}}, sampleRate);
        synthesiser.setSettings(exactSettings());
        return render(synthesiser, strikes, 30);
    };
    const auto first = play({{0, unitStrike(), 0}});
    const auto second = play({{70, unitStrike(), 1}});
    const auto both = play({{0, unitStrike(), 0}, {70, unitStrike(), 1}});
    CHECK(errorDb(both, [&](double sample) {
              const auto k = static_cast<std::size_t>(sample);
              return double(first[k]) + double(second[k]);
          }) < -130);
}

TEST_CASE("The 65th contact is refused and an ideal impulse is still accepted") {
    Synthesiser synthesiser({slotOf(syntheticObject({440}))}, sampleRate);
    std::array<float, cellSamples> cell{};
    synthesiser.beginCell(cell);
    for (int k = 0; k < 64; ++k)
        REQUIRE(synthesiser.strike(0, unitStrike(0.01), k, cell));
    const auto before = cell;
    CHECK_FALSE(synthesiser.strike(0, unitStrike(0.01), 0, cell));
    CHECK(cell == before);
    CHECK(synthesiser.strike(0, unitStrike(), 0, cell));
    for (int k = 0; k < 10; ++k)
        synthesiser.beginCell(cell);
    CHECK(synthesiser.strike(0, unitStrike(0.01), 0, cell));
}

TEST_CASE("Invalid strikes and settings are refused without effect") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    Synthesiser synthesiser({slotOf(syntheticObject({440})), {nullptr, 1}, slotOf({})}, sampleRate);
    std::array<float, cellSamples> cell{};
    synthesiser.beginCell(cell);
    Strike strike = unitStrike();
    CHECK_FALSE(synthesiser.strike(7, strike, 0, cell));
    CHECK_FALSE(synthesiser.strike(1, strike, 0, cell));
    CHECK_FALSE(synthesiser.strike(2, strike, 0, cell));
    CHECK_FALSE(synthesiser.strike(0, strike, 64, cell));
    CHECK_FALSE(synthesiser.strike(0, strike, -1, cell));
    CHECK_FALSE(synthesiser.strike(0, unitStrike(-1), 0, cell));
    strike.impulseNewtonSeconds[2] = nan;
    CHECK_FALSE(synthesiser.strike(0, strike, 0, cell));
    strike = unitStrike();
    strike.point.shapeRows[0] = 4;
    CHECK_FALSE(synthesiser.strike(0, strike, 0, cell));
    CHECK(synthesiser.silent());

    SynthesisSettings settings;
    settings.tau = std::numeric_limits<double>::quiet_NaN();
    settings.modeBudget = -1;
    settings.frequencyRatio = 0;
    settings.sizeRatio = std::numeric_limits<double>::infinity();
    settings.material = LiveMaterial{1e10, -1000, {5, 0}};
    synthesiser.setSettings(settings);
    synthesiser.setDamping(0, -1);
    synthesiser.setFrequencyRatio(0, std::numeric_limits<double>::quiet_NaN());
    const auto output = render(synthesiser, {{0, unitStrike()}}, 10);
    const ReferenceMode mode = referenceMode(syntheticObject({440}).material, 440, 1);
    CHECK(errorDb(output, [&](double sample) {
              return impulseVelocity(mode, sample / sampleRate);
          }) < -110);
}

TEST_CASE("A strike that would move a mode absurdly fast is refused, and ringing modes ring on") {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const float shape = GENERATE_COPY(1.1e9f, -3e20f, 3e38f, infinity, nan);
    const double seconds = GENERATE(0.0, 0.001, 0.02);
    ModalObject object = syntheticObject({440, 900, 901});
    object.shapes[9 + 5] = shape; // of the second mode at row 1
    Strike impact = unitStrike(seconds);
    Synthesiser played({slotOf(object)}, sampleRate), spared({slotOf(object)}, sampleRate);
    for (int c = 0; c < 200; ++c) {
        std::array<float, cellSamples> sound{}, expected{};
        played.beginCell(sound);
        spared.beginCell(expected);
        if (c % 50 == 0) {
            CHECK(played.strike(0, impact, 3.5, sound));
            CHECK(spared.strike(0, impact, 3.5, expected));
        }
        auto bad = impact;
        bad.point.shapeRows[0] = 1;
        bad.impulseNewtonSeconds[2] = -0.1f;
        CHECK_FALSE(played.strike(0, bad, 7, sound));
        bad.point.shapeRows[0] = 0;
        bad.impulseNewtonSeconds[2] = 3e38f;
        CHECK_FALSE(played.strike(0, bad, 7, sound));
        REQUIRE(sound == expected);
    }
    CHECK_FALSE(spared.silent());
}

TEST_CASE("The hardest accepted strikes give finite sound in any number") {
    const double seconds = GENERATE(0.0, 0.001);
    const double damping = GENERATE(0.0, 1e4);
    ModalObject object =
        syntheticObject({30, 440, 441, 15'000}, std::vector<float>(4, largestShape));
    object.radiation = {{{0, 0, 1}, {1, 0, 0}},
                        {1},
                        {largestShape, 1, 1e-30f, 0, 1, largestShape, -1e-30f, 1e-38f}};
    Synthesiser synthesiser({slotOf(object)}, sampleRate, 2);
    auto settings = exactSettings();
    settings.compression = 1;
    settings.radiation = 0.5;
    synthesiser.setSettings(settings);
    Strike hardest = unitStrike(seconds);
    hardest.impulseNewtonSeconds[2] = -5; // a mallet of 0.5 kg at 10 m/s
    std::array<float, cellSamples> left{}, right{}, newtons{};
    newtons.fill(1e12f);
    const auto isFinite = [](float x) { return std::isfinite(x); };
    int taken = 0;
    for (int c = 0; c < 4000; ++c) {
        synthesiser.setDamping(0, c > 1000 ? damping : 0);
        synthesiser.beginCell({left, right});
        for (int k = 0; k < 30 && c < 500; ++k)
            taken += synthesiser.strike(0, hardest, k, {left, right}) ? 1 : 0;
        if (c >= 300 && c < 500) {
            const ForcePlace place{.points = {ForcePoint{.point = hardest.point}}};
            CHECK(synthesiser.applyForce(0, {.start = place, .end = place, .newtons = newtons},
                                         {left, right}));
        }
        REQUIRE(std::ranges::all_of(left, isFinite));
        REQUIRE(std::ranges::all_of(right, isFinite));
    }
    CHECK(taken > 500);
}

TEST_CASE("Reset silences at once and the object then plays like a new one") {
    const ModalObject object = syntheticObject({440, 1000});
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    const auto first = render(synthesiser, {{0, unitStrike(2e-3)}}, 50);
    render(synthesiser, {{5, unitStrike(0.1)}}, 3);
    synthesiser.reset();
    CHECK(synthesiser.silent());
    CHECK(render(synthesiser, {{0, unitStrike(2e-3)}}, 50) == first);
}
