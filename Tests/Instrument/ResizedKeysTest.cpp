// Tests keys without an object in the preset: they play the nearest object, resized.
#include "Instrument/HeldContacts.h"
#include "Instrument/Instrument.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "Instrument/SilencedModes.h"
#include "Support/KeyedPresets.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "Support/SyntheticObject.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;
constexpr int lowestAsked = 24, highestAsked = 108;

const SynthesiserSlot& slotOf(const Instrument& instrument, int note) {
    return instrument.slots()[static_cast<std::size_t>(instrument.key(note).slot)];
}

/// Bars for notes 60, 62 and 67 of a range from 60 to 67.
struct GappedBars {
    ObjectLibrary library;
    std::vector<std::shared_ptr<const ModalObject>> kept;
    KeyMap map{.kind = KeyMapKind::bars,
               .lowestNote = 60,
               .highestNote = 67,
               .object = "no/such/folder/{note}.modal"};

    GappedBars() {
        for (const int note : {60, 62, 67}) {
            const double hz = 440 * std::exp2((note - 69) / 12.0);
            kept.push_back(library.add(map.objectFor(note), syntheticObject({hz, 3 * hz})));
        }
    }
    std::shared_ptr<const Instrument> build() { return Instrument::build(map, library).value(); }
};

/// Returns the energy in dB of the first 200 ms of every key from 24 to 108 at velocity 100.
std::array<double, 128> keyLevels(const Preset& preset) {
    auto values = preset.parameters;
    values.set(ParameterId::strikeSpread, 0);
    Player player(Instrument::build(preset.keyMap, ObjectLibrary::shared()).value(), sampleRateHz,
                  preset.surface, preset.seed);
    std::array<double, 128> levels{};
    for (int note = lowestAsked; note <= highestAsked; ++note) {
        player.reset();
        const auto sound = render(player, {midi(0, 0x90, note, 100)}, 9600, 480, values);
        double energy = 0;
        for (const float sample : sound)
            energy += double(sample) * double(sample);
        levels[static_cast<std::size_t>(note)] = 10 * std::log10(energy + 1e-30);
    }
    return levels;
}

} // namespace

TEST_CASE("Keys beside and between a preset's bars play the nearest bar, resized to their pitch") {
    GappedBars bars;
    const auto instrument = bars.build();
    const auto check = [&](int note, int nearest) {
        INFO(note);
        const double ratio = std::exp2((nearest - note) / 12.0);
        const auto& slot = slotOf(*instrument, note);
        CHECK(slot.object == slotOf(*instrument, nearest).object);
        CHECK(slot.sizeRatio == Approx(ratio));
        REQUIRE(slot.pitch);
        CHECK(slot.pitch->hz == Approx(440 * std::exp2((note - 69) / 12.0)).epsilon(1e-4));
        CHECK(instrument->key(note).mallet.scale == Approx(ratio));
        CHECK(instrument->key(note).strip == instrument->key(nearest).strip);
        CHECK(instrument->hasOwn(note) == (note == nearest));
    };
    for (const int own : {60, 62, 67})
        check(own, own);
    check(21, 60);
    check(59, 60);
    check(61, 60); // the lower of two
    check(64, 62);
    check(65, 67);
    check(108, 67);
    CHECK(instrument->key(20).slot < 0);
    CHECK(instrument->key(109).slot < 0);
    CHECK(instrument->keysHaveObjects());
}

TEST_CASE("A preset sets the range of its resized keys") {
    GappedBars bars;
    bars.map.resizedFrom = 50;
    bars.map.resizedTo = 64;
    const auto some = bars.build();
    CHECK(some->key(49).slot < 0);
    CHECK(some->key(50).slot >= 0);
    CHECK(some->key(66).slot >= 0); // between its own keys
    CHECK(some->key(68).slot < 0);
    bars.map.resizedTo = 0;
    CHECK(bars.build()->key(59).slot < 0);
}

TEST_CASE("The lowest key needs an object of its own") {
    GappedBars bars;
    bars.map.lowestNote = 59;
    const auto built = Instrument::build(bars.map, bars.library);
    REQUIRE_FALSE(built);
    CHECK(built.error().message.find("no/such/folder/59.modal") != std::string::npos);
}

TEST_CASE("Muted modes are identified by the bar's note, also on keys that play it resized") {
    GappedBars bars;
    const auto instrument = bars.build();
    for (const auto& [note, own] : {std::pair{62, 62}, {61, 60}, {63, 62}, {80, 67}})
        CHECK(modeSetKey(*instrument, static_cast<std::size_t>(instrument->key(note).slot)) ==
              std::to_string(own));
}

TEST_CASE("Other keys stay silent if an object has too many modes for all of them") {
    ObjectLibrary library;
    const auto kept = library.add("crowd", syntheticObject(std::vector<double>(10'000, 440.0)));
    const KeyMap map{
        .kind = KeyMapKind::scaled, .lowestNote = 60, .highestNote = 72, .object = "crowd"};
    const auto instrument = Instrument::build(map, library).value();
    CHECK(instrument->slots().size() == 13);
    CHECK(instrument->key(59).slot < 0);
}

TEST_CASE("Keys along a path over one object have no resized keys beside them") {
    ObjectLibrary library;
    const auto kept = library.add("plate", syntheticObject({440}));
    const KeyMap map{
        .kind = KeyMapKind::zones, .lowestNote = 60, .highestNote = 72, .object = "plate"};
    const auto instrument = Instrument::build(map, library).value();
    CHECK(instrument->slots().size() == 1);
    CHECK(instrument->key(59).slot < 0);
}

TEST_CASE(
    "Keys 24 to 108 sound on every struck keyboard, and resized keys are as loud as its own") {
    for (const auto& preset : keyedFactoryPresets()) {
        const auto kind = preset.keyMap.kind;
        if ((kind != KeyMapKind::bars && kind != KeyMapKind::scaled) || !strikes(preset.parameters))
            continue;
        const auto levels = keyLevels(preset);
        const double loudest = *std::max_element(levels.begin() + lowestAsked, levels.end());
        for (int note = lowestAsked; note <= highestAsked; ++note) {
            const auto level = levels[static_cast<std::size_t>(note)];
            INFO(preset.name << ", note " << note << ": " << level << " dB");
            CHECK(level > loudest - 60);
            const bool isBelow = note < preset.keyMap.lowestNote;
            if (isBelow || note > preset.keyMap.highestNote) {
                const auto next = levels[static_cast<std::size_t>(isBelow ? note + 1 : note - 1)];
                CHECK(std::abs(level - next) < 8); // a contact may fall into the next dip
            }
        }
    }
}

TEST_CASE("Middle C sounds on the first preset") {
    const auto& first = factoryPresets().front();
    Player player(Instrument::build(first.keyMap, ObjectLibrary::shared()).value(), sampleRateHz);
    CHECK(peak(render(player, {midi(0, 0x90, 60, 100)}, 4800, 480, first.parameters)) > 1e-3f);
}
