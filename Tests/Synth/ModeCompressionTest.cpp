#include "Synth/ModeCompression.h"
#include "ModalReference.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

double eigenvalue(double hz) {
    return std::pow(2 * std::numbers::pi * hz, 2);
}

std::vector<std::int32_t>
groupsOf(const std::vector<double>& frequenciesHz, const PoleLaw& law, double compression) {
    std::vector<double> eigenvalues;
    for (const double hz : frequenciesHz)
        eigenvalues.push_back(eigenvalue(hz));
    std::vector<std::int32_t> starts(eigenvalues.size() + 1);
    starts.resize(groupModes(eigenvalues, law, compression, starts) + 1);
    return starts;
}

using Starts = std::vector<std::int32_t>;

double residueOf(const std::vector<float>& residues,
                 const std::vector<double>& eigenvalues,
                 const PoleLaw& law) {
    std::vector<float> shares(pairsOf(residues.size()));
    findLostShares(eigenvalues, law, shares);
    const auto merged =
        mergedResidue(std::vector<std::complex<float>>(residues.begin(), residues.end()), shares);
    CHECK(merged.imag() == 0);
    return static_cast<double>(merged.real());
}

} // namespace

TEST_CASE("The discrimination curve covers 20 to 22000 Hz in 962 windows") {
    int windows = 0;
    for (double f = 20; f < 22000; f += discriminationHz(f))
        ++windows;
    CHECK(windows == 962);
}

TEST_CASE("The discrimination curve passes through its three points") {
    CHECK(std::abs(discriminationHz(20) - 1.5) < 1e-12);
    CHECK(std::abs(discriminationHz(2000) - 5) < 1e-12);
    CHECK(std::abs(discriminationHz(22000) - 300) < 1e-12);
}

TEST_CASE("Groups are never wider than the window of their first mode or larger than 32") {
    // Damping hides every beat within a group. Modes are 0.49 Hz apart; D(2000) = 5 Hz.
    std::vector<double> dense;
    for (int k = 0; k < 4000; ++k)
        dense.push_back(2000 + 0.49 * k);
    const PoleLaw law{1, {400, 0}};
    const auto starts = groupsOf(dense, law, 1);
    REQUIRE(starts.size() > 2);
    CHECK(starts[1] == 11); // 2000.00 to 2004.90
    for (std::size_t g = 0; g + 1 < starts.size(); ++g) {
        CHECK(starts[g + 1] - starts[g] <= 32);
        const double first = dense[static_cast<std::size_t>(starts[g])];
        const double last = dense[static_cast<std::size_t>(starts[g + 1]) - 1];
        CHECK(last - first <= discriminationHz(first) + 1e-6);
    }
}

TEST_CASE("Modes with an audible beat stay apart, and modes that decay within a beat merge") {
    // 3 Hz apart at 2 kHz: Δω = 18.8 against (α_i + α_j)/2 = γ/2.
    CHECK(groupsOf({2000, 2003}, {1, {37, 0}}, 1) == Starts{0, 1, 2});
    CHECK(groupsOf({2000, 2003}, {1, {39, 0}}, 1) == Starts{0, 2});
}

TEST_CASE("Only equal poles merge at compression 0") {
    CHECK(groupsOf({500, 500, 500 * (1 + 1e-10), 500.01}, {1, {500, 0}}, 0) == Starts{0, 3, 4});
    CHECK(groupsOf({500, 500.01}, {1, {500, 0}}, 1) == Starts{0, 2});
}

TEST_CASE("Over-damped modes of different eigenvalues do not merge") {
    CHECK(groupsOf({500, 501}, {1, {50000, 0}}, 1) == Starts{0, 1, 2});
}

TEST_CASE("Equal poles give the exact sum of residues, even if it nearly cancels") {
    const std::vector<double> eigenvalues(3, eigenvalue(440));
    const std::vector<float> residues{1.0f, -1.0f + 0x1p-24f, 0x1p-40f};
    CHECK(residueOf(residues, eigenvalues, {1, {5, 0}}) == 0x1p-24 + 0x1p-40);
    CHECK(mergedEigenvalue(eigenvalues, std::vector<double>{1, 2, 3}) == eigenvalues[0]);
}

TEST_CASE("A merged group has the level of its modes within 0.5 dB") {
    const int seed = GENERATE(1, 2, 3, 4, 5, 6, 7, 8);
    const PoleLaw law{1, {120, 0}};
    std::vector<double> eigenvalues;
    std::vector<float> residues;
    std::vector<double> weights;
    std::vector<ReferenceMode> modes;
    for (int k = 0; k < 5; ++k) {
        const double hz = 2000 + 1.1 * k;
        const auto residue = static_cast<float>(std::sin(seed * 12.9898 + k * 78.233));
        eigenvalues.push_back(eigenvalue(hz));
        residues.push_back(residue);
        weights.push_back(1);
        modes.push_back({eigenvalue(hz), 120, static_cast<double>(residue)});
    }
    const auto merged = law.pole(mergedEigenvalue(eigenvalues, weights));
    const ReferenceMode one{merged.stiffness, merged.damping,
                            residueOf(residues, eigenvalues, law)};
    double energyOfModes = 0;
    double energyOfOne = 0;
    for (double t = 0; t < 0.2; t += 1.0 / 44100) {
        double sum = 0;
        for (const ReferenceMode& mode : modes)
            sum += impulseVelocity(mode, t);
        energyOfModes += sum * sum;
        energyOfOne += std::pow(impulseVelocity(one, t), 2);
    }
    CHECK(std::abs(10 * std::log10(energyOfOne / energyOfModes)) < 0.5);
}
