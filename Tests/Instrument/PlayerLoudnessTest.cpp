// Tests how a player applies the gain that matches loudness.
#include "Instrument/LoudnessMatch.h"
#include "Instrument/Player.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;
constexpr int modulation = 1; // the wheel's controller

} // namespace

TEST_CASE("Matching loudness applies the predicted gain from the first sample") {
    const auto instrument = bars();
    ParameterValues own;
    own.set(ParameterId::strikeSpread, 0);
    ParameterValues hard = own;
    hard.set(ParameterId::malletMass, 80);
    const LoudnessMatch match({instrument, {}, sampleRateHz}, own);
    hard.set(ParameterId::matchLoudness, 1);
    const double gain = std::pow(10, match.gainDb(hard) / 20);
    hard.set(ParameterId::matchLoudness, 0);
    CHECK(gain < 0.7);
    const std::vector events{midi(10, 0x90, 64, 100), midi(700, 0x90, 69, 100)};
    Player plain(instrument, sampleRateHz, {}, 1, own);
    Player matching(instrument, sampleRateHz, {}, 1, own);
    matching.setOffline(true);
    const auto before = render(plain, events, 9600, 333, hard);
    hard.set(ParameterId::matchLoudness, 1);
    const auto after = render(matching, events, 9600, 480, hard);
    for (std::size_t i = 0; i < before.size(); ++i)
        REQUIRE(double(after[i]) == Approx(gain * double(before[i])).margin(1e-7).epsilon(1e-4));
}

TEST_CASE("A render after a reset equals that of a newly prepared player") {
    const auto instrument = bars();
    ParameterValues own;
    for (const int kind : {strikeContact, scrapeContact, rollContact}) {
        own.set(ParameterId::contact, kind);
        auto values = own;
        values.set(ParameterId::matchLoudness, 1);
        values.set(ParameterId::material, firstLibraryMaterial + 5);
        values.set(ParameterId::malletMass, 200);
        const std::vector events{midi(10, 0x90, 64, 100), midi(6000, 0x80, 64, 0),
                                 midi(7000, 0x90, 69, 100)};
        Player fresh(instrument, sampleRateHz, {}, 1, own);
        fresh.prepare(values);
        const auto expected = renderStereo(fresh, events, 12000, 480, values);
        REQUIRE(peak(expected.left) > 0);

        Player player(instrument, sampleRateHz, {}, 1, own);
        player.prepare(own);
        player.setOffline(true);
        renderStereo(player, events, 12000, 480, own);
        renderStereo(player, events, 48000, 333, values);
        renderStereo(player, {midi(0, 0xb0, modulation, 120)}, 48000, 333, values);
        for (int times = 0; times < 2; ++times) {
            player.reset();
            CHECK((renderStereo(player, events, 12000, 480, values) == expected));
        }
    }
}

TEST_CASE("A player prepared for a wheel position starts with the gain for that position") {
    const auto instrument = bars();
    ParameterValues own;
    own.set(ParameterId::contact, scrapeContact);
    auto values = own;
    values.set(ParameterId::material, firstLibraryMaterial + 5);
    Player former(instrument, sampleRateHz);
    renderStereo(former, {midi(0, 0xb0, modulation, 120)}, 480, 480, own);
    REQUIRE(former.modulationWheel() == 120);

    auto matched = values;
    matched.set(ParameterId::matchLoudness, 1);
    const LoudnessMatch match({instrument, {}, sampleRateHz}, own);
    const double gain = std::pow(10, match.gainDb(matched, 120) / 20);
    REQUIRE(std::abs(gain - 1) > 0.01);
    const auto rendered = [&](const ParameterValues& of) {
        Player player(instrument, sampleRateHz, {}, 1, own);
        player.prepare(of, former.modulationWheel());
        player.takeControllersOf(former);
        return render(player, {midi(0, 0x90, 64, 100)}, 9600, 480, of);
    };
    const auto plain = rendered(values), after = rendered(matched);
    REQUIRE(peak(plain) > 0);
    for (std::size_t i = 0; i < plain.size(); ++i)
        REQUIRE(double(after[i]) == Approx(gain * double(plain[i])).margin(1e-9).epsilon(1e-4));
}

TEST_CASE("A mallet change with matched loudness moves the gain without a step") {
    const auto instrument = bars();
    ParameterValues own;
    own.set(ParameterId::matchLoudness, 1);
    own.set(ParameterId::strikeSpread, 0);
    ParameterValues heavy = own;
    heavy.set(ParameterId::malletMass, 200);
    const auto ringing = [&](int blockSize) {
        Player player(instrument, sampleRateHz, {}, 1, own);
        player.setOffline(true);
        auto sound = render(player, {midi(0, 0x90, 64, 100)}, 9600, blockSize, own);
        const auto later = render(player, {}, 9600, blockSize, heavy);
        sound.insert(sound.end(), later.begin(), later.end());
        return sound;
    };
    const auto sound = ringing(480);
    CHECK(sound == ringing(64));
    Player still(instrument, sampleRateHz, {}, 1, own);
    const auto unchanged = render(still, {midi(0, 0x90, 64, 100)}, 19200, 480, own);
    double last = 1, steepest = 0;
    for (std::size_t i = 9000; i < sound.size(); ++i) {
        if (std::abs(unchanged[i]) < 0.02f * peak(unchanged))
            continue;
        const double ratio = double(sound[i]) / double(unchanged[i]);
        steepest = std::max(steepest, std::abs(ratio - last));
        last = ratio;
    }
    CHECK(last < 0.5);
    CHECK(steepest < 0.02);
}

TEST_CASE("In real time a mallet change sounds without a gain until it has been answered") {
    const auto instrument = bars();
    ParameterValues own;
    own.set(ParameterId::matchLoudness, 1);
    own.set(ParameterId::strikeSpread, 0);
    auto heavy = own;
    heavy.set(ParameterId::malletMass, 200);
    const auto unmatched = [&] {
        auto values = heavy;
        values.set(ParameterId::matchLoudness, 0);
        return values;
    }();
    Player player(instrument, sampleRateHz, {}, 1, own), plain(instrument, sampleRateHz, {}, 1);
    const auto strike = [&](Player& struck, const ParameterValues& values) {
        return render(struck, {midi(0, 0x90, 64, 100)}, 9600, 480, values);
    };
    CHECK(strike(player, heavy) == strike(plain, unmatched));
    player.matchedGain()->answer();
    for (auto* each : {&player, &plain})
        render(*each, {}, 48000, 480, each == &player ? heavy : unmatched); // the gain glides
    CHECK(peak(strike(player, heavy)) < 0.6f * peak(strike(plain, unmatched)));
}
