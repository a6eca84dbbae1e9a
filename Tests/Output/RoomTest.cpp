#include "Output/Room.h"

#include "Output/DecayTime.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr int maximumBlock = 4096;
constexpr double rampSeconds = 0.02;

struct Stereo {
    std::vector<float> left, right;
    bool operator==(const Stereo&) const = default;
};

ParameterValues roomOf(double percent, double decaySeconds) {
    ParameterValues values;
    values.set(ParameterId::room, percent);
    values.set(ParameterId::roomDecay, decaySeconds);
    return values;
}

/// Returns noise for some seconds, different on both sides, and then silence.
Stereo noiseBurst(double rateHz, double noiseSeconds, double seconds) {
    std::mt19937 random(1);
    std::normal_distribution<float> normal(0, 0.1f);
    Stereo burst;
    const auto count = static_cast<std::size_t>(seconds * rateHz);
    const auto sounding = static_cast<std::size_t>(noiseSeconds * rateHz);
    for (auto* side : {&burst.left, &burst.right}) {
        side->resize(count);
        std::generate_n(side->begin(), sounding, [&] { return normal(random); });
    }
    return burst;
}

Stereo
inRoom(Room& room, const Stereo& sound, const ParameterValues& values, std::size_t blockSize) {
    Stereo result;
    for (std::size_t start = 0; start < sound.left.size(); start += blockSize) {
        const auto count = std::min(blockSize, sound.left.size() - start);
        const auto heard = room.process({std::span(sound.left).subspan(start, count),
                                         std::span(sound.right).subspan(start, count)},
                                        values);
        result.left.insert(result.left.end(), heard.left.begin(), heard.left.end());
        result.right.insert(result.right.end(), heard.right.begin(), heard.right.end());
    }
    return result;
}

Stereo inNewRoom(const Stereo& sound,
                 double rateHz,
                 const ParameterValues& values,
                 std::size_t blockSize) {
    Room room;
    room.prepare(rateHz, maximumBlock, rampSeconds);
    return inRoom(room, sound, values, blockSize);
}

/// Returns the part below about 500 Hz.
std::vector<double> lowPart(const std::vector<float>& samples, double rateHz) {
    const double pole = std::exp(-2 * std::numbers::pi * 500 / rateHz);
    std::vector<double> low(samples.size());
    double first = 0, second = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        first += (1 - pole) * (samples[i] - first);
        second += (1 - pole) * (first - second);
        low[i] = second;
    }
    return low;
}

/// Filters by a resonator of 1 kHz bandwidth.
std::vector<double> bandAbout8kHz(const std::vector<float>& samples, double rateHz) {
    const double radius = std::exp(-std::numbers::pi * 1000 / rateHz);
    const double turn = 2 * radius * std::cos(2 * std::numbers::pi * 8000 / rateHz);
    std::vector<double> band(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        band[i] = static_cast<double>(samples[i]) -
                  (i >= 2 ? static_cast<double>(samples[i - 2]) : 0) +
                  (i >= 1 ? turn * band[i - 1] : 0) - (i >= 2 ? radius * radius * band[i - 2] : 0);
    return band;
}

Stereo part(const Stereo& sound, std::size_t from, std::size_t count) {
    const auto of = [&](const std::vector<float>& side) {
        const auto first = side.begin() + static_cast<std::ptrdiff_t>(from);
        return std::vector<float>(first, first + static_cast<std::ptrdiff_t>(count));
    };
    return {of(sound.left), of(sound.right)};
}

Stereo silence(std::size_t count) {
    return {std::vector<float>(count), std::vector<float>(count)};
}

double power(const std::vector<float>& samples) {
    double sum = 0;
    for (const double sample : samples)
        sum += sample * sample;
    return sum / static_cast<double>(samples.size());
}

} // namespace

TEST_CASE("A room fades by 60 dB in its decay time, at every sample rate") {
    for (const double rateHz : {44100.0, 48000.0, 96000.0})
        for (const double decaySeconds : {0.4, 1.0, 5.0}) {
            INFO(rateHz << " Hz, " << decaySeconds << " s");
            const double burst = 0.1;
            const auto sound = noiseBurst(rateHz, burst, burst + 1.5 * decaySeconds);
            const auto heard = inNewRoom(sound, rateHz, roomOf(100, decaySeconds), 512);
            const auto low = lowPart(heard.left, rateHz);
            const std::vector<double> tail(low.begin() + static_cast<int>(burst * rateHz),
                                           low.end());
            CHECK_THAT(decaySecondsOf(tail, rateHz, 35), WithinRel(decaySeconds, 0.2));
        }
}

TEST_CASE("High tones decay sooner than low ones, equally at all sample rates") {
    std::vector<double> seconds;
    for (const double rateHz : {44100.0, 48000.0, 96000.0, 192000.0}) {
        const auto heard = inNewRoom(noiseBurst(rateHz, 0.1, 2), rateHz, roomOf(100, 1.5), 512);
        const std::vector<float> tail(heard.left.begin() + static_cast<int>(0.1 * rateHz),
                                      heard.left.end());
        seconds.push_back(decaySecondsOf(bandAbout8kHz(tail, rateHz), rateHz, 35));
        INFO(rateHz << " Hz: " << seconds.back() << " s");
        CHECK(seconds.back() < 1.1);
        CHECK_THAT(seconds.back(), WithinRel(seconds.front(), 0.15));
    }
}

TEST_CASE("At 100 % and one second, reverb of noise is as loud as the noise") {
    const auto sound = noiseBurst(48000, 6, 6);
    const auto heard = inNewRoom(sound, 48000, roomOf(100, 1), 512);
    std::vector<float> added(sound.left.size());
    std::ranges::transform(heard.left, sound.left, added.begin(), std::minus{});
    added.erase(added.begin(), added.begin() + 2 * 48000);
    CHECK_THAT(10 * std::log10(power(added) / power(sound.left)), WithinAbs(0, 1));
}

TEST_CASE("A room's reverb does not depend on the block size") {
    const auto sound = noiseBurst(48000, 0.2, 2);
    const auto values = roomOf(60, 0.5);
    const auto expected = inNewRoom(sound, 48000, values, maximumBlock);
    for (const std::size_t blockSize : {1u, 7u, 64u, 480u})
        CHECK(inNewRoom(sound, 48000, values, blockSize) == expected);
}

TEST_CASE("A room falls silent, and then responds like a new one") {
    Room room;
    room.prepare(48000, maximumBlock, rampSeconds);
    CHECK(room.silent());
    const auto values = roomOf(50, 0.4);
    const auto sound = noiseBurst(48000, 0.1, 2);
    const auto first = inRoom(room, sound, values, 512);
    CHECK(room.silent());
    CHECK(first.left[48000 / 2] != 0);
    CHECK(first.left.back() == 0);
    CHECK(first.right.back() == 0);
    CHECK(inRoom(room, sound, values, 100) == first);
}

TEST_CASE("A reset silences a room, and its next values apply at once") {
    const auto sound = noiseBurst(48000, 0.1, 0.3);
    Room room;
    room.prepare(48000, maximumBlock, rampSeconds);
    inRoom(room, sound, roomOf(100, 8), 512);
    CHECK_FALSE(room.silent());
    room.reset();
    CHECK(room.silent());
    CHECK(inRoom(room, sound, roomOf(30, 0.4), 512) ==
          inNewRoom(sound, 48000, roomOf(30, 0.4), 512));
}

TEST_CASE("A hushed room fades within the ramp, and then responds again") {
    const auto sound = noiseBurst(48000, 0.1, 0.5);
    const auto values = roomOf(100, 5);
    Room room;
    room.prepare(48000, maximumBlock, rampSeconds);
    inRoom(room, sound, values, 480);
    room.hush(0);
    const auto nothing = silence(960);
    const auto fading = inRoom(room, nothing, values, 480);
    CHECK(power(fading.left) > 0);
    CHECK(room.silent());
    CHECK(power(inRoom(room, nothing, values, 480).left) == 0);
    CHECK(power(inRoom(room, sound, values, 480).left) > 0.9 * power(sound.left));
    CHECK_FALSE(room.silent());
    // `hush` does nothing in a room that is off, and the room works when it is turned on later.
    Room shut;
    shut.prepare(48000, maximumBlock, rampSeconds);
    inRoom(shut, sound, roomOf(0, 1), 480);
    shut.hush(0);
    inRoom(shut, sound, roomOf(0, 1), 480);
    inRoom(shut, sound, values, 480);
    CHECK_FALSE(shut.silent());
}

TEST_CASE("Input at or soon after a hush gets reverb as in a silent room") {
    const auto values = roomOf(100, 5);
    const auto rings = noiseBurst(48000, 0.2, 0.2), burst = noiseBurst(48000, 0.01, 0.5);
    for (const std::size_t later : {0u, 240u, 480u, 960u}) {
        CAPTURE(later);
        Room room, silent;
        for (auto* each : {&room, &silent})
            each->prepare(48000, maximumBlock, rampSeconds);
        inRoom(room, rings, values, 480);
        room.hush(0);
        inRoom(room, silence(later), values, 480);
        const auto heard = inRoom(room, burst, values, 480);
        const auto expected = inRoom(silent, burst, values, 480);
        const auto rest = burst.left.size() - 960;
        CHECK(power(part(expected, 960, rest).left) > 0);
        CHECK(part(heard, 960, rest) == part(expected, 960, rest));
    }
}

TEST_CASE("Reverb fades evenly after a hush, and a second hush does not cut the fade") {
    const auto values = roomOf(100, 5);
    const auto rings = noiseBurst(48000, 0.2, 0.2);
    const auto second = static_cast<std::size_t>(480);
    Room hushed, other;
    for (auto* each : {&hushed, &other}) {
        each->prepare(48000, maximumBlock, rampSeconds);
        inRoom(*each, rings, values, 480);
    }
    const auto unhushed = inRoom(other, silence(960), values, 480);
    const auto note = part(rings, 0, second);
    hushed.hush(0);
    auto fading = inRoom(hushed, note, values, 480);
    std::ranges::transform(fading.left, note.left, fading.left.begin(), std::minus{});
    hushed.hush(0);
    const auto further = inRoom(hushed, silence(960 - second), values, 480);
    fading.left.insert(fading.left.end(), further.left.begin(), further.left.end());
    for (std::size_t i = 0; i < 960; ++i)
        REQUIRE_THAT(fading.left[i], WithinAbs(static_cast<double>(959 - i) / 960 *
                                                   static_cast<double>(unhushed.left[i]),
                                               1e-6));
    CHECK(hushed.silent());
    CHECK(inRoom(hushed, silence(4800), values, 480) == silence(4800)); // the note has no reverb
}

TEST_CASE("Samples that a hush leaves unanswered get no reverb") {
    const auto values = roomOf(100, 5);
    const auto sound = noiseBurst(48000, 0.1, 0.3);
    constexpr std::size_t dry = 700;
    Room room, silent;
    for (auto* each : {&room, &silent})
        each->prepare(48000, maximumBlock, rampSeconds);
    room.hush(dry);
    const auto heard = inRoom(room, sound, values, 480);
    auto later = sound;
    for (auto* side : {&later.left, &later.right})
        std::fill_n(side->begin(), dry, 0.0f);
    const auto answered = inRoom(silent, later, values, 480);
    const auto rest = sound.left.size() - dry;
    CHECK(part(heard, 0, dry) == part(sound, 0, dry));
    CHECK(part(heard, dry, rest) == part(answered, dry, rest));
}

TEST_CASE("A hushed room's output does not depend on the block size") {
    const auto sound = noiseBurst(48000, 0.5, 0.8);
    const auto values = roomOf(100, 3);
    const auto played = [&](std::size_t blockSize) {
        Room room;
        room.prepare(48000, maximumBlock, rampSeconds);
        Stereo result;
        std::size_t from = 0;
        for (const std::size_t until : {9600u, 9933u, 12000u, 38400u}) {
            const auto heard = inRoom(room, part(sound, from, until - from), values, blockSize);
            result.left.insert(result.left.end(), heard.left.begin(), heard.left.end());
            result.right.insert(result.right.end(), heard.right.begin(), heard.right.end());
            room.hush(until == 12000 ? 100 : 0);
            from = until;
        }
        return result;
    };
    const auto expected = played(maximumBlock);
    for (const std::size_t blockSize : {1u, 7u, 64u, 300u, 800u})
        CHECK(played(blockSize) == expected);
}

TEST_CASE("Turning a room on and off makes no step, for all block sizes") {
    Room whole, pieces;
    whole.prepare(48000, maximumBlock, rampSeconds);
    pieces.prepare(48000, maximumBlock, rampSeconds);
    Stereo sound;
    for (int i = 0; i < 96000; ++i) {
        sound.left.push_back(static_cast<float>(std::sin(0.02 * i)));
        sound.right.push_back(static_cast<float>(std::cos(0.02 * i)));
    }
    float last = 0;
    for (int turn = 0; turn < 20; ++turn) {
        const auto values = turn % 2 == 0 ? roomOf(100, turn % 4 == 0 ? 0.4 : 5) : roomOf(0, 1);
        const auto from = sound.left.begin() + turn * 4096;
        const auto otherFrom = sound.right.begin() + turn * 4096;
        const Stereo part{{from, from + 4096}, {otherFrom, otherFrom + 4096}};
        const auto heard = inRoom(whole, part, values, maximumBlock);
        CHECK(inRoom(pieces, part, values, 37) == heard);
        for (const float sample : heard.left) {
            REQUIRE(std::abs(sample - last) < 0.12f);
            last = sample;
        }
        if (turn % 2 == 1) {
            CHECK(whole.silent());
            CHECK(heard.left.back() == part.left.back());
        }
    }
}

TEST_CASE("A room accepts any sample rate") {
    const Stereo sound{std::vector<float>(5000, 0.1f), std::vector<float>(5000, 0.1f)};
    for (const double rateHz : {1.0, 8000.0, 384000.0, 1e9})
        for (const float sample : inNewRoom(sound, rateHz, roomOf(100, 10), 512).left)
            REQUIRE(std::isfinite(sample));
}
