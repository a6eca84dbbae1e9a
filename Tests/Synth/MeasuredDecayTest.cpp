// Tests modes with measured decays: their sound, live changes and the merging of modes.
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

ModalObject measured(const std::vector<double>& frequenciesHz,
                     const std::vector<double>& decaysPerSecond) {
    ModalObject object = syntheticObject(frequenciesHz);
    object.decaysPerSecond = decaysPerSecond;
    return object;
}

std::vector<float> rendered(const ModalObject& object, const SynthesisSettings& settings) {
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    synthesiser.setSettings(settings);
    return render(synthesiser, {{0, unitStrike()}}, static_cast<int>(0.5 * sampleRate / 64));
}

double fittedDecay(std::span<const float> signal, double hz) {
    return fitPole(signal, sampleRate, hz, 0.1).decayPerSecond;
}

double eigenvalue(double hz) {
    return std::pow(2 * pi * hz, 2);
}

std::size_t groups(const std::vector<double>& frequenciesHz,
                   const std::vector<double>& dampingScales,
                   double compression) {
    std::vector<double> eigenvalues;
    for (const double hz : frequenciesHz)
        eigenvalues.push_back(eigenvalue(hz));
    std::vector<ModeDamping> dampings;
    for (const double scale : dampingScales)
        dampings.push_back({.scale = scale});
    std::vector<std::int32_t> starts(eigenvalues.size() + 1);
    return groupModes(eigenvalues, {.damping = {.fluidPerSecond = 30}}, compression, starts,
                      dampings);
}

} // namespace

TEST_CASE("Each mode decays as measured, whatever the material's law, within 1 %") {
    const auto output = rendered(measured({220, 1000, 5000}, {12, 3, 7}), exactSettings());
    CHECK(fittedDecay(output, 220) == Approx(12).epsilon(0.01));
    CHECK(fittedDecay(output, 1000) == Approx(3).epsilon(0.01));
    CHECK(fittedDecay(output, 5000) == Approx(7).epsilon(0.01));
}

TEST_CASE("A measured decay changes by the ratio of the laws in another material") {
    const auto object = measured({500, 2000}, {8, 5});
    auto settings = exactSettings();
    settings.material = LiveMaterial{.youngsModulusPa = 4 * object.material.youngsModulusPa,
                                     .densityKgPerM3 = object.material.densityKgPerM3,
                                     .damping = {.fluidPerSecond = 3, .lossFactor = 1e-3}};
    const auto output = rendered(object, settings);
    for (std::size_t i = 0; i < 2; ++i) {
        const double hz = i == 0 ? 500 : 2000;
        const double before = object.material.damping.perSecond(eigenvalue(hz));
        const double now = settings.material->damping.perSecond(4 * eigenvalue(hz));
        CHECK(fittedDecay(output, 2 * hz) ==
              Approx(object.decaysPerSecond[i] * now / before).epsilon(0.01));
    }
}

TEST_CASE("Measured decays equal to the law's sound like the law, to rounding") {
    auto object = syntheticObject({220, 1000, 1001, 5000});
    const auto plain = rendered(object, exactSettings());
    for (const double value : object.eigenvalues)
        object.decaysPerSecond.push_back(object.material.damping.perSecond(value) / 2);
    const auto given = rendered(object, exactSettings());
    REQUIRE(plain.size() == given.size());
    float largest = 0;
    for (std::size_t n = 0; n < plain.size(); ++n)
        largest = larger(largest, std::abs(plain[n] - given[n]));
    CHECK(largest <= 1e-6f);
}

TEST_CASE("Modes of similar decays merge, and modes of audibly different decays do not") {
    CHECK(groups({1000, 1000.5}, {1, 1.3}, 1) == 1);
    CHECK(groups({1000, 1000.5}, {1, 0.75}, 1) == 1);
    CHECK(groups({1000, 1000.5}, {1, 1.5}, 1) == 2);
    CHECK(groups({1000, 1000.5}, {1, 0.6}, 1) == 2);
    CHECK(groups({1000, 1000}, {1, 2}, 1) == 2);
    CHECK(groups({1000, 1000}, {2, 2}, 0) == 1);
}

TEST_CASE("An extra decay is independent of the material and grows with the frequency") {
    auto object = syntheticObject({500});
    object.material.damping = {.fluidPerSecond = 6};
    object.extraDecaysPerSecond = {5};
    auto settings = exactSettings();
    CHECK(fittedDecay(rendered(object, settings), 500) == Approx(3 + 5).epsilon(0.01));
    settings.material = LiveMaterial{.youngsModulusPa = object.material.youngsModulusPa,
                                     .densityKgPerM3 = object.material.densityKgPerM3,
                                     .damping = {.fluidPerSecond = 2}};
    CHECK(fittedDecay(rendered(object, settings), 500) == Approx(1 + 5).epsilon(0.01));
    settings.frequencyRatio = 2;
    CHECK(fittedDecay(rendered(object, settings), 1000) == Approx(1 + 10).epsilon(0.01));
}

TEST_CASE("A group decays by the weighted mean of its members") {
    const std::vector<double> weights{3, 1};
    const std::vector<ModeDamping> dampings{{1, 0}, {1.3, 8}}, alike{{1.7, 2}, {1.7, 2}};
    CHECK(mergedDamping(dampings, weights).scale == Approx(1.075));
    CHECK(mergedDamping(dampings, weights).extraPerSecond == Approx(2));
    CHECK(mergedDamping(alike, weights) == alike.front());
    // Modes whose shapes are zero everywhere have no weight.
    CHECK(mergedDamping(dampings, std::vector<double>{0, 0}) == dampings.front());
}
