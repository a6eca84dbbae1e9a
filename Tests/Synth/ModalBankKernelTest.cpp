#include "Synth/ModalBankKernel.h"
#include "Synth/ModalBank.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

using namespace idiophone;

TEST_CASE("The kernel equals complex exponentials in double within -120 dB, active modes only") {
    constexpr double sampleRate = 48000;
    constexpr std::size_t modes = 37;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> hz(20, 23000);
    ModalBank bank(modes, sampleRate);
    std::vector<std::complex<double>> poles(modes);
    std::vector<std::int32_t> active;
    for (std::size_t g = 0; g < modes; ++g) {
        const double omega = 2 * std::numbers::pi * hz(random);
        const double alpha = 1 + hz(random) / 100;
        bank.setPole(g, {omega * omega + alpha * alpha, 2 * alpha});
        bank.setState(g, {1, -0.5});
        poles[g] = {-alpha, omega};
        if (g % 3 != 1)
            active.push_back(static_cast<std::int32_t>(g));
    }
    std::array<float, 64> output{};
    double worst = 0;
    for (int cell = 0; cell < 100; ++cell) {
        output.fill(0.25f);
        bank.render(active, output);
        for (std::size_t k = 0; k < output.size(); ++k) {
            const double t = (64.0 * cell + static_cast<double>(k)) / sampleRate;
            double expected = 0.25;
            for (const std::int32_t g : active)
                expected += (std::complex<double>(1, -0.5) *
                             std::exp(poles[static_cast<std::size_t>(g)] * t))
                                .real();
            worst = std::max(worst, std::abs(static_cast<double>(output[k]) - expected));
        }
    }
    CHECK(worst < 1e-6 * static_cast<double>(active.size()));
    CHECK(bank.state(1).x == 1.0);
    CHECK(bank.state(1).y == -0.5);
}

TEST_CASE("A stored cell step and free motion over a cell are the same") {
    for (const double damping : {10.0, 5000.0, 30000.0}) {
        ModalBank bank(2, 44100);
        for (const std::size_t g : {0u, 1u}) {
            bank.setPole(g, {4e6, damping});
            bank.setState(g, {1, 0.3});
        }
        bank.advanceCell(0);
        bank.advance(1, 64 / 44100.0);
        CHECK(std::abs(bank.state(0).x - bank.state(1).x) < 1e-13);
        CHECK(std::abs(bank.state(0).y - bank.state(1).y) < 1e-13);
    }
}
