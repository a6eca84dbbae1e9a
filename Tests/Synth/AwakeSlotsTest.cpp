#include "Synth/AwakeSlots.h"
#include "ModalReference.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;
using Slots = std::vector<std::int32_t>;

/// Slots of the same object of four modes, without a synthesiser.
struct FourModesEach {
    explicit FourModesEach(std::size_t count) : scratch(4, 1), envelopes(count) {
        const auto object =
            std::make_shared<const ModalObject>(ringingObject({300, 500, 800, 1200}, 5));
        for (std::size_t slot = 0; slot < count; ++slot)
            objects.emplace_back(
                SynthesiserSlot{object},
                std::make_shared<const std::vector<double>>(summedSquareShapes(*object)), 0, 1,
                sampleRate, scratch, envelopes[slot]);
        slots.emplace(objects, envelopes);
    }

    void cells(int count) {
        for (int k = 0; k < count; ++k) {
            slots->beginCell(settings, std::exchange(settingsChanged, false));
            cell = {};
            for (const std::int32_t slot : slots->list())
                objects[index(slot)].mix(slots->share(index(slot)), cell);
            slots->report();
        }
    }

    void setBudget(double modes) {
        settings.modeBudget = modes;
        settingsChanged = true;
    }

    void strike(std::size_t slot, float newtonSeconds) {
        ModalResonator& object = objects[slot];
        const std::int32_t modesBefore = object.modesMixed();
        object.moveTo(slots->cell());
        Strike strike = unitStrike();
        strike.impulseNewtonSeconds = {0, 0, -newtonSeconds};
        CHECK(object.strike(strike, 0, slots->strikeAllowance(slot), cell));
        slots->update(slot, modesBefore);
    }

    Slots awake() const { return {slots->list().begin(), slots->list().end()}; }

    SynthesisSettings settings = exactSettings();
    bool settingsChanged = true;
    SynthesisScratch scratch;
    std::vector<AmplitudeEnvelope> envelopes;
    std::deque<ModalResonator> objects;
    std::optional<AwakeSlots> slots;
    std::array<float, cellSamples> cell{};
};

} // namespace

TEST_CASE("Slots are awake from a strike on until they are silent") {
    FourModesEach four(3);
    CHECK(four.awake() == Slots{0, 1, 2});
    four.cells(1);
    CHECK(four.awake().empty());
    four.strike(2, 1);
    four.strike(0, 1);
    CHECK(four.awake() == Slots{0, 2});
    four.cells(1);
    CHECK(four.slots->status()[2].modesMixed == 4);
    CHECK(four.slots->status()[1].modesRinging == 0);
    four.settings.tau = 1e9;
    four.settingsChanged = true;
    four.cells(6);
    CHECK(four.awake().empty());
    CHECK(four.slots->status()[2].modesRinging == 0);
}

TEST_CASE("The quietest objects sleep while the budget does not suffice") {
    FourModesEach four(3);
    four.cells(1);
    four.strike(0, 1);
    four.strike(1, 3);
    four.strike(2, 2);
    four.cells(1);
    CHECK(four.awake() == Slots{0, 1, 2});
    four.setBudget(8);
    four.cells(1);
    CHECK(four.slots->share(0) == 0);
    CHECK(four.slots->share(1) == 4);
    CHECK(four.slots->share(2) == 4);
    four.cells(4); // until the fade has ended
    CHECK(four.awake() == Slots{1, 2});
    CHECK(!four.objects[0].silent());
    CHECK(four.slots->status()[0].modesRinging == 4);
    CHECK(four.slots->status()[0].modesMixed == 0);
    CHECK(four.slots->status()[0].share == 0);
    four.setBudget(12);
    four.cells(1);
    CHECK(four.awake() == Slots{0, 1, 2});
    CHECK(four.objects[0].modesMixed() == 4);
}

TEST_CASE("A strike wakes a sleeping object if it is then twice as loud as one with a share") {
    FourModesEach four(3);
    four.setBudget(8);
    four.cells(1);
    for (std::size_t slot = 0; slot < 3; ++slot)
        four.strike(slot, slot == 1 ? 0.5f : 2);
    four.cells(5);
    REQUIRE(four.awake() == Slots{0, 2});
    four.strike(1, 0.5f);
    CHECK(four.awake() == Slots{0, 2});
    CHECK(four.objects[1].asleep());
    four.strike(1, 2); // four modes of 0.5 + 0.5 + 2, against 2
    CHECK(four.awake() == Slots{0, 2});
    four.strike(1, 5);
    CHECK(four.awake() == Slots{0, 1, 2});
    CHECK(four.objects[1].modesMixed() == 4);
    // The budget is kept from the next cell on.
    four.cells(1);
    CHECK(four.slots->status()[1].modesMixed == 4);
    CHECK(four.slots->status()[0].modesMixed + four.slots->status()[2].modesMixed == 4);
}

TEST_CASE("A sleeping object falls silent once its amplitude is below tau") {
    FourModesEach four(2);
    four.settings.tau = 100;
    four.setBudget(4);
    four.cells(1);
    four.strike(0, 100);
    four.strike(1, 0.01f); // four modes of 0.01 m/s, 655 steps of tau
    four.cells(10);
    REQUIRE(four.awake() == Slots{0});
    REQUIRE(four.objects[1].asleep());
    // The sum of four amplitudes falls from 2600 to 100 steps in 1.3 s.
    four.cells(static_cast<int>(1.2 * sampleRate / cellSamples));
    CHECK(four.objects[1].asleep());
    four.cells(static_cast<int>(0.2 * sampleRate / cellSamples));
    CHECK(four.objects[1].silent());
    CHECK(four.slots->status()[1].modesRinging == 0);
    CHECK(four.envelopes[1].amplitude() == 0.0);
}
