#include "Synth/ActiveBlocks.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <vector>

using namespace idiophone;

namespace {

/// Three blocks of modes, all with the same pole.
struct ThreeBlocks {
    static constexpr std::size_t modes = 3 * modeBlock;
    static constexpr double sampleRateHz = 48000;
    static constexpr ModalPole pole{.stiffness = 4e6, .damping = 20};

    ThreeBlocks() {
        bank.movePoles(std::vector<double>(modes, pole.stiffness),
                       {.damping = {.fluidPerSecond = pole.damping}}, 20, 23000);
    }

    SynthesisScratch scratch{modes, 1};
    ModalBank bank{modes, 1, sampleRateHz};
    BankOutput output{bank, {}, sampleRateHz, scratch};
    ActiveBlocks blocks{bank, output};
};

} // namespace

TEST_CASE("A resting block catches up by free motion under the damper") {
    ThreeBlocks three;
    three.output.setDamping(3, 5);
    three.blocks.restAll(5);
    three.bank.setState(20, {1, 0.5});
    const double seconds = 100 * three.output.cellSeconds();
    const double damper = std::exp(-3 * seconds);
    const double expected =
        damper * std::exp(-ThreeBlocks::pole.damping / 2 * seconds) * std::hypot(1, 0.5);
    CHECK(std::abs(double(three.blocks.amplitude(20, 105)) - expected) < 1e-6);
    CHECK(three.bank.state(20).x == 1.0);

    three.blocks.bringRestingUpToDate(105);
    const ModalState moved = propagator(ThreeBlocks::pole, seconds) * ModalState{1, 0.5};
    CHECK(std::abs(three.bank.state(20).x - damper * moved.x) < 1e-6);
    CHECK(std::abs(three.bank.state(20).y - damper * moved.y) < 1e-6);
    CHECK(std::abs(double(three.blocks.amplitude(20, 105)) - expected) < 1e-6);
    three.blocks.bringUpToDate(1, 105);
    CHECK(std::abs(three.bank.state(20).x - damper * moved.x) < 1e-6);
}

TEST_CASE("Only a block that is still above the threshold wakes") {
    ThreeBlocks three;
    three.bank.setState(0, {1, 0});
    three.bank.setState(modeBlock, {2, 0});
    const std::int64_t grid = 69; // both amplitudes fall to e^(-0.92)
    three.blocks.wake(0.25f, grid);
    REQUIRE(three.blocks.list().size() == 1);
    CHECK(three.blocks.contains(1));
    CHECK(!three.blocks.contains(0));
    CHECK(three.bank.energies()[0] < 0.25f);
    CHECK(three.bank.energies()[modeBlock] > 0.25f);
}

TEST_CASE("Active blocks are listed in ascending order until they retire, and rest from then on") {
    ThreeBlocks three;
    for (std::size_t b = 0; b < 3; ++b)
        three.bank.setState(b * modeBlock, {1, 0});
    three.blocks.activate(2);
    three.blocks.activate(0);
    three.blocks.activate(2);
    REQUIRE(three.blocks.list().size() == 2);
    CHECK(three.blocks.list()[0] == 0);
    CHECK(three.blocks.list()[1] == 2);
    CHECK(three.blocks.amplitude(0, 50) == 1.0f);

    three.blocks.retire([](std::size_t block) { return block == 0; }, 50);
    REQUIRE(three.blocks.list().size() == 1);
    CHECK(three.blocks.list()[0] == 2);
    CHECK(three.blocks.amplitude(0, 50) == 1.0f);
    CHECK(three.blocks.amplitude(0, 60) < 0.9f);
    CHECK(three.blocks.amplitude(2 * modeBlock, 60) == 1.0f);
    three.blocks.restAll(60);
    CHECK(three.blocks.none());
}
