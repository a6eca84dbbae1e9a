// Tests keys that bow: when they speak, at which pitch, how loud, and how they end.
#include "HeldKeys.h"
#include "Instrument/ObjectLibrary.h"
#include "Support/Highs.h"
#include "Support/KeyedPresets.h"
#include "Support/Level.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double barHz = 400;

/// Keys 60 and 61 on one bar of 0.4 kg, which rings for two seconds.
std::shared_ptr<const Instrument> bar() {
    auto object = syntheticObject({barHz, 1100, 2150}, {3, 3, 3});
    object.material.damping = {.fluidPerSecond = 7};
    return keysOn(std::move(object), KeyMapKind::zones, 60, 61);
}

/// A bow whose fastest speed is given in m/s.
ParameterValues bowing(double force = 5, double speed = 0.4) {
    auto parameters = scraping(bowContact);
    parameters.set(ParameterId::contactForce, force);
    parameters.set(ParameterId::contactSpeed, 5 * speed);
    return parameters;
}

/// Returns the amplitude of the sound near a frequency.
std::complex<double> component(std::span<const float> sound, double hz) {
    std::complex<double> sum;
    const auto length = static_cast<double>(sound.size());
    for (std::size_t n = 0; n < sound.size(); ++n) {
        const double phase = 2 * std::numbers::pi * static_cast<double>(n);
        sum += static_cast<double>(sound[n]) * (1 - std::cos(phase / length)) *
               std::polar(1.0, -phase * hz / playRateHz);
    }
    return 2.0 * sum / length;
}

/// Returns by how many cents the tone near `hz` is higher at the end, from its phase in two parts
/// of 16 periods; within 50 cents.
double centsAbove(std::span<const float> sound, double hz) {
    const auto part = static_cast<std::size_t>(16 * playRateHz / hz);
    const auto first = component(sound.last(2 * part).first(part), hz);
    const auto second = component(sound.last(part), hz);
    const double seconds = static_cast<double>(part) / playRateHz;
    const double turned =
        std::arg(second / first * std::polar(1.0, -2 * std::numbers::pi * hz * seconds));
    return 1200 * std::log2(1 + turned / (2 * std::numbers::pi * seconds * hz));
}

} // namespace

TEST_CASE("A bowed key speaks, moves its place at the bow's speed, and rings after the release") {
    const auto sound =
        play(bar(), {midi(0, 0x90, 60, 100), midi(72000, 0x80, 60, 0)}, 144000, bowing());
    const auto held = std::span(sound).subspan(52800, 19200);
    // Half the speed of the full wheel.
    CHECK(std::abs(component(held, barHz)) == Approx(0.22).epsilon(0.15));
    CHECK(std::abs(component(held, barHz)) > 4 * std::abs(component(held, 1100)));
    const auto after = [&](std::size_t from) { return rms(std::span(sound).subspan(from, 4800)); };
    CHECK(after(76800) > 0.3 * after(67200));
    CHECK(after(139200) < 0.02 * after(76800));
}

TEST_CASE("A bowed key does not speak below its minimum force, which grows with the speed") {
    const auto instrument = bar();
    const auto amplitude = [&](double force, double speed) {
        const auto sound = play(instrument, {midi(0, 0x90, 60, 127)}, 96000, bowing(force, speed));
        return std::abs(component(std::span(sound).last(9600), barHz)) / (speed / 2);
    };
    CHECK(amplitude(0.1, 0.2) < 0.1);
    CHECK(amplitude(3, 0.2) > 0.9);
    CHECK(amplitude(3, 2) < 0.1);
    CHECK(amplitude(40, 2) > 0.9);
}

TEST_CASE("The pitch of a light bow is that of the free mode, and follows a bend") {
    const auto instrument = bar();
    auto parameters = bowing(3, 0.2);
    parameters.set(ParameterId::bendRange, 12);
    const auto held = play(instrument, {midi(0, 0x90, 60, 100)}, 96000, parameters);
    CHECK(std::abs(centsAbove(held, barHz)) < 10);
    const auto bent =
        play(instrument, {midi(0, 0x90, 60, 100), midi(24000, 0xe0, 127, 127)}, 192000, parameters);
    CHECK(std::abs(component(std::span(bent).last(24000), 2 * barHz)) > 0.05);
    CHECK(std::abs(centsAbove(bent, 2 * barHz)) < 12);
}

TEST_CASE("A bow moves along the surface's normal, and a rub along the path") {
    auto object = syntheticObject({barHz, 900}, {3, 3});
    object.material.damping = {.fluidPerSecond = 7};
    // The first mode moves mostly along x, as the path does.
    for (std::size_t row = 0; row < 4; ++row) {
        object.shapes[6 * row] = 3;
        object.shapes[6 * row + 2] = 0.3f;
    }
    ObjectLibrary library;
    const auto kept = library.add("object", std::move(object));
    const auto instrument = Instrument::build({.kind = KeyMapKind::zones,
                                               .lowestNote = 60,
                                               .highestNote = 61,
                                               .object = "object",
                                               .strikePath = {{-1, 0, 0}, {1, 0, 0}}},
                                              library)
                                .value();
    const auto sound = [&](double tool) {
        auto parameters = bowing();
        parameters.set(ParameterId::contact, tool);
        return play(instrument, {midi(0, 0x90, 60, 100)}, 72000, parameters);
    };
    const auto amplitude = [](const std::vector<float>& played, double hz) {
        return std::abs(component(std::span(played).last(9600), hz));
    };
    const auto bowed = sound(bowContact), rubbed = sound(rubContact);
    CHECK(amplitude(bowed, 900) == Approx(0.22).epsilon(0.15));
    CHECK(amplitude(bowed, barHz) < 0.01);
    CHECK(amplitude(rubbed, barHz) == Approx(0.022).epsilon(0.15));
    CHECK(amplitude(rubbed, 900) < 1e-4);
}

TEST_CASE("A bow at rest, and a key without pressure, are silent") {
    const auto instrument = bar();
    CHECK(peak(play(instrument, {midi(0, 0xb0, speedController, 0), midi(0, 0x90, 60, 100)}, 9600,
                    bowing())) == 0);
    CHECK(peak(play(instrument, {midi(0, 0x90, 60, 100), midi(0, 0xa0, 60, 0)}, 9600, bowing())) ==
          0);
}

TEST_CASE("A voicing changes the loudness of a bowed key and nothing else") {
    KeyMap map{.kind = KeyMapKind::zones, .lowestNote = 60, .highestNote = 61, .object = "object"};
    const auto sound = [&](std::vector<double> voicingDb) {
        ObjectLibrary library;
        const auto kept = library.add("object", syntheticObject({barHz, 1100}, {3, 3}));
        map.voicingDb = std::move(voicingDb);
        return play(Instrument::build(map, library).value(), {midi(0, 0x90, 60, 100)}, 24000,
                    bowing());
    };
    const auto plain = sound({0, 0}), voiced = sound({20, 0});
    for (std::size_t n = 0; n < plain.size(); n += 100)
        REQUIRE(voiced[n] == Approx(10 * plain[n]).margin(1e-4));
}

TEST_CASE("A held key changes between bow and scrape without a click") {
    const auto instrument = plate();
    const auto highsDb = [&](double before, double after,
                             const std::vector<MidiEvent>& events = {}) {
        Player player(instrument, playRateHz);
        auto parameters = bowing(20);
        parameters.set(ParameterId::contact, before);
        render(player, {midi(0, 0x90, 60, 127)}, 24000, 480, parameters);
        parameters.set(ParameterId::contact, after);
        const auto sound = render(player, events, 1600, 480, parameters);
        CHECK_FALSE(player.silent());
        return loudestHighsDb(sound, playRateHz);
    };
    const double releasedDb = std::max(highsDb(bowContact, bowContact, {midi(0, 0x80, 60, 0)}),
                                       highsDb(scrapeContact, scrapeContact));
    INFO("released " << releasedDb << " dB above 8 kHz");
    CHECK(highsDb(bowContact, scrapeContact) < releasedDb + 3);
    CHECK(highsDb(scrapeContact, bowContact) < releasedDb + 3);
}

TEST_CASE("Low, middle and high keys of bowed presets speak within a second, at the key's pitch") {
    for (const auto& preset : keyedFactoryPresets()) {
        if (!bows(preset.parameters) || preset.keyMap.kind == KeyMapKind::zones)
            continue;
        const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
        const auto& map = preset.keyMap;
        for (const int note :
             {map.lowestNote, (map.lowestNote + map.highestNote) / 2, map.highestNote}) {
            auto parameters = preset.parameters;
            parameters.set(ParameterId::motorDepth, 0);
            parameters.set(ParameterId::imperfection, 0);
            const auto sound = [&](int velocity) {
                Player player(instrument, playRateHz, preset.surface, preset.seed);
                return render(player, {midi(0, 0x90, note, velocity)}, 67200, 960, parameters);
            };
            const auto medium = sound(80), light = sound(30);
            const double hz = 440 * std::exp2((note - 69) / 12.0);
            INFO(preset.name << ", note " << note << ": " << centsAbove(light, hz) << " cents");
            CHECK(rms(std::span(medium).subspan(43200, 4800)) >
                  0.5 * rms(std::span(medium).last(4800)));
            CHECK(rms(std::span(medium).first(480)) < 0.3 * rms(std::span(medium).last(4800)));
            CHECK(std::abs(centsAbove(light, hz)) < 10);
        }
    }
}
