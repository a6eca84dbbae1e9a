#include "ResonatorParts.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

ModalObject fourModes() {
    return ringingObject({300, 500, 800, 1200}, 5);
}

} // namespace

TEST_CASE("ActiveModes mixes the strongest modes of a share and fades the others") {
    ResonatorParts parts(fourModes());
    parts.ring();
    CHECK(parts.active.demand().modes == 4);
    parts.active.choose(4, 0);
    CHECK(parts.active.allMixed());
    CHECK(parts.output.fading());
    const auto version = parts.active.modes().version();
    parts.active.choose(2, 0);
    CHECK(parts.active.modes().mixedCount() == 2);
    CHECK(!parts.active.modes().isMixed(1));
    CHECK(parts.active.modes().isMixed(2));
    CHECK(parts.active.modes().isMixed(3));
    CHECK(parts.active.modes().rings(0));
    CHECK(parts.active.modes().version() > version);
}

TEST_CASE("A survey keeps the ringing modes as long as a contact or a force needs them") {
    ResonatorParts parts(fourModes());
    parts.ring();
    parts.active.setTau(2.5);
    parts.active.survey(ActiveModes::Change::none);
    CHECK(parts.active.demand().modes == 4);
    parts.active.survey(ActiveModes::Change::joinOnly);
    CHECK(parts.active.demand().modes == 4);
    parts.active.survey(ActiveModes::Change::any);
    CHECK(parts.active.demand().modes == 2);
}

TEST_CASE("A block rests when nothing in it rings and wakes when tau falls") {
    ResonatorParts parts(fourModes());
    parts.ring();
    parts.active.setTau(10);
    parts.active.survey(ActiveModes::Change::any);
    parts.active.choose(4, 5);
    CHECK(parts.active.blocks().none());
    CHECK(parts.bank.state(3).x == 4.0); // nothing was advanced
    parts.active.setTau(1e-6);
    parts.active.wake(105);
    CHECK(!parts.active.blocks().none());
    const double fallen =
        std::exp(-decayBound(parts.bank.pole(3)) * 100 * parts.output.cellSeconds());
    CHECK(std::abs(std::sqrt(double(parts.bank.energies()[3])) - 4 * fallen) < 1e-5);
    parts.active.survey(ActiveModes::Change::any);
    CHECK(parts.active.demand().modes == 4);
}

TEST_CASE("Blocks that the budget leaves out rest, and wake once they may hold a stronger mode") {
    std::vector<double> frequencies;
    for (std::size_t k = 0; k < 3 * modeBlock; ++k)
        frequencies.push_back(300 + 200 * static_cast<double>(k));
    ResonatorParts parts(ringingObject(frequencies, 5));
    ActiveModes& active = parts.active;
    parts.ring(); // amplitudes 1 to 48
    active.choose(48, 0);
    active.choose(20, 0);
    CHECK(active.modes().mixedCount() == 20);
    CHECK(active.blocks().list().size() == 2);
    CHECK(active.restRinging());
    CHECK(active.modes().rings(0));
    active.survey(ActiveModes::Change::any);
    CHECK(active.demand().modes == 48);

    // The mixed modes of one block fall below the strongest of the block at rest.
    for (std::size_t g = modeBlock; g < 2 * modeBlock; ++g)
        parts.bank.setState(g, {0.5, 0});
    active.choose(20, 50);
    CHECK(active.modes().isMixed(28));
    active.reconsider();
    active.survey(ActiveModes::Change::any);
    active.choose(20, 50);
    CHECK(!active.modes().isMixed(28));
    CHECK(active.modes().isMixed(12));
    CHECK(active.modes().isMixed(15));
    CHECK(active.modes().mixedCount() == 20);
    CHECK(!active.blocks().contains(1));
    const double fallen =
        std::exp(-decayBound(parts.bank.pole(15)) * 50 * parts.output.cellSeconds());
    CHECK(std::abs(std::sqrt(double(parts.bank.energies()[15])) - 16 * fallen) < 1e-4);

    active.choose(48, 50);
    CHECK(active.allMixed());
    CHECK(!active.restRinging());
}

TEST_CASE("Without a share all modes rest and still count as ringing until they are forgotten") {
    ResonatorParts parts(fourModes());
    parts.ring();
    parts.active.choose(4, 0);
    parts.active.choose(0, 0);
    CHECK(parts.active.blocks().none());
    CHECK(parts.active.modes().mixedCount() == 0);
    CHECK(parts.active.restRinging());
    parts.active.survey(ActiveModes::Change::any);
    CHECK(parts.active.demand().modes == 4);
    parts.active.wake(10);
    parts.active.survey(ActiveModes::Change::any);
    parts.active.choose(4, 10);
    CHECK(parts.active.allMixed());
    parts.active.choose(0, 10);
    parts.active.forgetResting();
    CHECK(!parts.active.restRinging());
    CHECK(!parts.active.modes().rings(3));
}

TEST_CASE("Struck modes join within the allowance, the loudest first") {
    ResonatorParts parts(fourModes());
    AlignedVector<float> energies(modeBlock);
    energies[0] = 4;
    energies[1] = 9;
    energies[2] = 1;
    const auto joined = parts.active.join(
        {energies.data(), parts.active.tauEnergy(), energies.data()}, 2, false, 1);
    CHECK(parts.active.modes().mixedCount() == 2);
    CHECK(parts.active.modes().isMixed(0));
    CHECK(parts.active.modes().isMixed(1));
    REQUIRE(joined.size() == 1);
    CHECK(joined[0].count == 2);
    CHECK(
        parts.active.join({energies.data(), parts.active.tauEnergy(), energies.data()}, 2, false, 1)
            .empty());
    CHECK(!parts.active
               .join({parts.bank.poles().audibleWeights(), 0, parts.bank.energies()}, 4, false, 1)
               .empty());
    CHECK(parts.active.allMixed());
}
