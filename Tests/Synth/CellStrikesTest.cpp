#include "Synth/CellStrikes.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;

/// A bar of one low mode, and the strikes on it.
class Rig {
public:
    Rig()
        : synthesiser({{.object = std::make_shared<const ModalObject>(syntheticObject({200}))}},
                      sampleRateHz) {}

    void beginCell() {
        synthesiser.beginCell(cells);
        ++index;
    }
    BegunCell cell() { return {synthesiser, cells, index}; }
    void finishCell() {
        strikes.strikeBefore(cellSamples, cell());
        sound.insert(sound.end(), samples.begin(), samples.end());
    }

    Synthesiser synthesiser;
    alignas(64) std::array<float, cellSamples> samples{};
    std::vector<CellOutput> cells{CellOutput(samples)};
    std::int64_t index = -1;
    CellStrikes strikes{1024};
    std::vector<float> sound;
};

Strike pulse(double seconds) {
    return {.point = {}, .impulseNewtonSeconds = {0, 0, -1}, .durationSeconds = seconds};
}

/// Returns the sound after `count` strikes at the same moment.
std::vector<float> soundOf(int count) {
    Rig rig;
    for (int cell = 0; cell < 40; ++cell) {
        rig.beginCell();
        for (int k = 0; cell == 0 && k < count; ++k)
            CHECK(rig.strikes.strike(0, pulse(1e-3), 10.5, rig.cell()));
        rig.finishCell();
    }
    CHECK(rig.strikes.empty());
    return rig.sound;
}

} // namespace

TEST_CASE("A strike beyond the limit of contacts sounds like a strike within it") {
    const auto one = soundOf(1), many = soundOf(300);
    for (std::size_t i = 10 * cellSamples; i < one.size(); ++i)
        REQUIRE(many[i] == Approx(300 * one[i]).margin(0.02 * 300));
}

TEST_CASE("An invalid strike is refused, also without free contacts, and does not stay pending") {
    for (const int before : {0, 64}) {
        Rig rig;
        rig.beginCell();
        for (int k = 0; k < before; ++k)
            CHECK(rig.strikes.strike(0, pulse(5e-3), 0, rig.cell()));
        auto strike = pulse(std::numeric_limits<double>::quiet_NaN());
        CHECK_FALSE(rig.strikes.strike(0, strike, 0, rig.cell()));
        strike = pulse(0);
        strike.impulseNewtonSeconds[2] = std::numeric_limits<float>::infinity();
        CHECK_FALSE(rig.strikes.strike(0, strike, 0, rig.cell()));
        strike.durationSeconds = 1e-3;
        rig.strikes.strike(0, strike, 0, rig.cell());
        for (int cell = 0; cell < 10; ++cell) {
            rig.finishCell();
            rig.beginCell();
        }
        CHECK(rig.strikes.empty());
    }
}

TEST_CASE("A strike too late for its cell acts at the start of the next cell") {
    Rig late, at;
    late.strikes.schedule(0, pulse(0), 0, 17);
    for (auto* rig : {&late, &at}) {
        rig->beginCell();
        rig->beginCell();
    }
    CHECK(at.strikes.strike(0, pulse(0), -3, at.cell()));
    late.finishCell();
    at.finishCell();
    CHECK(late.sound == at.sound);
    CHECK(late.sound[0] != 0);
}

TEST_CASE("Pending strikes play in order of time, and at the same time as they were added") {
    // A sum of floats tells the order of its terms.
    constexpr int count = 1000;
    const auto strikeOf = [](int k) {
        auto strike = pulse(0);
        strike.impulseNewtonSeconds[2] = -std::exp2(static_cast<float>(k * 7 % 23));
        return strike;
    };
    const auto timeOf = [](int k) { return k * 37 % 101; };
    Rig scheduled, inTurn;
    for (int k = 0; k < count; ++k)
        scheduled.strikes.schedule(0, strikeOf(k), 0, timeOf(k) * 3.0);
    for (int cell = 0; cell < 6; ++cell) {
        scheduled.beginCell();
        inTurn.beginCell();
        for (int time = 0; time < 101; ++time)
            for (int k = 0; k < count; ++k)
                if (timeOf(k) == time && time * 3 / cellSamples == cell)
                    inTurn.strikes.strike(0, strikeOf(k), time * 3 % cellSamples, inTurn.cell());
        scheduled.finishCell();
        inTurn.finishCell();
    }
    CHECK(scheduled.strikes.empty());
    CHECK(scheduled.sound == inTurn.sound);
}

TEST_CASE("Pending strikes keep their places until they are played or cleared") {
    Rig rig;
    const auto all = rig.strikes.freeSpace();
    rig.strikes.schedule(0, pulse(0), 3, 5);
    rig.strikes.schedule(0, pulse(0), 0, 3 * cellSamples);
    CHECK(rig.strikes.freeSpace() == all - 2);
    for (int cell = 0; cell < 4; ++cell) {
        rig.beginCell();
        rig.strikes.strikeBefore(cell == 3 ? 5 : cellSamples, rig.cell());
        CHECK(rig.strikes.freeSpace() == (cell < 3 ? all - 2 : all - 1));
    }
    rig.finishCell();
    CHECK(rig.strikes.empty());
}
