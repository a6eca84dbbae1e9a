// Who predicts the gain that matches loudness: live the poll, offline the callback.
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

constexpr int key = 64, samples = 4800;

/// A host that matches loudness, or does not, and changes the material.
struct MatchingHost {
    explicit MatchingHost(bool matches, bool isOffline = false) {
        auto state = testState();
        state.parameters.set(matchLoudness, matches ? 1 : 0);
        state.parameters.set(strikeSpread, 0);
        processor.setNonRealtime(isOffline);
        restore(processor, state);
        processor.prepareToPlay(testRateHz, samples);
    }

    void choose(int material) {
        processor.view().parameters.change(ParameterId::material, firstLibraryMaterial + material);
    }
    HostSound strike(int blockSize = 480) {
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, key, juce::uint8{100}), 0);
        return render(processor, samples, blockSize, midi);
    }

    Processor processor;
};

/// Returns the ratio of the last samples, which follow the gain's glide.
double gainAtEnd(const HostSound& matched, const HostSound& plain) {
    const auto end = [](const HostSound& sound) {
        return loudest(std::vector(sound.left.end() - 480, sound.left.end()));
    };
    return end(matched) / end(plain);
}

} // namespace

TEST_CASE("Live the gain of another material comes with the poll, however many blocks it takes") {
    MatchingHost matching(true), plain(false);
    for (auto* host : {&matching, &plain})
        host->choose(5);
    for (int strikes = 0; strikes < 5; ++strikes)
        CHECK((matching.strike() == plain.strike()));
    for (auto* host : {&matching, &plain})
        host->processor.poll();
    const auto ringing = matching.strike();
    CHECK(std::abs(std::log(gainAtEnd(ringing, plain.strike()))) > 0.02);
}

TEST_CASE("Offline the gain of another material comes without a poll, in blocks of any size") {
    const auto played = [](bool matches, int blockSize) {
        MatchingHost host(matches, true);
        auto sound = host.strike(blockSize);
        host.choose(5);
        sound.append(host.strike(blockSize));
        return sound;
    };
    const auto matched = played(true, samples);
    for (const int blockSize : {1, 64, 100, 480})
        CHECK((played(true, blockSize) == matched));
    CHECK(std::abs(std::log(gainAtEnd(matched, played(false, samples)))) > 0.02);
}

TEST_CASE("A live session and a bounce end at the same gain") {
    MatchingHost live(true), bounce(true, true);
    for (auto* host : {&live, &bounce}) {
        host->choose(5);
        host->strike();
        host->processor.poll();
        host->strike();
        host->processor.reset();
    }
    CHECK((live.strike() == bounce.strike()));
}

TEST_CASE("A prediction that a former sound asked for does not change the next one") {
    constexpr int vibraphone = 9;
    const auto played = [](bool asks) {
        MatchingHost host(true);
        if (asks)
            host.choose(5);
        render(host.processor, samples, samples, {}); // asks, and remains silent
        host.processor.setCurrentProgram(vibraphone);
        host.processor.view().parameters.change(matchLoudness, 1);
        render(host.processor, samples, samples, {});
        host.processor.poll();
        return host.strike();
    };
    const auto expected = played(false);
    REQUIRE(loudest(expected) > 0.001f);
    CHECK((played(true) == expected));
}
