// Tests kits: parts by key and velocity, layers, choke groups, and the parts' own materials and
// mallets.
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "SameInAllBlocks.h"
#include "Support/AllocationCounter.h"
#include "Support/Level.h"
#include "Support/Phasor.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

constexpr double sampleRateHz = 48000;
constexpr double lowHz = 300, highHz = 800;
constexpr int key = 60, otherKey = 62;

/// A part that plays one key with the object of that name.
KitPart partOn(int note, const std::string& object) {
    return {
        .keyMap = {
            .kind = KeyMapKind::zones, .lowestNote = note, .highestNote = note, .object = object}};
}

Result<std::shared_ptr<const Instrument>> built(const std::vector<KitPart>& parts) {
    ObjectLibrary library;
    const auto low = library.add("low", syntheticObject({lowHz}));
    const auto high = library.add("high", syntheticObject({highHz}));
    return Instrument::build(kitOf(parts), library);
}

ParameterValues exact() {
    return with({}, strikeSpread, 0);
}

std::vector<float> played(const std::vector<KitPart>& parts,
                          const std::vector<MidiEvent>& events,
                          const ParameterValues& values = exact(),
                          std::size_t samples = 9600) {
    Player player(built(parts).value(), sampleRateHz);
    return render(player, events, samples, 480, values);
}

double levelAt(std::span<const float> sound, double hz) {
    return std::abs(phasorAt(sound, hz, sampleRateHz));
}

std::size_t firstDifference(const std::vector<float>& a, const std::vector<float>& b) {
    return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

} // namespace

TEST_CASE("The velocity of a note chooses the part that it plays") {
    auto soft = partOn(key, "low"), hard = partOn(key, "high");
    soft.highestVelocity = 63;
    hard.lowestVelocity = 64;
    const std::vector parts{soft, hard};
    const auto softly = played(parts, {midi(0, 0x90, key, 63)});
    const auto hardly = played(parts, {midi(0, 0x90, key, 64)});
    CHECK(levelAt(softly, lowHz) > 100 * levelAt(softly, highHz));
    CHECK(levelAt(hardly, highHz) > 100 * levelAt(hardly, lowHz));
    hard.lowestVelocity = 100;
    CHECK(rms(played({soft, hard}, {midi(0, 0x90, key, 80)})) == 0);
    CHECK(rms(played(parts, {midi(0, 0x90, otherKey, 80)})) == 0);
}

TEST_CASE("Two layers sound together as each sounds alone, and both follow their key") {
    const auto low = partOn(key, "low");
    auto high = partOn(key, "high");
    high.levelDb = -6;
    const std::vector events{midi(0, 0x90, key, 90), midi(3000, 0x80, key, 0)};
    const auto values = with(exact(), letRing, 0);
    const auto both = played({low, high}, events, values);
    const auto one = played({low}, events, values), other = played({high}, events, values);
    for (std::size_t i = 0; i < both.size(); ++i)
        REQUIRE(std::abs(both[i] - one[i] - other[i]) < 1e-6f * peak(both));
    CHECK(peak(std::span(both).last(480)) < 0.1f * peak(both));

    high.levelDb = 0;
    const double fainterDb = 20 * std::log10(rms(other) / rms(played({high}, events, values)));
    CHECK(std::abs(fainterDb + 6) < 0.01);
}

TEST_CASE("A strike damps its choke group from the next cell on, but not its own note") {
    auto open = partOn(key, "low"), closed = partOn(otherKey, "high");
    const std::vector events{midi(0, 0x90, key, 100), midi(4800, 0x90, otherKey, 100)};
    const auto free = played({open, closed}, events);
    open.chokeGroup = closed.chokeGroup = 3;
    const auto choked = played({open, closed}, events);
    const auto begins = firstDifference(free, choked);
    CHECK(begins >= 4800);
    CHECK(begins < 4800 + 2 * cellSamples);
    const auto tail = [](const std::vector<float>& sound) { return std::span(sound).last(1920); };
    CHECK(levelAt(tail(choked), lowHz) < 0.01 * levelAt(tail(free), lowHz));
    CHECK(levelAt(tail(choked), highHz) > 0.99 * levelAt(tail(free), highHz));

    // A choked key that is struck again rings again.
    auto again = events;
    again.push_back(midi(5760, 0x90, key, 100));
    const auto rings = played({open, closed}, again);
    CHECK(levelAt(tail(rings), lowHz) > 0.5 * levelAt(tail(free), lowHz));

    closed.chokeGroup = 4;
    CHECK(played({open, closed}, events) == free);
    closed = partOn(key, "high");
    const std::vector note{midi(0, 0x90, key, 100)};
    const auto layers = played({open, closed}, note);
    closed.chokeGroup = 3;
    CHECK(played({open, closed}, note) == layers);
}

TEST_CASE("A part keeps its own material and mallet whatever the parameters are") {
    const std::vector note{midi(0, 0x90, key, 100)};
    const auto choice = [](ParameterId parameter, const char* name) {
        return static_cast<int>(parseParameter(parameterInfo(parameter), name).value());
    };
    const auto glass = choice(material, "Glass"), yarn = choice(mallet, "Yarn");
    auto values = with(exact(), keepPitch, 0);
    const auto chosen =
        played({partOn(key, "low")}, note, with(with(values, material, glass), mallet, yarn));
    auto part = partOn(key, "low");
    part.material = glass;
    part.mallet = yarn;
    CHECK(played({part}, note, values) == chosen);
    values.set(material, choice(material, "Brass"));
    values.set(mallet, choice(mallet, "Brass"));
    CHECK(played({part}, note, values) == chosen);
    CHECK_FALSE(played({partOn(key, "low")}, note, values) == chosen);
}

TEST_CASE("A key map within a kit plays as it does alone, beside the keys of other parts") {
    ObjectLibrary library;
    const auto object = library.add("object", syntheticObject({lowHz, 2.7 * lowHz}));
    const KeyMap scaled{
        .kind = KeyMapKind::scaled, .lowestNote = 50, .highestNote = 70, .object = "object"};
    const auto alone = Instrument::build(scaled, library).value();
    const auto kit =
        Instrument::build(kitOf({{.keyMap = scaled}, partOn(40, "object")}), library).value();
    CHECK(kit->keysOf(40).size() == 1);
    CHECK_FALSE(kit->followsKey(static_cast<std::size_t>(kit->key(40).slot)));
    CHECK(kit->followsKey(static_cast<std::size_t>(kit->key(39).slot)));
    CHECK_FALSE(kit->hasOwn(41));
    const std::vector events{midi(0, 0x90, 52, 90), midi(700, 0x90, 69, 90),
                             midi(900, 0x90, 41, 90)};
    Player one(alone, sampleRateHz), other(kit, sampleRateHz);
    CHECK(render(one, events, 9600, 480, exact()) == render(other, events, 9600, 480, exact()));
}

TEST_CASE("A kit of sixteen zones in two layers is equal in all blocks, and never allocates") {
    std::vector<KitPart> parts;
    for (int zone = 0; zone < 16; ++zone)
        for (const auto* object : {"low", "high"}) {
            parts.push_back(partOn(40 + zone, object));
            parts.back().chokeGroup = zone % 3;
        }
    std::vector<MidiEvent> events;
    for (int i = 0; i < 60; ++i)
        events.push_back(midi(i * 157, 0x90, 40 + i * 7 % 16, 1 + i * 11 % 127));
    const auto instrument = built(parts).value();
    checkSameInBlocksOf({1, 63, 1000}, instrument, sampleRateHz, events, 9600, {});

    Player player(instrument, sampleRateHz);
    StereoSound output(480);
    const AllocationCounter counter;
    for (int block = 0; block < 20; ++block)
        player.process(output, {events.data(), 40}, {});
    CHECK(counter.allocations() == 0);
}

TEST_CASE("A kit that cannot be played gets a sentence") {
    using Catch::Matchers::ContainsSubstring;
    const auto sentence = [](const std::vector<KitPart>& parts) {
        const auto result = built(parts);
        REQUIRE_FALSE(result);
        return result.error().message;
    };
    const auto part = partOn(key, "low");
    CHECK(sentence({part, part, part}) ==
          "the kit's parts are more than 2 on key 60 at velocity 1");
    auto scene = part;
    scene.keyMap.kind = KeyMapKind::scene;
    CHECK_THAT(sentence({scene}), ContainsSubstring("a scene or a kit among them"));
    CHECK_THAT(sentence({partOn(key, "nothing.modal")}), ContainsSubstring("nothing.modal"));
}
