// Tests where a held key touches its object: its own place, CC74, and the path between.
#include "HeldKeys.h"
#include "Support/Level.h"
#include "Support/Periodogram.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

/// One key at the left end of a square's middle line. Only the square's right half sounds.
std::shared_ptr<const Instrument> halfDeafSquare(float sideMetres) {
    auto object = syntheticObject({500});
    object.vertices = {0, 0, 0, 0.5f, 0, 0, 1, 0, 0, 1, 1, 0, 0.5f, 1, 0, 0, 1, 0};
    object.faces = {0, 1, 4, 0, 4, 5, 1, 2, 3, 1, 3, 4};
    object.shapeVertices = {0, 1, 2, 3, 4, 5};
    object.shapes.assign(18, 0);
    for (float& coordinate : object.vertices)
        coordinate *= sideMetres;
    for (const std::size_t row : {2u, 3u})
        object.shapes[row * 3 + 2] = 1;
    return keysOn(std::move(object), KeyMapKind::zones, 60, 61);
}

} // namespace

TEST_CASE("CC74 moves the contact from end to end of the strip; 64 is the key's own place") {
    const auto instrument = plate();
    const auto at = [&](int place, int note) {
        return play(instrument, {midi(0, 0xb0, placeController, place), midi(0, 0x90, note, 100)},
                    9600);
    };
    const auto lowest = play(instrument, {midi(0, 0x90, 36, 100)}, 9600);
    const auto highest = play(instrument, {midi(0, 0x90, 96, 100)}, 9600);
    CHECK(peak(lowest) > 0);
    CHECK(lowest != highest);
    CHECK(at(0, 60) == lowest);
    CHECK(at(127, 60) == highest);
    CHECK(at(64, 60) == play(instrument, {midi(0, 0x90, 60, 100)}, 9600));
}

TEST_CASE("A held contact ends at the place that CC74 sets, and the spectrum changes") {
    const auto instrument = plate();
    const auto spectrum = [&](const std::vector<MidiEvent>& events) {
        auto sound = play(instrument, events, 144000);
        sound.erase(sound.begin(), sound.begin() + 48000);
        const Periodogram power(sound, playRateHz);
        std::array<double, 3> decibels{};
        for (std::size_t band = 0; band < decibels.size(); ++band) {
            const double lowHz = 80 * std::pow(3, static_cast<double>(band));
            decibels[band] = 10 * std::log10(power.power(lowHz, 3 * lowHz));
        }
        return decibels;
    };
    const MidiEvent note = midi(0, 0x90, 60, 100);
    const auto moved = spectrum({note, midi(4800, 0xb0, placeController, 127)});
    const auto there = spectrum({midi(0, 0xb0, placeController, 127), note});
    const auto stayed = spectrum({note});
    double furthest = 0;
    for (std::size_t band = 0; band < moved.size(); ++band) {
        INFO("band " << band << ": " << moved[band] << " dB, there " << there[band] << ", stayed "
                     << stayed[band]);
        CHECK(std::abs(moved[band] - there[band]) < 1.5);
        furthest = std::max(furthest, std::abs(moved[band] - stayed[band]));
    }
    CHECK(furthest > 3);
}

TEST_CASE("A contact follows CC74 at 5 m/s, or within 20 ms on a small object") {
    const auto samplesToTheMiddle = [](float sideMetres) {
        const auto sound =
            play(halfDeafSquare(sideMetres),
                 {midi(0, 0x90, 60, 100), midi(4800, 0xb0, placeController, 127)}, 19200);
        const auto first = std::ranges::find_if(sound, [](float x) { return x != 0; });
        return static_cast<double>(first - sound.begin()) - 4800;
    };
    CHECK(samplesToTheMiddle(1) == Approx(0.1 * playRateHz).margin(2 * cellSamples));
    const double small = samplesToTheMiddle(0.01f);
    CHECK(small > 0.002 * playRateHz);
    CHECK(small < 0.01 * playRateHz);
}

TEST_CASE("Every value of CC74 and every key of a plate has its own sound") {
    const auto instrument = plate();
    std::set<std::vector<float>> sounds;
    for (int value = 0; value < 128; ++value)
        sounds.insert(play(instrument,
                           {midi(0, 0xb0, placeController, value), midi(0, 0x90, 66, 100)}, 2400));
    CHECK(sounds.size() == 128);
    sounds.clear();
    for (int note = 36; note <= 96; ++note)
        sounds.insert(play(instrument, {midi(0, 0x90, note, 100)}, 2400));
    CHECK(sounds.size() == 61);
}
