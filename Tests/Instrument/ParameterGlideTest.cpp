#include "Instrument/ParameterGlide.h"

#include "Instrument/Player.h"
#include "Support/Larger.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <complex>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;
using Catch::Approx;

namespace {

constexpr double rateHz = 48000;
constexpr double cellSeconds = 64 / rateHz;

ParameterValues with(ParameterId parameter, double value, ParameterValues values = {}) {
    values.set(parameter, value);
    return values;
}

} // namespace

TEST_CASE("The first values act at once, and later ones glide until they are exact") {
    ParameterGlide glide(cellSeconds);
    const auto first = with(size, 2, with(malletMass, 50));
    glide.setGoal(first);
    CHECK(glide.values() == first);
    const auto second = with(size, 0.5, with(malletMass, 10));
    glide.setGoal(second);
    CHECK(glide.values()[malletMass] == 10); // at once, because it affects strikes only
    CHECK(glide.values()[size] == 2);
    int cells = 0;
    double before = 2;
    for (; glide.values() != second && cells < 1000; ++cells) {
        glide.advance();
        CHECK(glide.values()[size] < before);
        before = glide.values()[size];
    }
    CHECK(cells * cellSeconds < 0.15);
    glide.reset();
    glide.setGoal(first);
    CHECK(glide.values() == first);
}

TEST_CASE("A glide covers 63 % of its way in 10 ms at any sample rate") {
    for (const double hertz : {22050.0, 48000.0, 192000.0}) {
        ParameterGlide glide(64 / hertz);
        glide.setGoal({});
        glide.setGoal(with(tune, 1000));
        const int cells = static_cast<int>(std::lround(0.01 * hertz / 64));
        for (int cell = 0; cell < cells; ++cell)
            glide.advance();
        CHECK(glide.values()[tune] == Approx(1000 * -std::expm1(-cells * 64 / hertz / 0.01)));
    }
}

TEST_CASE("The figures of a newly chosen material do not glide from those of another") {
    ParameterGlide glide(cellSeconds);
    glide.setGoal(with(material, 5));
    const auto custom = with(youngsModulus, 200, with(material, customMaterial));
    glide.setGoal(custom);
    CHECK(glide.values() == custom);
    glide.setGoal(with(youngsModulus, 100, custom));
    CHECK(glide.values()[youngsModulus] == 200);
}

TEST_CASE("A pitch that changes once a block sounds as a slide, not as steps") {
    // Measures the pitch of a ringing bar from its phase gain in a millisecond.
    constexpr int blockSize = 512, samples = 48000;
    enum Source { tuneParameter, wheel, wheelOfNote };
    const auto source = GENERATE(tuneParameter, wheel, wheelOfNote);
    CAPTURE(source);
    ParameterValues values = with(strikeSpread, 0, with(bendRange, 12));
    values = with(mpe, source == wheelOfNote, with(mpeBendRange, 12, values));
    Player player(keysOn(syntheticObject({440}), KeyMapKind::scaled, 60, 72), rateHz);
    StereoSound sound(samples);
    for (int start = 0; start < samples; start += blockSize) {
        const auto count = std::min(blockSize, samples - start);
        std::vector<MidiEvent> events;
        if (start == 0)
            events.push_back(midi(0, 0x91, 69, 100));
        if (source == tuneParameter) {
            values.set(tune, 1200.0 * start / samples);
        } else {
            const int bend = 8192 + 8191 * start / samples;
            events.push_back(midi(0, 0xe1, bend % 128, bend / 128));
        }
        player.process(StereoSpan(sound).subspan(static_cast<std::size_t>(start),
                                                 static_cast<std::size_t>(count)),
                       events, values);
    }
    // Heterodyne and average over 5 ms.
    std::vector<double> cents;
    std::complex<double> before;
    for (std::size_t at = 4800; at + 480 < 36000; at += 48) {
        std::complex<double> sum;
        for (std::size_t i = 0; i < 240; ++i) {
            const double hann = 1 - std::cos(2 * std::numbers::pi * static_cast<double>(i) / 240);
            sum +=
                hann * static_cast<double>(sound.left[at + i]) *
                std::polar(1.0, -2 * std::numbers::pi * 600 * static_cast<double>(at + i) / rateHz);
        }
        if (at > 4800)
            cents.push_back(
                1200 *
                std::log2((600 + std::arg(sum / before) / (2 * std::numbers::pi * 0.001)) / 440));
        before = sum;
    }
    // A block's step is 12.8 cents. Without a glide the maximum would be 7.7; a steady slide
    // has up to 3.
    double steepest = 0;
    for (std::size_t i = 1; i < cents.size(); ++i)
        steepest = larger(steepest, std::abs(cents[i] - cents[i - 1]));
    INFO(steepest);
    CHECK(steepest < 4.5);
    CHECK(cents.back() - cents.front() > 500);
}
