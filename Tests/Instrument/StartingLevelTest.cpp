// Tests predicted and rendered loudness of instruments that nobody has set by ear: starting levels,
// the loudest strike, and hand strengths.
#include "Instrument/StartingLevel.h"

#include "Instrument/LoudnessPhrase.h"

#include "Instrument/HandStrengths.h"
#include "Instrument/LoudnessMatch.h"
#include "Instrument/SpreadNotes.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;

/// A sheet with shapes larger by `gain` and a mass smaller by its square.
std::shared_ptr<const Instrument> sheet(float gain) {
    auto object = syntheticObject({300, 820, 1600}, {gain, gain, gain});
    if (gain > 0) {
        object.mass.massKg /= static_cast<double>(gain * gain);
        for (double& moment : object.mass.inertiaKgM2)
            moment /= static_cast<double>(gain * gain);
    }
    return keysOn(std::move(object), KeyMapKind::zones, 48, 72);
}

ParameterValues still() {
    return with({}, strikeSpread, 0);
}

/// Makes the mallet lighter and softer in the same ratio as the sheet is lighter, for the same
/// strike.
ParameterValues stillOn(float gain) {
    const double share = 1 / static_cast<double>(gain * gain);
    return with(with(still(), malletMass, share * still()[malletMass]), malletHardness,
                share * still()[malletHardness]);
}

} // namespace

TEST_CASE("Eight keys represent all, from the lowest to the highest") {
    CHECK(spreadNote(36, 96, 0, 8) == 36);
    CHECK(spreadNote(36, 96, 7, 8) == 96);
    CHECK(spreadNote(36, 96, 3, 8) == 61);
    CHECK(spreadNote(60, 60, 5, 8) == 60);
}

TEST_CASE("The loudest strike has the same peak if sheet and mallet are a quarter as heavy") {
    const double own = loudestStrikePeak(sheet(1), {}, sampleRateHz, still());
    CHECK(own > 0);
    CHECK(loudestStrikePeak(sheet(2), {}, sampleRateHz, stillOn(2)) == Approx(own).epsilon(1e-4));
    CHECK(loudestStrikePeak(sheet(2), {}, sampleRateHz, still()) > 3 * own);
    CHECK(loudestStrikePeak(sheet(0), {}, sampleRateHz, still()) == 0);
}

TEST_CASE("A starting level makes sheets equally loud, and is at most the highest level") {
    const auto levelOf = [](float gain) {
        return startingLevel(sheet(gain), {}, sampleRateHz, still());
    };
    const auto lufsOf = [](float gain) {
        return predictedLufs(sheet(gain), {}, sampleRateHz, still());
    };
    CHECK(levelOf(0.5f) - levelOf(1) == Approx(lufsOf(1) - lufsOf(0.5f)).margin(1e-3));
    CHECK(levelOf(0.5f) > levelOf(1) + 10);
    for (const float gain : {0.25f, 1.0f, 4.0f}) {
        const double level = levelOf(gain);
        const double highest = highestLevel(sheet(gain), {}, sampleRateHz, still());
        CHECK(level <= highest);
        CHECK((level == highest || lufsOf(gain) + level == Approx(factoryChannelLufs)));
    }
}

TEST_CASE("A silent object keeps its level and its mallet") {
    const auto values = with(still(), level, -7);
    CHECK(startingLevel(sheet(0), {}, sampleRateHz, values) == -7);
    CHECK(withAudibleMallet(sheet(0), {}, sampleRateHz, values) == values);
    CHECK(withAudibleMallet(sheet(4), {}, sampleRateHz, values) == values);
}

TEST_CASE("The predicted loudness equals the loudness match's at its middle velocity") {
    const LoudnessMatch match(sheet(1), {}, sampleRateHz, still());
    CHECK(predictedLufs(sheet(1), {}, sampleRateHz, still()) ==
          match.predictedLufs(still())[PhrasePrediction::middleVelocity]);
}

TEST_CASE("Hands scrape harder if scrapes are fainter than strikes, but not if keys roll") {
    const auto strengths = handStrengths(sheet(1), {}, sampleRateHz, still());
    REQUIRE(strengths.size() == sheet(1)->slots().size());
    CHECK(strengths[0] > 1);
    // If a strike leaves the same motion, a scrape of the same force moves a lighter sheet more.
    CHECK(handStrengths(sheet(2), {}, sampleRateHz, stillOn(2))[0] ==
          Approx(strengths[0] / 4).epsilon(1e-4));
    const auto harder = with(still(), malletSpeed, 2 * still()[malletSpeed]);
    CHECK(handStrengths(sheet(1), {}, sampleRateHz, harder)[0] > 1.5 * strengths[0]);
    const auto rolls = with(still(), contact, rollContact);
    CHECK(handStrengths(sheet(1), {}, sampleRateHz, rolls)[0] == 1);
    CHECK(handStrengths(sheet(0), {}, sampleRateHz, still())[0] == 1);
}
