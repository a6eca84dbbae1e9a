#include "Soak/RandomSession.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <memory>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE(
    "Two random minutes with many players give finite sound, end in silence and change nothing") {
    Processor processor;
    RandomSession session(processor);
    const auto first = session.phraseAnew();
    CHECK(rmsLevel(first) > 1e-4);
    session.play(120, 1);
    CHECK(session.notesPlayed() > 500);
    session.settle();
    const bool isAsBefore = session.phraseAnew() == first; // too long to print
    CHECK(isAsBefore);
}

TEST_CASE("A player sounds the same after two minutes of random music") {
    Processor processor;
    RandomSession session(processor, RandomSession::Changes::parameters);
    session.load(0);
    const auto first = session.phraseAfterReset();
    session.settle();
    const double rms = rmsLevel(session.phrase());
    session.settle();
    const double tremolo = session.tremolo();
    session.settle();
    session.play(120, 1);
    session.settle();
    CHECK(std::abs(20 * std::log10(rmsLevel(session.phrase()) / rms)) < 0.0001);
    session.settle();
    CHECK(std::abs(session.tremolo() - tremolo) < 0.1);
    session.settle();
    const bool isAsBefore = session.phraseAfterReset() == first; // too long to print
    CHECK(isAsBefore);
}

TEST_CASE("Pending note-offs and pedal releases silence music stopped at any time") {
    Processor processor;
    RandomSession session(processor, RandomSession::Changes::parameters);
    session.load(0);
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        session.play(0.5, seed, 600); // several notes a block
        REQUIRE_NOTHROW(session.settle());
    }
}

TEST_CASE("Music plays on one thread while sounds, states and windows change on another") {
    Processor processor;
    std::atomic<bool> done{false};
    std::string fault;
    RandomSession changes(processor);
    RandomSession session(processor, RandomSession::Changes::parameters);
    std::thread audio([&] {
        try {
            session.play(120, 2);
        } catch (const std::exception& error) {
            fault = error.what();
        }
        done = true;
    });
    std::unique_ptr<juce::AudioProcessorEditor> window;
    for (int time = 0; !done; ++time) {
        changes.changeSound();
        if (time % 5 == 0)
            window.reset();
        else if (window == nullptr)
            window.reset(processor.createEditorIfNeeded());
        juce::Timer::callPendingTimersSynchronously();
        processor.view().sound.takeSoundFrame();
        processor.view().status.takeStatus();
    }
    audio.join();
    CHECK(fault.empty());
}
