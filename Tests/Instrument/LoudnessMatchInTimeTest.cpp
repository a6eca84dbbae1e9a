// Tests when a loudness match has its gain: cell by cell, after resets and at song starts.
#include "Instrument/LoudnessMatch.h"

#include "MatchedGain.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <catch2/catch_test_macros.hpp>
#include <memory>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

constexpr double sampleRateHz = 48000;

std::shared_ptr<const Instrument> synthetic(std::size_t modes) {
    std::vector<double> hz;
    for (std::size_t i = 0; i < modes; ++i)
        hz.push_back(100 + 20000.0 * static_cast<double>(i) / static_cast<double>(modes));
    return keysOn(syntheticObject(hz), KeyMapKind::zones, 36, 96);
}

} // namespace

TEST_CASE("The match processes at most 16 modes a cell, and two predictions in all") {
    for (const std::size_t modes : {200u, 5000u}) {
        ParameterValues own;
        own.set(matchLoudness, 1);
        const auto changed = with(own, mallet, firstRackMallet + 2);
        LoudnessMatch match({synthetic(modes), {}, sampleRateHz}, own);
        match.prepare(own);
        std::size_t work = 0, cells = 0;
        for (; cells < 10000; ++cells) {
            const auto taken = match.advance(changed);
            CHECK(taken <= LoudnessMatch::modesPerCell);
            if (taken == 0)
                break;
            work += taken;
        }
        CHECK(work == 2 * modes);
        CHECK(match.gainDb() == gainOf(match, changed));
        CHECK(match.gainDb() != 0);
    }
}

TEST_CASE(
    "A value that no prediction uses costs no work, and another mallet costs one prediction") {
    ParameterValues own;
    own.set(matchLoudness, 1);
    LoudnessMatch match({synthetic(500), {}, sampleRateHz}, own);
    auto now = with(own, mallet, firstRackMallet + 2);
    match.prepare(now);
    for (const auto parameter :
         {level, width, tau, modeBudget, qualitySlope, compression, strikeSpread, releaseTime,
          bendRange, contactForce, contactSpeed, roughness, rollCoupling, malletHardness,
          malletMass, malletRadius, youngsModulus}) {
        now.set(parameter, parameterInfo(parameter).maximum);
        INFO(parameterInfo(parameter).id);
        CHECK(match.advance(now) == 0);
    }
    now.set(mallet, firstRackMallet + 3);
    std::size_t work = 0;
    while (const auto taken = match.advance(now))
        work += taken;
    CHECK(work == 500);
}

TEST_CASE("The wheel changes the gain of scrapes but not of strikes") {
    ParameterValues own;
    own.set(matchLoudness, 1);
    for (const int kind : {strikeContact, scrapeContact}) {
        own.set(contact, kind);
        LoudnessMatch match({synthetic(40), {}, sampleRateHz}, own);
        const auto now = with(own, material, firstLibraryMaterial + 5);
        const double atRest = gainOf(match, now);
        match.setSpeedController(127);
        while (match.advance(now) > 0) {
        }
        CHECK((match.gainDb() != atRest) == (kind == scrapeContact));
        match.reset();
        CHECK(match.advance(with(now, matchLoudness, 1)) == 0);
        CHECK(match.gainDb() == atRest);
    }
}

TEST_CASE("After a reset the first cell has its final gain, whatever gain was prepared") {
    const auto instrument = synthetic(500);
    ParameterValues own;
    own.set(matchLoudness, 1);
    const auto complete = [](LoudnessMatch& match, const ParameterValues& values) {
        while (match.advance(values) > 0) {
        }
    };
    for (const int kind : {strikeContact, scrapeContact, rollContact}) {
        own.set(contact, kind);
        const auto now = with(own, material, firstLibraryMaterial + 5);
        LoudnessMatch fresh({instrument, {}, sampleRateHz}, own);
        const double gain = gainOf(fresh, now);
        REQUIRE(gain != 0);
        LoudnessMatch match({instrument, {}, sampleRateHz}, own);
        match.prepare(with(own, matchLoudness, 0));
        complete(match, now);
        match.setSpeedController(127);
        complete(match, now);
        for (int times = 0; times < 2; ++times) {
            match.reset();
            CHECK(match.advance(now) == 0);
            CHECK(match.gainDb() == gain);
        }

        // A reset during an unfinished prediction gives the same gain.
        const auto other = with(own, material, firstLibraryMaterial + 7);
        match.advance(other);
        match.reset();
        complete(match, other);
        CHECK(match.gainDb() == gainOf(fresh, other));
        match.advance(now);
        match.reset();
        CHECK(match.advance(with(now, matchLoudness, 0)) == 0);
        CHECK(match.gainDb() == 0);
    }
}

TEST_CASE("A prediction prepared for a wheel position gives the gain there and at rest") {
    ParameterValues own;
    own.set(matchLoudness, 1);
    own.set(contact, scrapeContact);
    const auto now = with(own, material, firstLibraryMaterial + 5);
    LoudnessMatch match({synthetic(500), {}, sampleRateHz}, own);
    const double atRest = gainOf(match, now);
    match.setSpeedController(127);
    while (match.advance(now) > 0) {
    }
    const double moved = match.gainDb();
    REQUIRE(moved != atRest);

    LoudnessMatch prepared({synthetic(500), {}, sampleRateHz}, own);
    prepared.prepare(now, 127);
    CHECK(prepared.gainDb() == atRest);
    CHECK(prepared.advance(now) == 0);
    CHECK(prepared.gainDb() == atRest);
    prepared.setSpeedController(127);
    CHECK(prepared.advance(now) == 0);
    CHECK(prepared.gainDb() == moved);
}

TEST_CASE("A song that starts as before has its gain at once and the same gains later") {
    const auto instrument = synthetic(500);
    ParameterValues own;
    own.set(matchLoudness, 1);
    for (const int kind : {strikeContact, scrapeContact}) {
        own.set(contact, kind);
        const auto first = with(own, material, firstLibraryMaterial + 5);
        const auto second = with(own, material, firstLibraryMaterial + 7);
        LoudnessMatch match({instrument, {}, sampleRateHz}, own);
        match.prepare(first);
        const auto pass = [&](const std::vector<ParameterValues>& parts) {
            std::vector<double> gainsDb;
            match.beginSong();
            for (const auto& values : parts)
                for (int cell = 0; cell < 200; ++cell) {
                    match.advance(values);
                    gainsDb.push_back(match.gainDb());
                }
            return gainsDb;
        };
        const auto expected = pass({first, second, own, second});
        REQUIRE(expected.front() != expected.back());
        CHECK((pass({first, second, own, second}) == expected));
        match.advance(first); // in the middle of a prediction
        CHECK((pass({first, second, own, second}) == expected));
        match.advance(second);
        auto quieter = first;
        quieter.set(level, -40); // the level changes no gain
        CHECK((pass({quieter, second, own, second}) == expected));

        // A song with other values is followed, and its gains replace the known ones.
        const auto other = pass({second, first});
        CHECK((pass({second, first}) == other));
        CHECK(other.back() == expected.front());
        match.setSpeedController(127);
        pass({second, first}); // the first pass with a new start takes time to predict
        const auto moved = pass({second, first});
        CHECK((moved == other) == (kind == strikeContact));
        CHECK((pass({second, first}) == moved));
        CHECK((pass({with(second, matchLoudness, 0)}) == std::vector<double>(200, 0)));
    }
}

TEST_CASE("A song too short for a prediction is matched after some passes") {
    ParameterValues own;
    own.set(matchLoudness, 1);
    const auto now = with(own, material, firstLibraryMaterial + 5);
    LoudnessMatch match({synthetic(500), {}, sampleRateHz}, own);
    match.prepare(own);
    int passes = 0;
    for (; match.gainDb() == 0 && passes < 10000; ++passes) {
        match.beginSong();
        match.advance(now);
    }
    CHECK(passes > 10);
    LoudnessMatch fresh({synthetic(500), {}, sampleRateHz}, own);
    CHECK(match.gainDb() == gainOf(fresh, now));
}
