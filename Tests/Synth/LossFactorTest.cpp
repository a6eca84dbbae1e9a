// Tests structural damping in the sound: a constant Q, live changes, eq. 14 and the merging of
// modes.
#include "Support/PoleFit.h"
#include "Synth/ModalReference.h"
#include "Synth/ModeCompression.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRate = 48000;
constexpr double pi = std::numbers::pi;

ModalObject structurallyDamped(const std::vector<double>& frequenciesHz, double lossFactor) {
    ModalObject object = syntheticObject(frequenciesHz);
    object.material.damping = {.lossFactor = lossFactor};
    return object;
}

double fittedDecay(std::span<const float> signal, double hz) {
    return fitPole(signal, sampleRate, hz, 0.1).decayPerSecond;
}

int cellsOf(double seconds) {
    return static_cast<int>(seconds * sampleRate / cellSamples);
}

} // namespace

TEST_CASE("Modes of one loss factor have the same Q at three frequencies within 1 %") {
    const double lossFactor = 2e-3; // copper
    Synthesiser synthesiser({slotOf(structurallyDamped({220, 1000, 5000}, lossFactor))},
                            sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{0, unitStrike()}}, cellsOf(0.5));
    for (const double hz : {220.0, 1000.0, 5000.0}) {
        INFO(hz << " Hz");
        CHECK(fittedDecay(output, hz) == Approx(lossFactor * pi * hz).epsilon(0.01));
    }
}

TEST_CASE("The three damping laws sound like the closed form of their sum within -110 dB") {
    ModalObject object = syntheticObject({300});
    object.material.damping = {
        .fluidPerSecond = 4, .viscoelasticSeconds = 1e-6, .lossFactor = 0.02};
    const double omega = 2 * pi * 300;
    const ReferenceMode mode{omega * omega, 4 + 0.02 * omega + 1e-6 * omega * omega, 1};
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(exactSettings());
    const auto output = render(synthesiser, {{9.3, unitStrike()}}, 100);
    CHECK(errorDb(output, [&](double sample) {
              return impulseVelocity(mode, (sample - 9.3) / sampleRate);
          }) < -110);
}

TEST_CASE("A loss factor that is set while a mode rings changes its decay without a step") {
    const auto object = structurallyDamped({1000}, 0);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    auto settings = exactSettings();
    settings.material = LiveMaterial{.youngsModulusPa = object.material.youngsModulusPa,
                                     .densityKgPerM3 = object.material.densityKgPerM3,
                                     .damping = {.lossFactor = 1e-4}};
    synthesiser.setSettings(settings);
    const int change = cellsOf(0.4);
    const auto output = render(synthesiser, {{0, unitStrike()}}, 2 * change, [&](int cell) {
        if (cell != change)
            return;
        settings.material->damping.lossFactor = 4e-3;
        synthesiser.setSettings(settings);
    });
    const auto middle = static_cast<std::size_t>(change) * cellSamples;
    CHECK(fittedDecay(std::span(output).first(middle), 1000) ==
          Approx(1e-4 * pi * 1000).epsilon(0.01));
    CHECK(fittedDecay(std::span(output).subspan(middle), 1000) ==
          Approx(4e-3 * pi * 1000).epsilon(0.01));
    CHECK(broadbandDb(std::span(output).subspan(middle - 2048, 4096), sampleRate) < -80);
}

TEST_CASE("A structurally damped mode bent up an octave decays twice as fast, with the same Q") {
    Synthesiser synthesiser({slotOf(structurallyDamped({700}, 3e-3))}, sampleRate);
    auto settings = exactSettings();
    settings.frequencyRatio = 2;
    synthesiser.setSettings(settings);
    const auto output = render(synthesiser, {{0, unitStrike()}}, cellsOf(0.5));
    CHECK(fittedDecay(output, 1400) == Approx(3e-3 * pi * 1400).epsilon(0.01));
}

TEST_CASE(
    "A structurally damped mode is dropped within a cell of eq. 14's t_c for its own damping") {
    const double lossFactor = 0.01, hz = 2000;
    Synthesiser synthesiser({slotOf(structurallyDamped({hz}, lossFactor))}, sampleRate);
    auto settings = exactSettings();
    settings.tau = 65.536; // 1e-3 m/s
    synthesiser.setSettings(settings);
    // A unit impulse makes 2|c||ω⁺| = 1/√(1 − ζ²) with ζ = χ/2.
    const double zeta = lossFactor / 2;
    const double cutSeconds =
        std::log(1 / std::sqrt(1 - zeta * zeta) / 1e-3) / (lossFactor * pi * hz);
    const int cut = cellsOf(cutSeconds);
    std::vector<std::int64_t> ringing;
    render(synthesiser, {{0, unitStrike()}}, cut + 4, [&](int) {
        ringing.push_back(static_cast<std::int64_t>(synthesiser.status()[0].modesRinging));
    });
    CHECK(ringing[static_cast<std::size_t>(cut)] == 1);
    CHECK(ringing[static_cast<std::size_t>(cut) + 3] == 0);
}

TEST_CASE("Modes merge only if the loss factor makes them decay within their beat") {
    const auto groups = [](double lossFactor) {
        const std::vector<double> eigenvalues{std::pow(2 * pi * 2000, 2),
                                              std::pow(2 * pi * 2003, 2)};
        std::vector<std::int32_t> starts(3);
        return groupModes(eigenvalues, {.damping = {.lossFactor = lossFactor}}, 1, starts);
    };
    // 3 Hz apart at 2 kHz: Δω = 18.8 against α = χω/2.
    CHECK(groups(0.0029) == 2);
    CHECK(groups(0.0031) == 1);
}

TEST_CASE("A negative or non-finite loss factor leaves the material unchanged") {
    const auto object = structurallyDamped({440}, 1e-3);
    const auto play = [&](double lossFactor) {
        Synthesiser synthesiser({slotOf(object)}, sampleRate);
        auto settings = exactSettings();
        synthesiser.setSettings(settings);
        settings.material = LiveMaterial{.youngsModulusPa = object.material.youngsModulusPa,
                                         .densityKgPerM3 = object.material.densityKgPerM3,
                                         .damping = {.lossFactor = lossFactor}};
        synthesiser.setSettings(settings);
        return render(synthesiser, {{0, unitStrike()}}, 40);
    };
    const auto own = play(1e-3);
    CHECK(play(-1e-3) == own);
    CHECK(play(std::nan("")) == own);
    CHECK(play(std::numeric_limits<double>::infinity()) == own);
    CHECK(play(2e-3) != own);
}
