// Tests how rolls differ from scrapes, and how coupling to the modes changes them.
#include "HeldKeys.h"
#include "Support/Periodogram.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <iterator>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// Modes that lie far apart and ring for about half a second.
constexpr double barHz[] = {400, 1100, 2150};

std::shared_ptr<const Instrument> oneBar() {
    auto object = syntheticObject({std::begin(barHz), std::end(barHz)});
    object.material.damping.fluidPerSecond = 20;
    object.material.damping.viscoelasticSeconds = 0;
    return keysOn(std::move(object), KeyMapKind::zones, 60, 61);
}

} // namespace

TEST_CASE("A roll is darker than a scrape") {
    const auto instrument = plate();
    const auto centroidHz = [&](double kind) {
        const auto sound = play(instrument, {midi(0, 0x90, 60, 100)}, 96000, scraping(kind));
        return Periodogram(sound, playRateHz).centroidHz();
    };
    CHECK(centroidHz(rollContact) < 0.8 * centroidHz(scrapeContact));
}

TEST_CASE(
    "A coupled roll is as loud as a scrape at the modes and as dark as any roll between them") {
    const auto instrument = oneBar();
    const auto spectrum = [&](double kind, double coupling) {
        auto parameters = scraping(kind);
        parameters.set(ParameterId::rollCoupling, coupling);
        auto sound = play(instrument, {midi(0, 0x90, 60, 100)}, 480000, parameters);
        sound.erase(sound.begin(), sound.begin() + 96000);
        return Periodogram(sound, playRateHz);
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

TEST_CASE("Roll coupling changes neither strikes nor scrapes") {
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

TEST_CASE("The modes of a held coupled roll follow a bend") {
    const auto instrument = oneBar();
    auto parameters = scraping(rollContact);
    parameters.set(ParameterId::rollCoupling, 100);
    parameters.set(ParameterId::bendRange, 12);
    const MidiEvent key = midi(0, 0x90, 60, 100);
    auto before = play(instrument, {midi(0, 0xe0, 127, 127), key}, 192000, parameters);
    auto meanwhile = play(instrument, {key, midi(4800, 0xe0, 127, 127)}, 192000, parameters);
    for (auto* sound : {&before, &meanwhile})
        sound->erase(sound->begin(), sound->begin() + 96000);
    const Periodogram expected(before, playRateHz), bent(meanwhile, playRateHz);
    for (const double hz : barHz)
        CHECK(std::abs(10 * std::log10(bent.power(2 * hz - 3, 2 * hz + 3) /
                                       expected.power(2 * hz - 3, 2 * hz + 3))) < 0.5);
}
