#include "Soak/RandomSession.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <memory>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Two minutes of music at random: finite, silent when it is over, as loud as before") {
    Processor processor;
    RandomSession session(processor);
    const double first = session.referenceLevel();
    CHECK(first > 1e-4);
    session.play(120, 1);
    CHECK(session.notesPlayed() > 500);
    session.settle();
    CHECK(std::abs(20 * std::log10(session.referenceLevel() / first)) < 0.001);
}

TEST_CASE("Music goes on on one thread while sounds, states and windows change on another") {
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
        processor.takeSoundFrame();
        processor.takeStatus();
    }
    audio.join();
    CHECK(fault.empty());
}
