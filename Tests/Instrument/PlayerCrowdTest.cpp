// Tests more simultaneous strikes than a player renders separately.
#include "SameInAllBlocks.h"
#include "Support/Level.h"
#include "Support/Phasor.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

std::shared_ptr<const Instrument> crowdedBar(const std::vector<double>& frequenciesHz) {
    return keysOn(syntheticObject(frequenciesHz), KeyMapKind::zones, 20, 110);
}

} // namespace

TEST_CASE("Strikes too many to be rendered separately are together as loud as their sum") {
    const auto instrument = crowdedBar({200, 540, 1070, 1800, 2500});
    ParameterValues parameters;
    parameters.set(ParameterId::strikeSpread, 0);
    parameters.set(ParameterId::modalPulse, GENERATE(0, 1));
    const auto struck = [&](int keys) {
        std::vector<MidiEvent> events;
        for (int i = 0; i < keys; ++i)
            events.push_back(midi(0, 0x90, 20 + i, 100));
        Player player(instrument, sampleRateHz);
        auto sound = render(player, events, 28800, 64, parameters);
        sound.erase(sound.begin(), sound.begin() + 2400);
        return sound;
    };
    const auto one = struck(1);
    for (const int keys : {16, 60, 90}) {
        const auto all = struck(keys);
        INFO(keys << " keys: " << rms(all) / rms(one) / keys);
        CHECK(rms(all) > 0.95 * keys * rms(one));
        CHECK(rms(all) < 1.25 * keys * rms(one));
        // Low frequencies, which get most of the impulse, do not change, because their phase is
        // that of the pulses.
        CHECK(std::abs(phasorAt(all, 200, sampleRateHz) / phasorAt(one, 200, sampleRateHz) -
                       double(keys)) < 0.02 * keys);
    }
}

TEST_CASE("Crowded strikes are bit-identical for block sizes 1, 64, 333 and 4096") {
    ParameterValues parameters;
    parameters.set(ParameterId::modalPulse, 1);
    parameters.set(ParameterId::chatter, 100);
    std::vector<MidiEvent> events;
    for (int i = 0; i < 300; ++i)
        events.push_back(midi(3 + 7 * i / 3, 0x90, 20 + i * 37 % 91, 1 + i % 127));
    const auto sound =
        checkSameInBlocksOf({1, 64, 333, 4096}, crowdedBar({60, 200, 540, 1070, 1800}),
                            sampleRateHz, events, 9600, parameters);
    CHECK(peak(sound.left) > 0.001f);
}
