#include "Instrument/HeldContacts.h"
#include "Instrument/Player.h"
#include "Support/Periodogram.h"
#include "Support/RenderNotes.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <random>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;
constexpr int speedController = 1, placeController = 74;

/// A steel plate; keys 36 to 96 lie on a way over it that begins in a corner.
std::shared_ptr<const Instrument> plate() {
    return Instrument::build({.kind = KeyMapKind::zones,
                              .lowestNote = 36,
                              .highestNote = 96,
                              .object = "plate",
                              .strikePath = {{-1, -1, 0}, {0.3, 0.8, 0}}},
                             ObjectLibrary::shared())
        .value();
}

/// Keys 40 to 80, objects of their own, which ring for some ten milliseconds only.
std::shared_ptr<const Instrument> shortBars() {
    ObjectLibrary library;
    auto object = syntheticObject({300, 810, 1600, 2700});
    object.material.fluidDampingPerSecond = 1000;
    const auto kept = library.add("bar", std::move(object));
    KeyMap map;
    map.kind = KeyMapKind::scaled;
    map.lowestNote = 40;
    map.highestNote = 80;
    map.object = "bar";
    return Instrument::build(map, library).value();
}

/// One key at the left end of a square's middle; only its right half sounds.
std::shared_ptr<const Instrument> halfDeafSquare(float sideMetres) {
    ObjectLibrary library;
    auto object = syntheticObject({500});
    for (float& coordinate : object.vertices)
        coordinate *= sideMetres;
    for (const std::size_t row : {0u, 3u})
        object.shapes[row * 3 + 2] = 0;
    const auto kept = library.add("square", std::move(object));
    KeyMap map;
    map.kind = KeyMapKind::zones;
    map.lowestNote = 60;
    map.highestNote = 61;
    map.object = "square";
    return Instrument::build(map, library).value();
}

/// Modes that lie far apart, and ring for some half a second.
constexpr double barHz[] = {400, 1100, 2150};

std::shared_ptr<const Instrument> oneBar() {
    ObjectLibrary library;
    auto object = syntheticObject({std::begin(barHz), std::end(barHz)});
    object.material.fluidDampingPerSecond = 20;
    object.material.viscoelasticDampingSeconds = 0;
    const auto kept = library.add("bar", std::move(object));
    KeyMap map;
    map.kind = KeyMapKind::zones;
    map.lowestNote = 60;
    map.highestNote = 61;
    map.object = "bar";
    return Instrument::build(map, library).value();
}

ParameterValues scraping(double choice = scrapeContact) {
    ParameterValues parameters;
    parameters.set(ParameterId::contact, choice);
    parameters.set(ParameterId::tau, 0.001);
    return parameters;
}

std::vector<float> play(const std::shared_ptr<const Instrument>& instrument,
                        const std::vector<MidiEvent>& events,
                        std::size_t samples,
                        const ParameterValues& parameters = scraping()) {
    Player player(instrument, sampleRateHz);
    return render(player, events, samples, 480, parameters);
}

double level(std::span<const float> signal) {
    double sum = 0;
    for (const float sample : signal)
        sum += static_cast<double>(sample) * sample;
    return std::sqrt(sum / static_cast<double>(signal.size()));
}

/// Keys held, let go, pressed and moved, more of them at a time than there are contacts.
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

TEST_CASE("A held key sounds for as long as it is held, and the object rings out after") {
    const double kind = GENERATE(scrapeContact, rollContact);
    const std::vector events{midi(100, 0x90, 60, 100), midi(48000, 0x80, 60, 0)};
    const auto sound = play(plate(), events, 96000, scraping(kind));
    const auto during = [&](std::size_t from) {
        return level(std::span(sound).subspan(from, 9600));
    };
    CHECK(peak(std::span(sound).first(100)) == 0);
    CHECK(during(14400) > 1e-5);
    CHECK(during(38400) > 0.25 * during(14400));
    CHECK(during(48500) > 0.1 * during(38400));
    CHECK(during(86400) < 0.5 * during(38400));
}

TEST_CASE("The force is gone 10 ms after the key, and silence follows") {
    const auto instrument = shortBars();
    for (const int release : {9600, 9601, 9663}) {
        Player player(instrument, sampleRateHz);
        const auto sound = render(player, {midi(0, 0x90, 60, 127), midi(release, 0x80, 60, 0)},
                                  19200, 64, scraping());
        const auto free = std::span(sound).subspan(static_cast<std::size_t>(release) + 480);
        const auto held = level(std::span(sound).subspan(4800, 4800));
        CHECK(held > 1e-5);
        // The modes fall by 1 dB in 0.23 ms: by 60 dB within 14 ms.
        CHECK(level(free.subspan(14 * 48, 96)) < 2e-3 * held);
        CHECK(player.silent());
    }
}

TEST_CASE("What is heard follows the root of the pressure, and its roughness") {
    const auto instrument = plate();
    const auto loudness = [&](int pressure, double rough = 1) {
        auto parameters = scraping();
        parameters.set(ParameterId::roughness, rough);
        return level(play(instrument, {midi(0, 0x90, 60, 90), midi(0, 0xa0, 60, pressure)}, 48000,
                          parameters));
    };
    const double full = loudness(127);
    for (const int pressure : {8, 32, 64})
        CHECK(full / loudness(pressure) == Approx(std::sqrt(127.0 / pressure)).epsilon(0.02));
    CHECK(loudness(127, 3) == Approx(3 * full).epsilon(0.02));
    CHECK(loudness(0) == 0);
}

TEST_CASE("Until pressure comes the velocity stands for it; both kinds of pressure do the same") {
    const auto instrument = plate();
    const auto byVelocity = play(instrument, {midi(0, 0x90, 60, 50)}, 9600);
    CHECK(peak(byVelocity) > 0);
    CHECK(play(instrument, {midi(0, 0x90, 60, 120), midi(0, 0xa0, 60, 50)}, 9600) == byVelocity);
    CHECK(play(instrument, {midi(0, 0x90, 60, 120), midi(0, 0xd0, 50, 0)}, 9600) == byVelocity);
    CHECK(play(instrument, {midi(0, 0x90, 60, 50), midi(0, 0xa0, 61, 127)}, 9600) == byVelocity);
}

TEST_CASE("The faster a scrape, the louder and brighter, and at no speed it is silent") {
    const auto instrument = plate();
    double lastCentroidHz = 0, lastLevel = 0;
    for (const int wheel : {20, 40, 64, 90, 127}) {
        const auto sound = play(
            instrument, {midi(0, 0xb0, speedController, wheel), midi(0, 0x90, 60, 100)}, 96000);
        const double centroidHz = Periodogram(sound, sampleRateHz).centroidHz();
        INFO("CC1 " << wheel << ": " << centroidHz << " Hz, level " << level(sound));
        CHECK(centroidHz > lastCentroidHz);
        CHECK(level(sound) > lastLevel);
        lastCentroidHz = centroidHz;
        lastLevel = level(sound);
    }
    CHECK(peak(play(instrument, {midi(0, 0xb0, speedController, 0), midi(0, 0x90, 60, 100)},
                    4800)) == 0);
    CHECK(play(instrument, {midi(0, 0x90, 60, 100)}, 4800) ==
          play(instrument, {midi(0, 0xb0, speedController, 64), midi(0, 0x90, 60, 100)}, 4800));
}

TEST_CASE("A roll is darker than a scrape") {
    const auto instrument = plate();
    const auto centroidHz = [&](double kind) {
        const auto sound = play(instrument, {midi(0, 0x90, 60, 100)}, 96000, scraping(kind));
        return Periodogram(sound, sampleRateHz).centroidHz();
    };
    CHECK(centroidHz(rollContact) < 0.8 * centroidHz(scrapeContact));
}

TEST_CASE(
    "A coupled roll sounds at the modes as a scrape does, and as dark as any roll between them") {
    const auto instrument = oneBar();
    const auto spectrum = [&](double kind, double coupling) {
        auto parameters = scraping(kind);
        parameters.set(ParameterId::rollCoupling, coupling);
        auto sound = play(instrument, {midi(0, 0x90, 60, 100)}, 480000, parameters);
        sound.erase(sound.begin(), sound.begin() + 96000);
        return Periodogram(sound, sampleRateHz);
    };
    const auto decibels = [](const Periodogram& a, const Periodogram& b, double hz) {
        return 10 * std::log10(a.power(hz - 2, hz + 2) / b.power(hz - 2, hz + 2));
    };
    const auto scrape = spectrum(scrapeContact, 0), uncoupled = spectrum(rollContact, 0);
    std::array<double, std::size(barHz)> lastOver{};
    for (const double coupling : {10.0, 30.0, 100.0}) {
        const auto roll = spectrum(rollContact, coupling);
        for (std::size_t mode = 0; mode < std::size(barHz); ++mode) {
            const double below = mode == 0 ? 200 : (barHz[mode - 1] + barHz[mode]) / 2;
            const double between = decibels(roll, uncoupled, below);
            const double over = decibels(roll, uncoupled, barHz[mode]) - between;
            INFO(barHz[mode] << " Hz coupled by " << coupling << " %: over " << below << " Hz "
                             << over << " dB, there " << between << " dB");
            CHECK(std::abs(between) < 1);
            CHECK(over > lastOver[mode] + 3);
            lastOver[mode] = over;
        }
    }
    const auto full = spectrum(rollContact, 100);
    for (const double hz : barHz)
        CHECK(std::abs(decibels(full, scrape, hz)) < 2);
}

TEST_CASE("Roll coupling changes no strike and no scrape") {
    const auto instrument = plate();
    const auto sound = [&](double kind, double coupling) {
        auto parameters = scraping(kind);
        parameters.set(ParameterId::rollCoupling, coupling);
        return play(instrument, {midi(0, 0x90, 60, 100), midi(9600, 0x80, 60, 0)}, 19200,
                    parameters);
    };
    CHECK(sound(strikeContact, 100) == sound(strikeContact, 0));
    CHECK(sound(scrapeContact, 100) == sound(scrapeContact, 0));
    CHECK(sound(rollContact, 100) != sound(rollContact, 0));
}

TEST_CASE("A coupled roll's modes follow a bend while it is held") {
    const auto instrument = oneBar();
    auto parameters = scraping(rollContact);
    parameters.set(ParameterId::rollCoupling, 100);
    parameters.set(ParameterId::bendRange, 12);
    const MidiEvent key = midi(0, 0x90, 60, 100);
    auto before = play(instrument, {midi(0, 0xe0, 127, 127), key}, 192000, parameters);
    auto meanwhile = play(instrument, {key, midi(4800, 0xe0, 127, 127)}, 192000, parameters);
    for (auto* sound : {&before, &meanwhile})
        sound->erase(sound->begin(), sound->begin() + 96000);
    const Periodogram expected(before, sampleRateHz), bent(meanwhile, sampleRateHz);
    for (const double hz : barHz)
        CHECK(std::abs(10 * std::log10(bent.power(2 * hz - 3, 2 * hz + 3) /
                                       expected.power(2 * hz - 3, 2 * hz + 3))) < 0.5);
}

TEST_CASE("CC74 reaches from one end of the strip to the other, the key's own place at 64") {
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

TEST_CASE("A contact moved while it is held ends where CC74 says, and moves the spectrum") {
    const auto instrument = plate();
    const auto spectrum = [&](const std::vector<MidiEvent>& events) {
        auto sound = play(instrument, events, 144000);
        sound.erase(sound.begin(), sound.begin() + 48000);
        const Periodogram power(sound, sampleRateHz);
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

TEST_CASE("A contact follows CC74 at 5 m/s, and where that takes no time, within 20 ms") {
    const auto samplesToTheMiddle = [](float sideMetres) {
        const auto sound =
            play(halfDeafSquare(sideMetres),
                 {midi(0, 0x90, 60, 100), midi(4800, 0xb0, placeController, 127)}, 19200);
        const auto first = std::ranges::find_if(sound, [](float x) { return x != 0; });
        return static_cast<double>(first - sound.begin()) - 4800;
    };
    CHECK(samplesToTheMiddle(1) == Approx(0.1 * sampleRateHz).margin(2 * cellSamples));
    const double small = samplesToTheMiddle(0.01f);
    CHECK(small > 0.002 * sampleRateHz);
    CHECK(small < 0.01 * sampleRateHz);
}

TEST_CASE("Held contacts are bit-identical for block sizes 1, 7, 64, 480 and 4096") {
    auto parameters = scraping(GENERATE(scrapeContact, rollContact));
    parameters.set(ParameterId::radiation, 50);
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::rollCoupling, 60);
    const auto instrument = GENERATE(plate(), shortBars());
    const auto events = busyHands(12000);
    Player reference(instrument, sampleRateHz);
    const auto expected = renderStereo(reference, events, 12000, 512, parameters);
    CHECK(peak(expected.left) > 1e-5f);
    for (const std::size_t blockSize : {1, 7, 64, 480, 4096}) {
        Player player(instrument, sampleRateHz);
        CHECK(renderStereo(player, events, 12000, blockSize, parameters) == expected);
        player.reset();
        CHECK(player.silent());
        CHECK(renderStereo(player, events, 12000, blockSize, parameters) == expected);
    }
}

TEST_CASE("Another seed is another sound of the same loudness, another surface is not") {
    const auto instrument = plate();
    const std::vector events{midi(0, 0x90, 60, 100)};
    const auto sound = [&](const Surface& surface, std::uint64_t seed) {
        Player player(instrument, sampleRateHz, surface, seed);
        return render(player, events, 96000, 480, scraping());
    };
    const auto first = sound({}, 1), second = sound({}, 2);
    CHECK(sound({}, 1) == first);
    CHECK(second != first);
    CHECK(std::abs(20 * std::log10(level(second) / level(first))) < 2);
    Surface rough;
    rough.roughness = 5;
    CHECK(level(sound(rough, 1)) == Approx(10 * level(first)).epsilon(0.02));
}

TEST_CASE("Of one key more than there are contacts the oldest gives way") {
    std::vector<MidiEvent> events;
    for (int i = 0; i <= static_cast<int>(HeldContacts::capacity); ++i)
        events.push_back(midi(100 * i, 0x90, 40 + i, 100));
    Player player(shortBars(), sampleRateHz);
    render(player, events, 19200, 480, scraping());
    const auto status = player.synthesiser().status();
    CHECK(status[0].amplitude == 0);
    for (std::size_t slot = 1; slot <= HeldContacts::capacity; ++slot)
        CHECK(status[slot].amplitude > 0);
}

TEST_CASE("All sound off, all notes off and the choice of strikes end a held contact") {
    const auto instrument = shortBars();
    const auto silentAfter = [&](const MidiEvent& event, const ParameterValues& then) {
        Player player(instrument, sampleRateHz);
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

TEST_CASE("Reset controllers brings speed and place back to rest") {
    const auto instrument = plate();
    const auto moved =
        play(instrument,
             {midi(0, 0xb0, speedController, 100), midi(0, 0xb0, placeController, 10),
              midi(0, 0xb0, 121, 0), midi(0, 0x90, 60, 100)},
             9600);
    CHECK(moved == play(instrument, {midi(0, 0x90, 60, 100)}, 9600));
}
