#include "Instrument/NearModes.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <vector>

using namespace idiophone;
using Catch::Approx;

namespace {

using Mode = RingingMode<1>;

/// A mode that one note excites, with residues to the left and to the right.
Mode mode(double omega, double decay, std::complex<double> left, std::complex<double> right) {
    Mode result{.omega = omega, .decay = decay};
    result.velocities[0][0] = 1;
    result.residues[0] = {left, right};
    return result;
}

/// Returns ∫ of the mean of both channels' squares, from the powers that NearModes returns.
double energyByPowers(const std::vector<Mode>& modes) {
    NearModes<1> near;
    double energy = 0;
    const auto take = [&](auto decay, const auto& powers) {
        energy += std::real(powers[0][0] / (2.0 * decay));
    };
    for (const auto& each : modes)
        near.add(each, 0, 1, take);
    near.takeAll(take);
    return energy;
}

/// Returns the same energy from samples of Σ Re(r e^(−αt + iωt)).
double energyBySamples(const std::vector<Mode>& modes) {
    constexpr double step = 1e-5;
    double energy = 0;
    for (double t = step / 2; t < 1.5; t += step)
        for (std::size_t channel = 0; channel < 2; ++channel) {
            double v = 0;
            for (const auto& each : modes)
                v += (each.residues[0][channel] *
                      std::exp(std::complex<double>(-each.decay, each.omega) * t))
                         .real();
            energy += v * v / 2 * step;
        }
    return energy;
}

} // namespace

TEST_CASE("The energy of one mode is A^2/(4 decay), with the mean of A^2 over the channels") {
    CHECK(energyByPowers({mode(6000, 20, 3, 1)}) == Approx((9 + 1) / 2.0 / (4 * 20)));
}

TEST_CASE("Close modes have the energy of their sum, and distant modes the sum of their energies") {
    for (const double apart : {0.0, 5.0, 30.0, 120.0}) {
        const std::vector modes{mode(6000, 20, 1, {0.8, -0.6}),
                                mode(6000 + apart, 25, {0.3, 0.6}, -0.4)};
        INFO(apart << " rad/s apart");
        CHECK(energyByPowers(modes) == Approx(energyBySamples(modes)).epsilon(0.01));
    }
    const std::vector apart{mode(6000, 20, 1, 1), mode(7000, 25, 0.7, -0.4)};
    CHECK(energyByPowers(apart) == Approx(1 / 80.0 + (0.49 + 0.16) / 2 / 100));
}

TEST_CASE("Forty close modes all interfere with each other") {
    std::vector<Mode> modes;
    for (int k = 0; k < 40; ++k)
        modes.push_back(mode(9000 + 12 * k, 15 + k % 6, 1 - 0.3 * (k % 6), 0.2 * (k % 6)));
    CHECK(energyByPowers(modes) == Approx(energyBySamples(modes)).epsilon(0.01));
}
