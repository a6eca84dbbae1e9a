// Tests MPE zones: a zone's own channel acts on its members, and another player takes the zones
// over.
#include "HeldKeys.h"
#include "Instrument/Player.h"
#include "Support/Level.h"
#include "Support/PoleFit.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <utility>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

ParameterValues withMpe(ParameterValues values) {
    values.set(ParameterId::mpe, 1);
    values.set(ParameterId::strikeSpread, 0);
    return values;
}

/// Values for keys that scrape and for keys that strike, with the MPE parameter on.
std::vector<ParameterValues> bothContacts() {
    return {withMpe(scraping(scrapeContact)), withMpe(scraping(strikeContact))};
}

std::vector<float> played(const std::vector<MidiEvent>& events, const ParameterValues& values) {
    return play(plate(), events, 9600, values);
}

} // namespace

TEST_CASE("Pressure, CC1 and CC74 of a zone's own channel act on every member") {
    const int member = GENERATE(1, 2, 15);
    const MidiEvent message =
        GENERATE(midi(3000, 0xd0, 20, 0), midi(0, 0xb0, 1, 110), midi(0, 0xb0, 74, 20));
    CAPTURE(member, int{message.bytes[0]}, int{message.bytes[1]});
    const auto key = midi(64, 0x90 | member, 60, 100);
    const auto with = [&](MidiEvent sent, int channel) {
        sent.bytes[0] = static_cast<std::uint8_t>((sent.bytes[0] & 0xf0) | channel);
        std::vector events{sent, key};
        std::ranges::stable_sort(events, {}, &MidiEvent::sampleOffset);
        return events;
    };
    for (const auto& values : bothContacts()) {
        const auto byZone = played(with(message, 0), values);
        CHECK(byZone == played(with(message, member), values));
        const bool isSpeedOfStrike = strikes(values) && message.bytes[1] == 1;
        CHECK((byZone == played({key}, values)) == isSpeedOfStrike);
    }
}

TEST_CASE("Reset All Controllers on a zone's own channel resets every member") {
    const int member = GENERATE(1, 2, 15);
    CAPTURE(member);
    const auto key = midi(64, 0x90 | member, 60, 100);
    const auto pressed = midi(64, 0xd0 | member, 20, 0), reset = midi(64, 0xb0, 121, 0);
    for (const auto& values : bothContacts()) {
        const auto untouched = played({key}, values);
        CHECK(played({midi(0, 0xb0 | member, 1, 3), midi(0, 0xb0 | member, 74, 3),
                      midi(10, 0xb0, 121, 0), key},
                     values) == untouched);
        CHECK(played({key, pressed}, values) != untouched);
        CHECK(played({key, pressed, reset}, values) == untouched);
    }
}

TEST_CASE("Zones, bend ranges and wheels stay in place when another player takes over") {
    const bool byParameter = GENERATE(true, false);
    CAPTURE(byParameter);
    ParameterValues values;
    values.set(ParameterId::mpe, byParameter);
    std::vector<MidiEvent> setup;
    const auto give = [&setup](int channel, int parameter, int value) {
        for (const auto& [number, data] : {std::pair{101, 0}, {100, parameter}, {6, value}})
            setup.push_back(midi(0, 0xb0 | channel, number, data));
    };
    if (!byParameter)
        give(0, 6, 3);
    give(1, 0, 24);
    setup.push_back(midi(0, 0xe1, 127, 127)); // wheel of the first member
    Player former(bars(), sampleRateHz), next(bars(), sampleRateHz);
    render(former, setup, 64, 64, values);
    next.takeControllersOf(former);
    const auto sound =
        render(next, {midi(0, 0x91, 60, 100), midi(0, 0x92, 72, 100), midi(0, 0xe2, 0, 0)}, 24000,
               480, values);
    for (const int note : {60 + 24, 72 - 24}) {
        const double hertz = 440 * std::exp2((note - 69) / 12.0);
        const auto fitted = fitPole(sound, sampleRateHz, hertz, 0.05);
        CHECK(std::abs(cents(fitted.frequencyHz, hertz)) < 1);
    }
}
