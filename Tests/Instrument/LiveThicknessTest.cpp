// Tests that keys follow a live thickness. A sheet is stiff by bending alone: with twice the
// thickness its modes are an octave higher, at half the amplitude.
#include "Instrument/LoudnessMatch.h"
#include "Instrument/PhrasePrediction.h"
#include "Instrument/Player.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;

std::shared_ptr<const Instrument> sheet() {
    auto object = syntheticObject({180, 410, 1030});
    object.bending = object.eigenvalues;
    return keysOn(std::move(object), KeyMapKind::zones, 48, 72);
}

/// The sheet made twice as thick: twice as heavy, an octave higher.
std::shared_ptr<const Instrument> thickSheet() {
    auto object = syntheticObject({360, 820, 2060});
    for (float& component : object.shapes)
        component /= std::sqrt(2.0f);
    object.mass.massKg *= 2;
    for (double& moment : object.mass.inertiaKgM2)
        moment *= 2;
    return keysOn(std::move(object), KeyMapKind::zones, 48, 72);
}

/// Returns the largest difference between live thickness 2 and a sheet of twice the thickness, over
/// the peak.
double errorOfThickSheet(const ParameterValues& parameters) {
    const std::vector events{midi(0, 0x90, 60, 100), midi(30000, 0x80, 60, 0)};
    Player thick(sheet(), sampleRateHz);
    Player higher(thickSheet(), sampleRateHz);
    const auto sound = render(thick, events, 48000, 480, with(parameters, thickness, 200));
    const auto expected = render(higher, events, 48000, 480, parameters);
    float worst = 0;
    for (std::size_t i = 0; i < sound.size(); ++i)
        worst = std::max(worst, std::abs(sound[i] - expected[i]));
    return static_cast<double>(worst) / peak(expected);
}

/// A radiating shell whose modes move apart as it gets thicker.
std::shared_ptr<const Instrument> shellUnderKeys() {
    auto object = syntheticObject({220, 700, 1900, 4300});
    object.bending = {0, object.eigenvalues[1], object.eigenvalues[2] / 2, object.eigenvalues[3]};
    object.radiation = {.directions = {{-0.6f, 0, 0.8f}, {0.6f, 0, 0.8f}},
                        .frequencyRatios = {1},
                        .weights = {0.02f, -0.01f, 0.03f, 0.02f, 0.01f, 0.05f, -0.02f, 0.04f}};
    return keysOn(std::move(object), KeyMapKind::scaled, 48, 72);
}

} // namespace

TEST_CASE("A struck sheet at live thickness 2 sounds like a sheet of twice the thickness") {
    for (const int pulse : {0, 1}) {
        ParameterValues parameters;
        parameters.set(modalPulse, pulse);
        parameters.set(malletSpeed, 1);
        CHECK(errorOfThickSheet(parameters) < 1e-3);
    }
}

TEST_CASE("A rolled sheet at live thickness 2 sounds like a sheet of twice the thickness") {
    ParameterValues parameters;
    parameters.set(contact, rollContact);
    parameters.set(rollCoupling, 100);
    CHECK(errorOfThickSheet(parameters) < 1e-3);
}

TEST_CASE("The predicted loudness at live thickness 2 is that of a sheet of twice the thickness") {
    ParameterValues parameters;
    parameters.set(rollCoupling, 100);
    parameters.set(modalPulse, 1);
    for (const int kind : {strikeContact, rollContact}) {
        parameters.set(contact, kind);
        const auto lufs =
            predictedLoudness({sheet(), {}, sampleRateHz}, with(parameters, thickness, 200));
        const auto expected = predictedLoudness({thickSheet(), {}, sampleRateHz}, parameters);
        for (std::size_t level = 0; level < lufs.size(); ++level)
            CHECK(lufs[level] == Approx(expected[level]).margin(1e-5));
    }
}

TEST_CASE("valuesThatMatter keeps all values that a prediction uses, including thickness") {
    const auto instrument = shellUnderKeys();
    for (const int kind : {strikeContact, scrapeContact, rollContact}) {
        ParameterValues own;
        own.set(contact, kind);
        own.set(rollCoupling, 50);
        const Phrase phrase(instrument, {}, sampleRateHz);
        for (const auto& info : parameterTable())
            for (const double value : {info.minimum, info.maximum}) {
                const auto values = with(own, info.parameter, value);
                INFO(info.id << " at " << value << ", contact " << kind);
                CHECK(predictedLoudness(phrase, values) ==
                      predictedLoudness(phrase, valuesThatMatter(values)));
            }
    }
}

TEST_CASE("The matching gain compares both materials at the current thickness") {
    const auto instrument = shellUnderKeys();
    ParameterValues own;
    own.set(matchLoudness, 1);
    const Phrase phrase(instrument, {}, sampleRateHz);
    const LoudnessMatch match(phrase, own);
    const auto gainAt = [&](double percent) {
        const auto now = with(with(own, thickness, percent), material, firstLibraryMaterial);
        const double gain = match.gainDb(now);
        const double wanted = predictedLufs(phrase, with(own, thickness, percent));
        CHECK(std::abs(gain - (wanted - predictedLufs(phrase, now))) <= 1.5 + 1e-9);
        return gain;
    };
    const double thin = gainAt(30), thick = gainAt(350);
    CHECK(std::abs(thin - thick) > 0.5);
}
