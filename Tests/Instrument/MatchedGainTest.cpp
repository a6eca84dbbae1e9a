// Tests when a player has its gain: what the audio thread knows, asks for and is answered.
#include "Instrument/MatchedGain.h"

#include "Support/AllocationCounter.h"
#include "Support/WaitUntil.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <memory>
#include <thread>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

constexpr int atRest = HeldContacts::controllerAtRest;

LoudnessMatch matchOf(const ParameterValues& own) {
    std::vector<double> hz;
    for (int mode = 0; mode < 40; ++mode)
        hz.push_back(100 + 500 * mode);
    return {{keysOn(syntheticObject(hz), KeyMapKind::zones, 36, 96), {}, 48000}, own};
}

/// Values whose keys act as `kind`, and the same with other materials.
struct Values {
    explicit Values(int kind = strikeContact)
        : own(with(with({}, matchLoudness, 1), contact, kind)), glass(of(5)), other(of(7)) {}
    ParameterValues of(int choice) const {
        return with(own, material, firstLibraryMaterial + choice);
    }

    ParameterValues own, glass, other;
};

} // namespace

TEST_CASE("In real time the gain stays as it is until another thread has answered") {
    const Values values;
    const auto match = matchOf(values.own);
    MatchedGain gain(match);
    const double expected = match.gainDb(values.glass);
    REQUIRE(expected != 0);
    for (int cell = 0; cell < 1000; ++cell)
        CHECK(gain.follow(values.glass, atRest, false) == 0);
    gain.answer();
    CHECK(gain.follow(values.glass, atRest, false) == expected);
    gain.answer(); // nothing is asked any more
    CHECK(gain.follow(values.glass, atRest, false) == expected);
}

TEST_CASE("Offline every change has its gain at once") {
    for (const int kind : {strikeContact, scrapeContact, rollContact}) {
        const Values values(kind);
        const auto match = matchOf(values.own);
        MatchedGain gain(match);
        for (const int wheel : {atRest, 127, 40})
            for (const auto& now : {values.glass, values.own, values.other, values.glass})
                CHECK(gain.follow(now, wheel, true) == match.gainDb(now, wheel));
    }
}

TEST_CASE("An answer to an earlier question is dropped") {
    const Values values;
    const auto match = matchOf(values.own);
    MatchedGain gain(match);
    const double before = gain.follow(values.of(3), atRest, true);
    const double expected = match.gainDb(values.other);
    REQUIRE(before != 0);
    CHECK(gain.follow(values.glass, atRest, false) == before);
    gain.answer();
    for (int cell = 0; cell < 3; ++cell)
        CHECK(gain.follow(values.other, atRest, false) == before);
    gain.answer();
    CHECK(gain.follow(values.other, atRest, false) == expected);

    // After a change and back nothing is missing.
    gain.follow(values.glass, atRest, false);
    CHECK(gain.follow(values.other, atRest, false) == expected);
}

TEST_CASE("Of many questions the last one is answered") {
    const Values values;
    const auto match = matchOf(values.own);
    MatchedGain gain(match);
    for (int choice = 0; choice < 8; ++choice)
        gain.follow(values.of(choice), atRest, false);
    gain.answer();
    CHECK(gain.follow(values.of(7), atRest, false) == match.gainDb(values.of(7)));
}

TEST_CASE("A question that was put live is answered offline at once") {
    const Values values;
    const auto match = matchOf(values.own);
    MatchedGain gain(match);
    CHECK(gain.follow(values.glass, atRest, false) == 0);
    CHECK(gain.follow(values.glass, atRest, true) == match.gainDb(values.glass));
}

TEST_CASE("Without a match, or with the preset's own material, the gain is 0 at once") {
    const Values values;
    MatchedGain gain(matchOf(values.own));
    const double known = gain.follow(values.glass, atRest, true);
    REQUIRE(known != 0);
    for (const auto& unmatched : {with(values.glass, matchLoudness, 0), values.own}) {
        CHECK(gain.follow(unmatched, atRest, false) == 0);
        CHECK(gain.follow(values.other, atRest, false) == 0); // asks, and keeps the last gain
        CHECK(gain.follow(unmatched, atRest, false) == 0);
        gain.answer();
        CHECK(gain.follow(unmatched, atRest, false) == 0);
        CHECK(gain.follow(values.glass, atRest, false) == known);
    }
}

TEST_CASE("Only values that a prediction uses ask for another gain") {
    const Values values;
    MatchedGain gain(matchOf(values.own));
    auto now = with(values.own, mallet, firstRackMallet + 2);
    const double known = gain.follow(now, atRest, true);
    REQUIRE(known != 0);
    gain.follow(values.own, atRest, false);
    REQUIRE(gain.follow(with(now, size, 200), atRest, false) == 0);
    for (const auto parameter :
         {level, width, tau, modeBudget, qualitySlope, compression, strikeSpread, releaseTime,
          bendRange, contactForce, contactSpeed, roughness, rollCoupling, malletHardness,
          malletMass, malletRadius, youngsModulus}) {
        now.set(parameter, parameterInfo(parameter).maximum);
        INFO(parameterInfo(parameter).id);
        CHECK(gain.follow(now, atRest, false) == known);
    }
}

TEST_CASE("The wheel changes the gain of scrapes but not of strikes") {
    for (const int kind : {strikeContact, scrapeContact}) {
        const Values values(kind);
        MatchedGain gain(matchOf(values.own));
        const double resting = gain.follow(values.glass, atRest, true);
        const double moved = gain.follow(values.glass, 127, true);
        CHECK((moved != resting) == (kind == scrapeContact));
    }
}

TEST_CASE("Asking and taking an answer do not allocate") {
    const Values values;
    MatchedGain gain(matchOf(values.own));
    const AllocationCounter counter;
    for (const auto* now : {&values.glass, &values.other, &values.own, &values.glass}) {
        gain.follow(*now, atRest, false);
        gain.answer();
        gain.follow(*now, atRest, false);
    }
    CHECK(counter.allocations() == 0);
}

TEST_CASE("A gain that another thread predicts while values change is that of the last values") {
    const Values values;
    const auto match = matchOf(values.own);
    MatchedGain gain(match);
    std::atomic<bool> ends{false};
    std::thread answering([&] {
        while (!ends)
            gain.answer();
    });
    for (int change = 0; change < 400; ++change)
        gain.follow(values.of(change % 8), atRest, false);
    const double expected = match.gainDb(values.glass);
    waitUntil([&] { return gain.follow(values.glass, atRest, false) == expected; });
    ends = true;
    answering.join();
    CHECK(gain.follow(values.glass, atRest, false) == expected);
}
