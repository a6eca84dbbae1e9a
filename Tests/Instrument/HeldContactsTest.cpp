// Tests the sound of a held key by its pressure, speed and seed.
#include "Instrument/HeldContacts.h"
#include "HeldKeys.h"
#include "SameInAllBlocks.h"
#include "Support/Level.h"
#include "Support/Periodogram.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

/// Keys pressed, released and moved, more of them at a time than there are contacts.
std::vector<MidiEvent> busyHands(int samples) {
    std::mt19937 random(5);
    const auto below = [&](unsigned count) { return static_cast<int>(random() % count); };
    std::vector<MidiEvent> events;
    for (int time = 3; time < samples; time += below(200)) {
        const int note = 36 + below(45);
        switch (below(8)) {
        case 0:
            events.push_back(midi(time, 0x80, note, 0));
            break;
        case 1:
            events.push_back(midi(time, 0xa0, note, below(128)));
            break;
        case 2:
            events.push_back(midi(time, 0xd0, below(128), 0));
            break;
        case 3:
            events.push_back(midi(time, 0xb0, speedController, below(128)));
            break;
        case 4:
            events.push_back(midi(time, 0xb0, placeController, below(128)));
            break;
        default:
            events.push_back(midi(time, 0x90, note, 1 + below(127)));
        }
    }
    return events;
}

} // namespace

TEST_CASE("A held key sounds while it is held, and the object rings after the release") {
    const double kind = GENERATE(scrapeContact, rollContact);
    const std::vector events{midi(100, 0x90, 60, 100), midi(48000, 0x80, 60, 0)};
    const auto sound = play(plate(), events, 96000, scraping(kind));
    const auto during = [&](std::size_t from) { return rms(std::span(sound).subspan(from, 9600)); };
    CHECK(peak(std::span(sound).first(100)) == 0);
    CHECK(during(14400) > 1e-5);
    CHECK(during(38400) > 0.25 * during(14400));
    CHECK(during(48500) > 0.1 * during(38400));
    CHECK(during(86400) < 0.5 * during(38400));
}

TEST_CASE("The level is proportional to the root of the pressure and to the roughness") {
    const auto instrument = plate();
    const auto loudness = [&](int pressure, double rough = 1) {
        auto parameters = scraping();
        parameters.set(ParameterId::roughness, rough);
        return rms(play(instrument, {midi(0, 0x90, 60, 90), midi(0, 0xa0, 60, pressure)}, 48000,
                        parameters));
    };
    const double full = loudness(127);
    for (const int pressure : {8, 32, 64})
        CHECK(full / loudness(pressure) == Approx(std::sqrt(127.0 / pressure)).epsilon(0.02));
    CHECK(loudness(127, 3) == Approx(3 * full).epsilon(0.02));
    CHECK(loudness(0) == 0);
}

TEST_CASE("The velocity is the pressure until a pressure message of either kind arrives") {
    const auto instrument = plate();
    const auto byVelocity = play(instrument, {midi(0, 0x90, 60, 50)}, 9600);
    CHECK(peak(byVelocity) > 0);
    CHECK(play(instrument, {midi(0, 0x90, 60, 120), midi(0, 0xa0, 60, 50)}, 9600) == byVelocity);
    CHECK(play(instrument, {midi(0, 0x90, 60, 120), midi(0, 0xd0, 50, 0)}, 9600) == byVelocity);
    CHECK(play(instrument, {midi(0, 0x90, 60, 50), midi(0, 0xa0, 61, 127)}, 9600) == byVelocity);
}

TEST_CASE("A faster scrape is louder and brighter, and speed 0 is silent") {
    const auto instrument = plate();
    double lastCentroidHz = 0, lastLevel = 0;
    for (const int wheel : {20, 40, 64, 90, 127}) {
        const auto sound = play(
            instrument, {midi(0, 0xb0, speedController, wheel), midi(0, 0x90, 60, 100)}, 96000);
        const double centroidHz = Periodogram(sound, playRateHz).centroidHz();
        INFO("CC1 " << wheel << ": " << centroidHz << " Hz, level " << rms(sound));
        CHECK(centroidHz > lastCentroidHz);
        CHECK(rms(sound) > lastLevel);
        lastCentroidHz = centroidHz;
        lastLevel = rms(sound);
    }
    CHECK(peak(play(instrument, {midi(0, 0xb0, speedController, 0), midi(0, 0x90, 60, 100)},
                    4800)) == 0);
    CHECK(play(instrument, {midi(0, 0x90, 60, 100)}, 4800) ==
          play(instrument, {midi(0, 0xb0, speedController, 64), midi(0, 0x90, 60, 100)}, 4800));
}

TEST_CASE("Reset All Controllers resets speed, place and pressure") {
    const auto instrument = plate();
    const auto moved =
        play(instrument,
             {midi(0, 0xb0, speedController, 100), midi(0, 0xb0, placeController, 10),
              midi(0, 0xb0, 121, 0), midi(0, 0x90, 60, 100)},
             9600);
    const auto still = play(instrument, {midi(0, 0x90, 60, 100)}, 9600);
    CHECK(moved == still);
    for (const auto& pressure : {midi(0, 0xa0, 60, 3), midi(0, 0xd0, 3, 0)})
        CHECK(play(instrument, {midi(0, 0x90, 60, 100), pressure, midi(0, 0xb0, 121, 0)}, 9600) ==
              still);
}

TEST_CASE("Held contacts are bit-identical for block sizes 1, 7, 64, 480 and 4096") {
    auto parameters = scraping(GENERATE(scrapeContact, rollContact, bowContact));
    parameters.set(ParameterId::radiation, 50);
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::rollCoupling, 60);
    const auto sound = checkSameInBlocksOf({1, 7, 64, 480, 4096}, GENERATE(plate(), shortBars()),
                                           playRateHz, busyHands(12000), 12000, parameters);
    CHECK(peak(sound.left) > 1e-5f);
}

TEST_CASE("Another seed changes the sound but not its loudness; another surface changes both") {
    const auto instrument = plate();
    const std::vector events{midi(0, 0x90, 60, 100)};
    const auto sound = [&](const Surface& surface, std::uint64_t seed) {
        Player player(instrument, playRateHz, surface, seed);
        return render(player, events, 96000, 480, scraping());
    };
    const auto first = sound({}, 1), second = sound({}, 2);
    CHECK(sound({}, 1) == first);
    CHECK(second != first);
    CHECK(std::abs(20 * std::log10(rms(second) / rms(first))) < 2);
    Surface rough;
    rough.roughness = 5;
    CHECK(rms(sound(rough, 1)) == Approx(10 * rms(first)).epsilon(0.02));
}
