#include "Instrument/SlotTuning.h"

#include "Instrument/ParameterGlide.h"
#include "TestInstruments.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double rateHz = 48000;
constexpr double cellSeconds = cellSamples / rateHz;
constexpr std::size_t slotOf69 = 9, slotOf70 = 10;

/// Bars with wheels of 2 semitones, and of 12 on MPE member channels.
struct Bars {
    std::shared_ptr<const Instrument> instrument = bars();
    Synthesiser synthesiser{{instrument->slots().begin(), instrument->slots().end()}, rateHz};
    SlotTuning tuning{*instrument, cellSeconds};
    PitchBend bend;

    Bars() {
        ParameterValues values;
        values.set(ParameterId::mpe, 1);
        values.set(ParameterId::mpeBendRange, 12);
        bend.setParameters(values);
    }

    void apply(int cells) {
        for (int cell = 0; cell < cells; ++cell)
            tuning.apply(bend, synthesiser);
    }

    double semitones(std::size_t slot) const {
        return 12 * std::log2(synthesiser.frequencyRatio(slot));
    }
};

double partOfWay(int cells) {
    return -std::expm1(-cells * cellSeconds / ParameterGlide::glideSeconds);
}

} // namespace

TEST_CASE("The first bends act at once, and later ones glide until they are exact") {
    Bars bars;
    bars.bend.wheel(0, 127, 127);
    bars.apply(1);
    CHECK(bars.semitones(slotOf69) == Approx(2));
    bars.bend.wheel(0, 0, 0);
    bars.apply(5);
    CHECK(bars.semitones(slotOf69) == Approx(2 - 4 * partOfWay(5)));
    bars.apply(100);
    CHECK(bars.synthesiser.frequencyRatio(slotOf69) == std::exp2(-2.0 / 12));
    bars.bend.wheel(0, 127, 127);
    bars.tuning.reset();
    bars.apply(1);
    CHECK(bars.semitones(slotOf69) == Approx(2));
}

TEST_CASE("A new note starts at its bend while ringing notes glide on") {
    Bars bars;
    bars.apply(1);
    bars.bend.noteOn(1, 69);
    bars.tuning.noteOn(69);
    bars.apply(1);
    bars.bend.wheel(0, 127, 127);
    bars.bend.wheel(1, 127, 127);
    bars.bend.wheel(2, 127, 127);
    bars.bend.noteOn(2, 70);
    bars.tuning.noteOn(70);
    bars.apply(1);
    CHECK(bars.semitones(slotOf70) == Approx(14));
    CHECK(bars.semitones(slotOf69) == Approx(14 * partOfWay(1)));
    CHECK(bars.semitones(0) == Approx(2 * partOfWay(1)));
}

TEST_CASE("A change of tuning acts at once during a glide") {
    Bars bars;
    bars.apply(1);
    bars.bend.wheel(0, 127, 127);
    KeyTuning tuning;
    tuning.semitonesFromEqual[69] = 0.5;
    bars.tuning.setTuning(tuning);
    bars.apply(1);
    CHECK(bars.semitones(slotOf69) == Approx(0.5 + 2 * partOfWay(1)));
}

TEST_CASE("An object that no note has played yet follows the common wheel") {
    const auto instrument = plate();
    Synthesiser synthesiser({instrument->slots().begin(), instrument->slots().end()}, rateHz);
    SlotTuning tuning(*instrument, cellSeconds);
    PitchBend bend;
    bend.setParameters({});
    bend.wheel(0, 127, 127);
    tuning.apply(bend, synthesiser);
    CHECK(synthesiser.frequencyRatio(0) == std::exp2(2.0 / 12));
}
