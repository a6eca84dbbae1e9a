// Tests how release velocities and dead strokes damp the sound of a player.
#include "Instrument/Dampers.h"

#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "Support/Routes.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

namespace {

constexpr double sampleRateHz = 48000;
constexpr int key = 69;

std::vector<float> played(const std::vector<MidiEvent>& events, const ParameterValues& parameters) {
    Player player(bars(), sampleRateHz);
    return render(player, events, 14400, 480, parameters);
}

std::vector<MidiEvent> releasedAt(int velocity) {
    return {midi(0, 0x90, key, 100), midi(2400, 0x80, key, velocity)};
}

/// Returns by how many dB the first sound is below the second 5 ms around a sample.
double dbBelow(const std::vector<float>& sound, const std::vector<float>& other, std::size_t at) {
    const auto around = [at](const std::vector<float>& samples) {
        return rms(std::span(samples).subspan(at - 240, 480));
    };
    return 20 * std::log10(around(other) / around(sound));
}

} // namespace

TEST_CASE("A fast release damps sooner, up to ten times") {
    const auto damping = with(with(ParameterValues(), letRing, 0), releaseTime, 2);
    const auto plain = played(releasedAt(0), damping);
    CHECK(played(releasedAt(64), damping) == plain);
    CHECK(played(releasedAt(30), damping) == plain);
    const auto ringing = played({midi(0, 0x90, key, 100)}, damping);
    const double released = 2432, after = 4832; // the grid point of the release, 50 ms later
    const auto at = static_cast<std::size_t>(after);
    const double plainDb = 60 * (after - released) / sampleRateHz / 2;
    CHECK(dbBelow(plain, ringing, at) == Approx(plainDb).margin(0.1));
    CHECK(dbBelow(played(releasedAt(127), damping), ringing, at) ==
          Approx(10 * plainDb).margin(0.3));
    CHECK(dbBelow(played(releasedAt(96), damping), ringing, at) ==
          Approx(std::pow(10, 32 / 63.0) * plainDb).margin(0.2));

    const auto ring = with(damping, letRing, 1);
    CHECK(played(releasedAt(127), ring) == played(releasedAt(0), ring));
}

TEST_CASE("A new strike forgets how fast the key was released before") {
    const auto damping = with(with(ParameterValues(), letRing, 0), releaseTime, 0.2);
    auto events = releasedAt(127);
    events.insert(events.end(), {midi(2500, 0x90, key, 100), midi(4800, 0x80, key, 0)});
    const auto sound = played(events, damping);
    const auto levelAt = [&](std::size_t at) { return rms(std::span(sound).subspan(at, 960)); };
    const double fallDb = 20 * std::log10(levelAt(5400) / levelAt(9000));
    CHECK(fallDb == Approx(60 * 3600 / sampleRateHz / 0.2).margin(2));
}

TEST_CASE("A dead stroke stops ringing while held and after, until the next stroke") {
    const ParameterValues live;
    const auto dead = with(live, deadStroke, 1);
    const std::vector strike{midi(0, 0x90, key, 100), midi(480, 0x80, key, 0)};
    const auto ringing = played(strike, live), stopped = played(strike, dead);
    CHECK(peak(stopped) > peak(ringing) / 2); // the strike itself is heard
    const double perSecond = 60 / Dampers::deadStrokeSeconds;
    for (const std::size_t at : {1440, 3840})
        CHECK(dbBelow(stopped, ringing, at) ==
              Approx(perSecond * static_cast<double>(at) / sampleRateHz).margin(1.5));

    Player player(bars(), sampleRateHz);
    render(player, strike, 4800, 480, dead);
    const auto again = render(player, strike, 9600, 480, live);
    CHECK(dbBelow(again, ringing, 4800) < 1);
}

TEST_CASE("A dead stroke leaves scrapes and other keys alone") {
    const auto dead = with(ParameterValues(), deadStroke, 1);
    const std::vector scrape{midi(0, 0x90, key, 100)};
    CHECK(played(scrape, with(dead, contact, scrapeContact)) ==
          played(scrape, with(ParameterValues(), contact, scrapeContact)));

    Player player(bars(), sampleRateHz);
    render(player, {midi(0, 0x90, 60, 100)}, 480, 480);
    const auto beside = render(player, {midi(0, 0x90, key, 1)}, 9600, 480, dead);
    Player alone(bars(), sampleRateHz);
    render(alone, {midi(0, 0x90, 60, 100)}, 480, 480);
    CHECK(dbBelow(beside, render(alone, {}, 9600, 480), 9000) == Approx(0).margin(0.3));
}

TEST_CASE("Modulation gives each key its own release time") {
    auto parameters = with(with(ParameterValues(), letRing, 0), releaseTime, 0.1);
    const auto& info = parameterInfo(releaseTime);
    const double upTo1s = 100 * (info.toNormalised(1) - info.toNormalised(0.1));
    parameters = routed(0, ModulationSource::velocity, releaseTime, upTo1s, parameters);
    const std::vector events{midi(0, 0x90, key, 127), midi(2400, 0x80, key, 0)};
    const auto ringing = played({events[0]}, parameters);
    CHECK(dbBelow(played(events, parameters), ringing, 7232) == Approx(6).margin(0.2));
}
