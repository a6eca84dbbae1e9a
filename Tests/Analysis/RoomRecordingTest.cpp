// Fits of strikes recorded in a room, with rumble, hum and noise, whose modes are known.
#include "Analysis/RecordingFit.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace idiophone;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double rate = 48000;

struct Partial {
    double frequencyHz = 0;
    double t60Seconds = 0;
    double gain = 0;

    double decayPerSecond() const { return std::log(1000) / t60Seconds; }
};

/// Every second tone is a pair 0.3 % apart.
std::vector<Partial> pairedPartials() {
    std::vector<Partial> partials;
    bool isPair = false;
    double gain = 1;
    for (const double hz : {420.0, 730.0, 1150.0, 1900.0, 2870.0, 4300.0, 6100.0, 9200.0}) {
        partials.push_back({.frequencyHz = hz, .t60Seconds = 25 / std::sqrt(hz), .gain = gain});
        if (isPair)
            partials.push_back(
                {.frequencyHz = hz * 1.003, .t60Seconds = 22 / std::sqrt(hz), .gain = 0.7 * gain});
        isPair = !isPair;
        gain *= 0.85;
    }
    return partials;
}

class RoomRecording {
public:
    explicit RoomRecording(double quietSeconds, unsigned seed = 11)
        : quiet(count(quietSeconds)), random(seed) {}

    static std::size_t count(double seconds) { return static_cast<std::size_t>(seconds * rate); }

    /// Returns two seconds of the partials from the strike on, of peak 0.8.
    std::vector<float> samples(const std::vector<Partial>& partials) {
        std::vector<double> sound(quiet + count(2));
        for (const auto& partial : partials)
            for (std::size_t n = quiet; n < sound.size(); ++n) {
                const double t = static_cast<double>(n - quiet) / rate;
                sound[n] += partial.gain * std::exp(-partial.decayPerSecond() * t) *
                            std::sin(2 * pi * partial.frequencyHz * t);
            }
        addRoom(sound);
        scale(sound, 0.7);
        addNoise(sound);
        scale(sound, 0.8);
        return {sound.begin(), sound.end()};
    }

private:
    static void scale(std::vector<double>& sound, double peak) {
        double highest = 0;
        for (const double value : sound)
            highest = std::max(highest, std::abs(value));
        for (double& value : sound)
            value *= peak / highest;
    }

    /// Adds 400 echoes at random times, which decay by 60 dB in 0.4 s and together lie at −30 dB.
    void addRoom(std::vector<double>& sound) {
        constexpr double echoes = 5.9e-3;
        const auto dry = sound;
        std::uniform_real_distribution<double> times(0.001, 0.4);
        for (int echo = 0; echo < 400; ++echo) {
            const double seconds = times(random);
            const double gain =
                (echo % 2 == 0 ? 1 : -1) * echoes * std::pow(10, -3 * seconds / 0.4);
            for (std::size_t n = quiet + count(seconds); n < sound.size(); ++n)
                sound[n] += gain * dry[n - count(seconds)];
        }
    }

    /// Adds white noise at −40 dB of the peak, rumble below 100 Hz that is three times as strong,
    /// and hum.
    void addNoise(std::vector<double>& sound) {
        std::normal_distribution<double> noise(0, 0.01 * 0.7);
        double low[4] = {};
        for (std::size_t n = 0; n < sound.size(); ++n) {
            const double t = static_cast<double>(n) / rate;
            double rumble = 100 * noise(random);
            for (double& stage : low)
                rumble = stage += 0.005 * (rumble - stage);
            sound[n] += noise(random) + rumble + 0.01 * std::cos(2 * pi * 50 * t) +
                        0.004 * std::cos(2 * pi * 150 * t);
        }
    }

    std::size_t quiet;
    std::mt19937 random;
};

Result<RecordingFit> fitted(const std::vector<float>& samples, const WorkControl& control = {}) {
    return fitRecordings(std::vector<StrikeRecording>{{"room.wav", samples, rate}}, {}, control);
}

void checkAllFound(const RecordingFit& fit, const std::vector<Partial>& partials) {
    for (const auto& partial : partials) {
        const auto& mode = *std::ranges::min_element(fit.modes, {}, [&](const MeasuredMode& each) {
            return std::abs(each.frequencyHz - partial.frequencyHz);
        });
        CAPTURE(partial.frequencyHz, mode.frequencyHz, partial.decayPerSecond(),
                mode.decayPerSecond);
        CHECK(std::abs(1200 * std::log2(mode.frequencyHz / partial.frequencyHz)) < 2);
        CHECK(std::abs(mode.decayPerSecond / partial.decayPerSecond() - 1) < 0.12);
    }
}

} // namespace

TEST_CASE("Modes and pairs 0.3 % apart are found in a room with rumble, hum and noise at -40 dB") {
    const auto partials = pairedPartials();
    // In the second, third and fourth room, echoes look like more modes.
    for (const auto& [quietSeconds, seed] :
         {std::pair{0.3, 11u}, {0.3, 13u}, {0.002, 14u}, {0.002, 16u}}) {
        CAPTURE(quietSeconds, seed);
        const auto fit = fitted(RoomRecording(quietSeconds, seed).samples(partials));
        REQUIRE(fit);
        checkAllFound(*fit, partials);
        CHECK(fit->modes.size() < 2 * partials.size());
        CHECK(fit->modes.front().frequencyHz > 300); // neither rumble nor hum
    }
}

TEST_CASE("A fit reports the hum, the rumble and the modes of a recording") {
    const auto fit = fitted(RoomRecording(0.3).samples(pairedPartials()));
    REQUIRE(fit);
    const auto& rest = fit->rests.front();
    CHECK(rest.modes > 0.4);
    CHECK(rest.modes < 0.99);
    CHECK(rest.noise > 0.005);
    CHECK(std::ranges::any_of(rest.steadyHz, [](double hz) { return std::abs(hz - 50) < 1; }));
    CHECK(std::abs(rest.modes + rest.contact + rest.steadyTones + rest.noise + rest.others - 1) <
          0.01);
    const auto sentence = rest.sentence();
    CHECK_THAT(sentence, ContainsSubstring("The modes hold "));
    CHECK_THAT(sentence, ContainsSubstring("hum and other steady tones (50"));
    CHECK_THAT(sentence, ContainsSubstring("steady noise and rumble"));
}

TEST_CASE("The modes alone sound like the recording, from the strike on and at its level") {
    const auto samples = RoomRecording(0.3).samples(pairedPartials());
    const auto fit = fitted(samples);
    REQUIRE(fit);
    const auto sound = resynthesised(*fit, 0, {"room.wav", samples, rate});
    REQUIRE(sound.size() == samples.size());
    const auto strike = RoomRecording::count(0.3);
    CHECK(std::ranges::all_of(sound.begin(),
                              sound.begin() + static_cast<std::ptrdiff_t>(strike - 24),
                              [](float value) { return value == 0; }));
    // The noise lies 22 dB below the first 50 ms.
    double difference = 0, energy = 0;
    for (std::size_t n = fit->decayBegins[0]; n < strike + 2400; ++n) {
        difference += std::pow(static_cast<double>(sound[n] - samples[n]), 2);
        energy += std::pow(static_cast<double>(samples[n]), 2);
    }
    CHECK(10 * std::log10(difference / energy) < -15);
}

TEST_CASE("A loud broadband contact does not become a mode") {
    auto samples = RoomRecording(0.3).samples({{.frequencyHz = 700, .t60Seconds = 1, .gain = 1}});
    std::mt19937 random(5);
    std::normal_distribution<float> noise(0, 0.3f);
    for (std::size_t n = RoomRecording::count(0.3); n < RoomRecording::count(0.31); ++n) {
        const double t = static_cast<double>(n) / rate - 0.3;
        samples[n] += noise(random) * static_cast<float>(std::exp(-t / 0.003));
    }
    const auto fit = fitted(samples);
    REQUIRE(fit);
    const auto loudest = *std::ranges::max_element(fit->modes, {}, [](const MeasuredMode& mode) {
        return std::norm(mode.waves[0]) / mode.decayPerSecond;
    });
    CHECK(std::abs(loudest.frequencyHz - 700) < 0.5);
    CHECK(std::abs(loudest.decayPerSecond / std::log(1000) - 1) < 0.05);
}

TEST_CASE("A fit reports its progress and stops when it is cancelled") {
    const auto samples = RoomRecording(0.3).samples(pairedPartials());
    double last = 0;
    int reports = 0;
    bool isAscending = true;
    const auto follow = [&](double fraction, std::string_view) {
        isAscending = isAscending && fraction >= last && fraction <= 1;
        last = fraction;
        ++reports;
    };
    REQUIRE(fitted(samples, {.progress = follow, .cancelled = nullptr}));
    CHECK(isAscending);
    CHECK(reports > 20);
    for (const double until : {0.0, 0.3, 0.7}) {
        std::atomic<bool> cancelled = false;
        const auto stop = [&](double fraction, std::string_view) { cancelled = fraction >= until; };
        const auto fit = fitted(samples, {.progress = stop, .cancelled = &cancelled});
        REQUIRE_FALSE(fit);
        CHECK(isCancellation(fit.error()));
    }
}
