// Tests sound that comes in and presses on an object.
#include "Instrument/InputForce.h"
#include "Instrument/InputStrengths.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "Instrument/SettingsOfParameters.h"
#include "IntegratedLufs.h"
#include "Support/KeyedPresets.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double rateHz = 48000;

ParameterValues open() {
    ParameterValues values;
    values.set(ParameterId::inputLowCut, parameterInfo(ParameterId::inputLowCut).minimum);
    values.set(ParameterId::strikeSpread, 0);
    values.set(ParameterId::tau, 0.001);
    return values;
}

std::vector<float> noise(std::size_t samples, float loudness = 0.1f) {
    std::mt19937 random(9);
    std::vector<float> result(samples);
    for (float& sample : result)
        sample = loudness * (static_cast<float>(random()) / 2147483648.0f - 1);
    return result;
}

std::vector<float> impulse(std::size_t samples, std::size_t at) {
    std::vector<float> result(samples);
    result[at] = 1;
    return result;
}

/// Returns which keys of `bars` sound, from their slots' amplitudes.
std::vector<std::size_t> soundingSlots(const Player& player) {
    std::vector<std::size_t> slots;
    const auto status = player.synthesiser().status();
    for (std::size_t slot = 0; slot < status.size(); ++slot)
        if (status[slot].amplitude > 0)
            slots.push_back(slot);
    return slots;
}

} // namespace

TEST_CASE("An impulse in sounds as a strike by an impulse does, within -100 dB") {
    const std::size_t at = GENERATE(0, 1, 100, 640);
    const auto values = open();
    const auto instrument = bars();
    Player player(instrument, rateHz, {}, 1, values);
    constexpr std::size_t samples = 9600;
    const auto sound = renderStereo(player, {}, samples, 100, values, impulse(samples, at));

    const Key& key = instrument->key(60);
    const auto slot = static_cast<std::size_t>(key.slot);
    const auto point = key.strip->between(key.along, 0).point;
    auto strike = malletStrike(point, 127, key.mallet, values, instrument->slots()[slot]);
    strike.durationSeconds = 0;
    const double newtons = inputStrengths({instrument, {}, rateHz}, values)[60];
    for (std::size_t axis = 0; axis < 3; ++axis)
        strike.impulseNewtonSeconds[axis] =
            static_cast<float>(-newtons / rateHz * static_cast<double>(point.normal[axis]));
    Synthesiser synthesiser({instrument->slots().begin(), instrument->slots().end()}, rateHz, 2);
    synthesiser.setSettings(synthesisSettings(values));
    float difference = 0;
    for (std::size_t start = 0; start < samples; start += cellSamples) {
        std::array<float, cellSamples> left{}, right{};
        const CellOutput cell(left, right);
        synthesiser.beginCell(cell);
        if (at >= start && at < start + cellSamples)
            REQUIRE(synthesiser.strike(slot, strike, static_cast<double>(at - start), cell));
        for (std::size_t k = 0; k < cellSamples; ++k)
            difference = std::max(difference, std::abs(left[k] - sound.left[start + k]));
    }
    CHECK(peak(sound.left) > 0);
    CHECK(difference < 1e-5f * peak(sound.left));
    CHECK(std::ranges::all_of(std::span(sound.left).first(at), [](float x) { return x == 0; }));
}

TEST_CASE("Noise comes out of every factory preset about as loud as it goes in") {
    constexpr std::size_t samples = 48000;
    const auto input = noise(samples);
    std::map<double, std::string> gainsDb;
    for (const auto& preset : keyedFactoryPresets()) {
        const auto instrument = Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
        Player player(instrument, rateHz, preset.surface, preset.seed, preset.parameters);
        const auto sound = renderStereo(player, {}, samples, 512, preset.parameters, input);
        const double powers = std::pow(10, integratedLufs(sound.left, 1, rateHz) / 10) +
                              std::pow(10, integratedLufs(sound.right, 1, rateHz) / 10);
        gainsDb[10 * std::log10(powers / 2) + preset.parameters[ParameterId::level] -
                integratedLufs(input, 1, rateHz)] = preset.name;
    }
    CAPTURE(gainsDb.begin()->second, gainsDb.rbegin()->second);
    CHECK(gainsDb.begin()->first > -8);
    CHECK(gainsDb.rbegin()->first < 8);
}

TEST_CASE("Input, notes and the strike position sound the same in blocks of any size") {
    auto values = open();
    values.set(ParameterId::inputLowCut, 200);
    values.set(ParameterId::radiation, 50);
    values.set(ParameterId::motorDepth, 60);
    constexpr std::size_t samples = 24000;
    auto input = noise(samples);
    std::fill(input.begin() + 3000, input.begin() + 9001, 0.0f);
    const std::vector<MidiEvent> events{midi(77, 0x90, 69, 100),   midi(1111, 0xe0, 0, 80),
                                        midi(2500, 0x90, 62, 40),  midi(9100, 0x90, 62, 127),
                                        midi(15000, 0xb0, 120, 0), midi(20011, 0x90, 71, 90)};
    const auto instrument = bars();
    Player reference(instrument, rateHz);
    const auto expected = renderStereo(reference, events, samples, 512, values, input);
    CHECK(peak(std::span(expected.left).last(1000)) > 0);
    for (const std::size_t block : {1, 32, 64, 100, 4096}) {
        INFO("blocks of " << block);
        Player player(instrument, rateHz);
        CHECK(renderStereo(player, events, samples, block, values, input) == expected);
    }
}

TEST_CASE("Silence in is silence out, and the object rings out after the input") {
    const auto values = ParameterValues();
    Player player(bars(), rateHz);
    const std::vector<float> silence(9600);
    CHECK(peak(renderStereo(player, {}, 9600, 256, values, silence).left) == 0);
    CHECK(player.silent());
    renderStereo(player, {}, 9600, 256, values, noise(9600));
    CHECK_FALSE(player.silent());
    const auto after = renderStereo(player, {}, 9600, 256, values, silence);
    CHECK(peak(std::span(after.left).first(1000)) > 0);
    for (int second = 0; second < 60 && !player.silent(); ++second)
        renderStereo(player, {}, 48000, 256, values, std::vector<float>(48000));
    CHECK(player.silent());
}

TEST_CASE("The key near middle C resonates until another is played or clicked") {
    const auto instrument = keysOn(syntheticObject({300, 710}), KeyMapKind::scaled, 50, 72);
    const auto slotOf = [&](int note) {
        return std::vector{static_cast<std::size_t>(instrument->key(note).slot)};
    };
    Player player(instrument, rateHz);
    auto values = ParameterValues();
    values.set(ParameterId::decay, 0.05);
    const auto press = [&](const std::vector<MidiEvent>& events) {
        renderStereo(player, events, 48000, 256, values, noise(48000));
        return soundingSlots(player);
    };
    CHECK(press({}) == slotOf(60));
    CHECK(press({midi(0, 0x90, 71, 100), midi(100, 0x80, 71, 0)}) == slotOf(71));
    CHECK(press({midi(0, 0x90, 20, 100)}) == slotOf(71)); // has no object
    player.strikeSurface({.slot = slotOf(55).front(), .point = {}, .velocity = 0});
    CHECK(press({}) == slotOf(55));
}

TEST_CASE("The damper is up while the input presses") {
    auto values = open();
    values.set(ParameterId::letRing, 0);
    values.set(ParameterId::releaseTime, 0.005);
    const auto loudness = [&](double rings) {
        values.set(ParameterId::letRing, rings);
        Player player(bars(), rateHz);
        const auto sound = renderStereo(player, {}, 48000, 256, values, noise(48000)).left;
        return rms(std::span(sound).last(24000));
    };
    CHECK(std::abs(loudness(0) / loudness(1) - 1) < 0.02);
}

TEST_CASE("Drive scales the sound, and the low cut takes low sounds out") {
    auto values = open();
    const auto loudness = [&](const std::vector<float>& input) {
        Player player(bars(), rateHz);
        return rms(renderStereo(player, {}, input.size(), 256, values, input).left);
    };
    const auto hiss = noise(24000);
    const double before = loudness(hiss);
    values.set(ParameterId::inputDrive, 20);
    CHECK(std::abs(loudness(hiss) / before - 10) < 0.01);

    std::vector<float> hum(24000);
    for (std::size_t n = 0; n < hum.size(); ++n) {
        const double turns = static_cast<double>(n) / 48000 * 2 * std::numbers::pi;
        hum[n] = static_cast<float>(std::sin(50 * turns) * (1 - std::cos(2 * turns)));
    }
    const double humming = loudness(hum);
    values.set(ParameterId::inputLowCut, 500);
    CHECK(loudness(hum) < humming / 50);
}

TEST_CASE("Drive and low cut move without a step") {
    const auto moved = GENERATE(ParameterId::inputDrive, ParameterId::inputLowCut);
    const auto differences = [&] {
        auto values = open();
        Player still(bars(), rateHz), moving(bars(), rateHz);
        const auto input = noise(9600);
        renderStereo(still, {}, 9600, 64, values, input);
        renderStereo(moving, {}, 9600, 64, values, input);
        const auto expected = renderStereo(still, {}, 9600, 64, values, input).left;
        values.set(moved, moved == ParameterId::inputDrive ? 20 : 1000);
        auto sound = renderStereo(moving, {}, 9600, 64, values, input).left;
        for (std::size_t k = 0; k < sound.size(); ++k)
            sound[k] -= expected[k];
        return sound;
    }();
    CHECK(rms(std::span(differences).first(16)) < 0.1 * rms(std::span(differences).last(4800)));
    CHECK(rms(std::span(differences).last(4800)) > 0);
}

TEST_CASE("After All Sound Off the input sounds on, and what rang before is gone") {
    const auto values = open();
    Player player(bars(), rateHz);
    auto input = noise(48000);
    std::fill(input.begin() + 24000, input.end(), 0.0f);
    std::fill_n(input.begin() + 36000, 100, 0.5f);
    const auto sound =
        renderStereo(player, {midi(30000, 0xb0, 120, 0)}, 48000, 256, values, input).left;
    const auto part = [&](std::size_t from) { return rms(std::span(sound).subspan(from, 1000)); };
    CHECK(part(29000) > 0);
    CHECK(part(34000) < 1e-3 * part(29000));
    CHECK(part(37000) > 0.01 * part(29000));
}

TEST_CASE("Input that is not finite or beyond measure does no harm") {
    const auto values = open();
    Player player(bars(), rateHz);
    auto input = noise(4800);
    input[100] = std::numeric_limits<float>::infinity();
    input[200] = std::numeric_limits<float>::quiet_NaN();
    input[300] = 1e30f;
    const auto sound = renderStereo(player, {}, 4800, 256, values, input);
    CHECK(std::ranges::all_of(sound.left, [](float x) { return std::isfinite(x); }));
    CHECK(peak(sound.left) > 0);
}
