// Tests how a held contact ends: by a release, All Sound Off, or a further key.
#include "HeldKeys.h"
#include "Support/Highs.h"
#include "Support/Level.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE(
    "The force ends 10 ms after the key's release, and silence follows, at every sample rate") {
    const double rateHz = GENERATE(8000, 11025, 48000, 96000, 192000);
    const auto instrument = shortBars();
    const auto samples = [rateHz](double seconds) { return static_cast<int>(seconds * rateHz); };
    const int grid = samples(0.2) / cellSamples * cellSamples;
    for (const int release : {grid, grid + 1, grid + 33, grid + cellSamples - 1}) {
        Player player(instrument, rateHz);
        const auto sound = render(player, {midi(0, 0x90, 60, 127), midi(release, 0x80, 60, 0)},
                                  static_cast<std::size_t>(2 * grid), 64, scraping());
        const auto from = [&](double seconds) {
            return std::span(sound).subspan(static_cast<std::size_t>(release + samples(seconds)),
                                            static_cast<std::size_t>(samples(0.002)));
        };
        const auto held = rms(std::span(sound).subspan(static_cast<std::size_t>(grid / 2),
                                                       static_cast<std::size_t>(grid / 4)));
        CHECK(held > 1e-6);
        // The modes fall by 1 dB in 0.23 ms: by 60 dB within 14 ms.
        CHECK(rms(from(0.01 + 0.014)) < 2e-3 * held);
        // The modes fall at the rate of free modes.
        const double fallDb = 20 * std::log10(rms(from(0.010)) / rms(from(0.014)));
        INFO(rateHz << " Hz, released at +" << release - grid << ": fell by " << fallDb << " dB");
        CHECK(fallDb > 14);
        CHECK(player.silent());
    }
}

TEST_CASE("One key beyond the capacity releases the oldest") {
    std::vector<MidiEvent> events;
    for (int i = 0; i <= static_cast<int>(HeldContacts::capacity); ++i)
        events.push_back(midi(100 * i, 0x90, 40 + i, 100));
    Player player(shortBars(), playRateHz);
    render(player, events, 19200, 480, scraping());
    const auto status = player.synthesiser().status();
    CHECK(status[0].amplitude == 0);
    for (std::size_t slot = 1; slot <= HeldContacts::capacity; ++slot)
        CHECK(status[slot].amplitude > 0);
}

TEST_CASE("A replaced or silenced contact fades like a released one") {
    const auto instrument = plate({{-0.9, 0.9, 0}, {0, 0.9, 0}});
    auto parameters = scraping(rollContact);
    parameters.set(ParameterId::contactForce, 20);
    const MidiEvent loud = midi(0, 0x90, 60, 127);
    const auto highsAfter = [&](const std::vector<MidiEvent>& events) {
        const auto sound = play(instrument, events, 25200, parameters);
        return loudestHighsDb(std::span(sound).subspan(23600), playRateHz);
    };
    std::vector<MidiEvent> crowd{loud};
    for (int i = 0; i < static_cast<int>(HeldContacts::capacity) - 1; ++i)
        crowd.push_back(midi(10, 0x90, 70 + i, 1));
    const double heldDb = highsAfter(crowd);
    crowd.push_back(midi(24000, 0x90, 90, 1));
    const double stolenDb = highsAfter(crowd);
    const double releasedDb = highsAfter({loud, midi(24000, 0x80, 60, 0)});
    const double silencedDb = highsAfter({loud, midi(24000, 0xb0, 120, 0)});
    INFO("held " << heldDb << " dB above 8 kHz, stolen " << stolenDb << ", released " << releasedDb
                 << ", silenced " << silencedDb);
    CHECK(stolenDb < heldDb + 3);
    CHECK(releasedDb < heldDb + 3);
    // The damper acts at once. A force that is cut off would reach about the peak itself.
    const double peakDb = 20 * std::log10(peak(play(instrument, {loud}, 25200, parameters)));
    CHECK(silencedDb < peakDb - 30);
}

TEST_CASE("A key pressed again during its fade-out begins as from silence") {
    const auto instrument = plate();
    const auto highsAfter = [&](const std::vector<MidiEvent>& events) {
        const auto sound = play(instrument, events, 25200, scraping(rollContact));
        return loudestHighsDb(std::span(sound).subspan(23600), playRateHz);
    };
    const MidiEvent again = midi(24300, 0x90, 60, 127);
    const double freshDb = highsAfter({again});
    const double backDb = highsAfter({midi(0, 0x90, 60, 127), midi(24000, 0x80, 60, 0), again});
    INFO("from silence " << freshDb << " dB above 8 kHz, back " << backDb);
    CHECK(backDb < freshDb + 3);
}

TEST_CASE("All Sound Off, All Notes Off and a change to strikes end a held contact") {
    const auto instrument = shortBars();
    const auto silentAfter = [&](const MidiEvent& event, const ParameterValues& then) {
        Player player(instrument, playRateHz);
        render(player, {midi(0, 0x90, 60, 127)}, 9600, 480, scraping());
        CHECK_FALSE(player.silent());
        render(player, {event}, 4800, 480, then);
        return player.silent();
    };
    CHECK(silentAfter(midi(0, 0xb0, 120, 0), scraping()));
    CHECK(silentAfter(midi(0, 0xb0, 123, 0), scraping()));
    CHECK(silentAfter(midi(0, 0xe0, 0, 64), ParameterValues()));
    CHECK_FALSE(silentAfter(midi(0, 0xe0, 0, 64), scraping()));
}
