// Tests sliding and rolling as forces on the slots of both bodies.
#include "World/TouchVoices.h"
#include "Instrument/ObjectLibrary.h"

#include "Scene/FactoryScenes.h"
#include "Scene/SceneSimulation.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

namespace {

constexpr double rateHz = 48000;

/// Two slots of the bell, pressed by one voice.
class Rig {
public:
    Rig()
        : synthesiser({assets->slotOf(0), assets->slotOf(0)}, rateHz),
          cells(cellsOfSlotsIn(samples)), voices(assets->surfaces(), rateHz, 1) {}

    /// Renders the next cell under a state. Returns whether each slot sounds in it.
    std::array<bool, 2> press(const TouchState& state, std::size_t rollSlots = 0) {
        synthesiser.beginCell(cells);
        voices.press(0, state, {synthesiser, cells}, rollSlots);
        const auto sounds = [&](std::size_t slot) {
            return std::ranges::any_of(cells[slot][0], [](float x) { return x != 0; });
        };
        return {sounds(0), sounds(1)};
    }

    std::shared_ptr<const SceneAssets> assets =
        SceneAssets::make(*findFactoryScene("Bell under a hand"), ObjectLibrary::shared()).value();
    Synthesiser synthesiser;
    alignas(64) std::array<float, 2 * cellSamples> samples{};
    std::vector<CellOutput> cells;
    TouchVoices voices;
};

TouchState sliding() {
    TouchState state{.pair = 1, .surface = 0, .slots = {0, 1}};
    for (auto& point : state.points)
        point.direction = {0, 0, -1};
    state.forceNewtons = 2;
    state.slideMetresPerSecond = 0.3;
    return state;
}

} // namespace

TEST_CASE("Both bodies of a sliding pair sound; one alone if the other has no slot") {
    CHECK(Rig().press(sliding()) == std::array{true, true});
    auto onHand = sliding();
    onHand.slots[1] = noSlot;
    CHECK(Rig().press(onHand) == std::array{true, false});
}

TEST_CASE("A voice without a pair, without force or at rest applies no force") {
    Rig rig;
    auto state = sliding();
    state.pair = 0;
    CHECK(rig.press(state) == std::array{false, false});
    state = sliding();
    state.forceNewtons = 0;
    CHECK(rig.press(state) == std::array{false, false});
    state = sliding();
    state.slideMetresPerSecond = 0;
    CHECK(rig.press(state) == std::array{false, false});
}

TEST_CASE("Slides and rolls sound apart if rolls have slots of their own") {
    auto slides = sliding();
    slides.slots[1] = noSlot;
    auto rolls = slides;
    std::swap(rolls.slideMetresPerSecond, rolls.rollMetresPerSecond);
    auto both = slides;
    both.rollMetresPerSecond = both.slideMetresPerSecond;
    CHECK(Rig().press(slides, 1) == std::array{true, false});
    CHECK(Rig().press(rolls, 1) == std::array{false, true});
    CHECK(Rig().press(both, 1) == std::array{true, true});
    CHECK(Rig().press(both) == std::array{true, false});
}

TEST_CASE("After a reset, voices sound as they did at first") {
    Rig rig;
    const auto cell = [&] {
        rig.press(sliding());
        const auto first = rig.samples;
        rig.press(sliding());
        return std::array{first, rig.samples};
    };
    const auto once = cell();
    rig.synthesiser.reset();
    rig.voices.reset();
    CHECK(cell() == once);
}
