#include "Synth/ModeFader.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;

TEST_CASE("A dropped mode fades out under a raised cosine of 3 ms and then is silent") {
    constexpr double sampleRate = 44100;
    constexpr double omega = 2 * std::numbers::pi * 700;
    ModalBank bank(1, 1, sampleRate);
    const std::vector<double> eigenvalue{omega * omega};
    bank.movePoles(eigenvalue, {}, 20, 20000);
    bank.setState(0, {1, 0});
    FadeRoom room(modeBlock, 1);
    ModeFader fader(room, sampleRate);
    const std::vector<std::int32_t> mode{0};
    const std::vector<float> all{1}, none{-1};
    fader.change(bank, mode, all);
    std::size_t sample = 0;
    while (fader.active()) {
        std::array<float, cellSamples> cell{};
        fader.addCell({cell.data(), nullptr});
        for (const float value : cell) {
            const double t = static_cast<double>(sample++) / sampleRate;
            const double part = std::min(t / 0.003, 1.0);
            const double expected =
                std::cos(omega * t) * 0.5 * (1 + std::cos(std::numbers::pi * part));
            CHECK(std::abs(static_cast<double>(value) - expected) < 1e-6);
        }
    }
    CHECK(sample == 192); // 133 samples, rounded up to whole cells
    CHECK(bank.state(0).x == 1.0);

    fader.change(bank, mode, all);
    fader.change(bank, mode, none);
    std::array<float, cellSamples> cell{};
    fader.addCell({cell.data(), nullptr});
    for (const float value : cell)
        CHECK(std::abs(value) < 1e-7f); // a fused multiply-add rounds once
}
