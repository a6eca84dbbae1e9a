// Tests of the on-screen keyboard: which keys play, and the place of the computer's keys.
#include "Editor/KeyboardPanel.h"

#include "Editor/Look.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/Processor.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("The computer's keys from A to L play in every preset of two octaves without shifting") {
    constexpr int fromAToL = 14;          // semitones above the key A
    constexpr int enough = 11 + fromAToL; // for a C with these keys above it
    for (const auto& preset : factoryPresets()) {
        const auto& map = preset.keyMap;
        INFO(preset.name);
        const int base = computerKeysBase({.lowest = map.lowestNote, .highest = map.highestNote});
        CHECK(base % 12 == 0);
        const bool isWide = map.highestNote - map.lowestNote >= enough;
        CHECK(base >= map.lowestNote - (isWide ? 0 : 11));
        CHECK(base + fromAToL <= map.highestNote + (isWide ? 0 : fromAToL - 1));
    }
    CHECK(computerKeysBase({.lowest = 0, .highest = 127}) == 0);
    CHECK(computerKeysBase({.lowest = 61, .highest = 73}) == 60); // from 72 only two keys play
    CHECK(computerKeysBase({.lowest = 121, .highest = 127}) == 120);
}

TEST_CASE("Silent keys and keys that play another key's bar look different from others") {
    // On the rosewood xylophone A0 to E4 play the F4 bar, and keys below A0 are silent.
    Processor processor;
    for (const auto scheme : {LookScheme::dark, LookScheme::light}) {
        Look look(scheme);
        KeyboardPanel panel(processor.view());
        panel.setLookAndFeel(&look);
        panel.setBounds(0, 0, 57 * 40, 100); // C0 to C8
        const auto picture = panel.createComponentSnapshot(panel.getLocalBounds());
        const auto brightness = [&](int x, int y) {
            return picture.getPixelAt(x, y).getPerceivedBrightness();
        };
        constexpr int foot = 80, rim = 66; // pixels from the top, on white and on black keys
        const auto white = [&](int octave, int step) {
            return brightness((7 * octave + step) * 40 + 20, foot);
        };
        const auto black = [&](int octave, int step) {
            return brightness((7 * octave + step) * 40, rim);
        };
        CHECK(white(4, 0) < 0.9f * white(4, 3)); // C4, F4
        CHECK(white(0, 0) < 0.9f * white(4, 0)); // C0, C4
        CHECK(black(4, 1) > 1.2f * black(4, 4)); // C♯4, F♯4
        CHECK(black(0, 1) > 1.2f * black(4, 1)); // C♯0, C♯4
        panel.setLookAndFeel(nullptr);
    }
}

TEST_CASE("Z and X shift the computer's keys by one octave per press; key repeats are ignored") {
    Processor processor;
    KeyboardPanel panel(processor.view());
    const auto press = [&](juce::juce_wchar letter) {
        return panel.pressOctaveKey({static_cast<int>(letter), {}, letter});
    };
    const int first = panel.computerKeysNote();
    for (int repeat = 0; repeat < 3; ++repeat)
        CHECK(press('x'));
    CHECK(panel.computerKeysNote() == first + 12);
    CHECK(press('z')); // while X is down
    CHECK(panel.computerKeysNote() == first);
    for (int times = 1; times <= 2; ++times) {
        panel.releaseKeys();
        CHECK(press('X'));
        CHECK(panel.computerKeysNote() == first + 12 * times);
    }
    CHECK_FALSE(press('y'));
    CHECK_FALSE(panel.pressOctaveKey({'z', juce::ModifierKeys::ctrlModifier, 'z'}));
    CHECK(panel.computerKeysNote() == first + 24);
}

TEST_CASE("Marked keys have a line at their feet, in both looks") {
    Processor processor;
    for (const auto scheme : {LookScheme::dark, LookScheme::light}) {
        Look look(scheme);
        KeyboardPanel panel(processor.view());
        panel.setLookAndFeel(&look);
        panel.setBounds(0, 0, 57 * 40, 100); // C0 to C8
        const auto footOf = [&](int octave, int step) {
            const auto picture = panel.createComponentSnapshot(panel.getLocalBounds());
            return picture.getPixelAt((7 * octave + step) * 40 + 20, 97);
        };
        const auto plain = footOf(4, 3); // F4
        panel.mark(InstrumentView::KeyRange{.lowest = 65, .highest = 67});
        CHECK(footOf(4, 3) == colourOf(scheme, LookColour::accent));
        CHECK(footOf(4, 4) == colourOf(scheme, LookColour::accent)); // G4
        CHECK(footOf(4, 5) == plain);                                // A4
        panel.mark(std::nullopt);
        CHECK(footOf(4, 3) == plain);
        panel.setLookAndFeel(nullptr);
    }
}
