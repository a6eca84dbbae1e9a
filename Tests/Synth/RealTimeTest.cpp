#include "ModalReference.h"
#include "Support/AllocationCounter.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE(
    "Strikes, forces, cells, regrouping, every setting, silencing and reports allocate nothing") {
    std::vector<double> frequencies;
    for (int k = 0; k < 200; ++k)
        frequencies.push_back(100 + 60 * (k / 2) + 0.2 * (k % 2));
    ModalObject object = syntheticObject(frequencies);
    object.radiation.directions = {{1, 0, 0}, {0, 1, 0}};
    object.radiation.frequencyRatios = {1};
    object.radiation.weights.assign(400, 0.1f);
    object.gains.assign(200, 1);
    object.gains[2] = object.gains[7] = object.gains[90] = 2;
    Synthesiser synthesiser({slotOf(object), slotOf(syntheticObject(frequencies), 0.7)}, 48000, 2);
    std::array<float, cellSamples> left{}, right{}, newtons;
    newtons.fill(0.1f);
    const CellOutput cell(left, right);
    SynthesisSettings settings;
    settings.material = LiveMaterial{1e10, 1000, {30, 1e-7}};
    SoundingGroups groups(200);
    std::array<std::uint8_t, 200> silenced{};
    const AllocationCounter counter;
    for (int c = 0; c < 4000; ++c) {
        const auto step = static_cast<std::size_t>(c);
        settings.tau = step % 300 < 150 ? 0.01 : 5;
        settings.modeBudget = step % 90 < 45 ? 300 : 40;
        settings.compression = step % 1000 < 500 ? 1 : 0;
        settings.radiation = step % 700 < 350 ? 0 : 0.5;
        settings.material->youngsModulusPa = 1e10 * (1 + 0.2 * std::sin(c * 0.02));
        if (step % 2000 < 1500)
            synthesiser.setSettings(settings);
        if (step % 100 == 50) {
            synthesiser.setDamping(step / 100 % 2, step % 200 == 50 ? 200 : 0);
            synthesiser.setFrequencyRatio(step / 100 % 2, 1 + 0.01 * static_cast<double>(step % 7));
            synthesiser.setMaterial(step / 100 % 2,
                                    step % 300 == 50 ? settings.material : std::nullopt);
        }
        if (step % 60 == 30) {
            silenced[step % 200] ^= 1;
            synthesiser.setSilencedModes(step / 60 % 2, silenced);
        }
        if (step % 3 == 0)
            synthesiser.setTubeOpening({.start = 0.5f, .end = step % 900 < 450 ? 0.5f : 1});
        else
            synthesiser.setTubeOpening({});
        synthesiser.beginCell(cell);
        if (step % 20 == 0)
            synthesiser.report(step / 20 % 2, groups);
        if (step % 17 == 0 && step % 2000 < 1000)
            synthesiser.strike(step % 2, unitStrike(step % 34 == 0 ? 0.004 : 0), 13.25, cell);
        if (step % 500 > 400)
            synthesiser.applyForce(step % 2, {.start = {}, .end = {}, .newtons = newtons}, cell);
        if (step == 3900)
            synthesiser.reset();
    }
    const long allocations = counter.allocations();
    CHECK(allocations == 0);
}
