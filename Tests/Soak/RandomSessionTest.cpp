#include "Soak/RandomSession.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <memory>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE(
    "Two minutes of many players at random: finite, silent when it is over, and anew as before") {
    Processor processor;
    RandomSession session(processor);
    const auto first = session.phraseAnew();
    CHECK(rmsLevel(first) > 1e-4);
    session.play(120, 1);
    CHECK(session.notesPlayed() > 500);
    session.settle();
    CHECK(session.phraseAnew() == first);
}

TEST_CASE("A player that was played at random for two minutes sounds as it did at first") {
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
    CHECK(std::abs(20 * std::log10(rmsLevel(session.phrase()) / rms)) < 0.001);
    session.settle();
    CHECK(std::abs(session.tremolo() - tremolo) < 0.1);
    session.settle();
    CHECK(session.phraseAfterReset() == first);
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

#include <chrono>
#include <cstdio>
#include <ctime>
TEST_CASE("TEMP timing", "[.temp]") {
    const auto cpu = [] { return double(std::clock()) / CLOCKS_PER_SEC; };
    Processor processor;
    RandomSession session(processor);
    for (int seed = 1; seed <= 6; ++seed) {
        const double start = cpu();
        session.play(20, seed);
        const double played = cpu();
        const bool stage = processor.hasStage();
        const auto name = processor.loadedSound().preset.name;
        session.settle();
        std::printf("many %d: play %.2f settle %.2f cpu s, stage %d %s\n", seed, played - start, cpu() - played, stage, name.c_str());
        std::fflush(stdout);
    }
}
TEST_CASE("TEMP life", "[.temp]") {
    const auto cpu = [] { return double(std::clock()) / CLOCKS_PER_SEC; };
    Processor processor;
    RandomSession session(processor, RandomSession::Changes::parameters);
    for (int program : {0, 3, 7}) {
        session.load(program);
        const auto first = session.phraseAfterReset();
        session.settle();
        const auto again = session.phraseAfterReset();
        session.settle();
        const auto said = [](const PlayedPhrase& a, const PlayedPhrase& b) {
            double most = 0; std::size_t where = 0, count = 0;
            for (std::size_t i = 0; i < a.size(); ++i)
                if (a[i] != b[i]) { if (!count++) where = i; most = std::max<double>(most, std::abs(a[i] - b[i])); }
            std::printf("  differ %zu of %zu, first %zu, most %.3g\n", count, a.size(), where, most);
        };
        said(first, again);
        const double rms = rmsLevel(session.phrase());
        session.settle();
        const double tremolo = session.tremolo();
        session.settle();
        const double tremolo2 = session.tremolo();
        session.settle();
        std::printf("program %d rms %.4g (reset %.4g) tremolo %.4f %.4f\n", program, rms, rmsLevel(first), tremolo, tremolo2);
        for (int seed = 1; seed <= 4; ++seed) {
            const double start = cpu();
            session.play(20, seed);
            const double played = cpu();
            try { session.settle(); } catch (const std::exception& e) { std::printf("%s\n", e.what()); }
            const double db = 20 * std::log10(rmsLevel(session.phrase()) / rms);
            session.settle();
            std::printf("  seed %d: play %.2f cpu s, settle.. %.2f; db %.6f tremolo %.4f\n", seed, played - start, cpu() - played, db, session.tremolo());
            session.settle();
            std::fflush(stdout);
        }
        said(first, session.phraseAfterReset());
        session.settle();
    }
}

TEST_CASE("TEMP bisect", "[.temp]") {
    Processor processor;
    RandomSession session(processor, RandomSession::Changes::parameters);
    session.load(0);
    const auto first = session.phraseAfterReset();
    session.settle();
    const auto said = [&](const char* what) {
        session.settle();
        const auto b = session.phraseAfterReset();
        session.settle();
        std::size_t count = 0;
        for (std::size_t i = 0; i < b.size(); ++i) count += first[i] != b[i];
        if (count) std::printf("%s: %zu differ\n", what, count);
        std::fflush(stdout);
        if (count) session.load(0);
    };
    said("nothing");
    for (auto* parameter : processor.getParameters()) {
        if (parameter == processor.getBypassParameter()) continue;
        for (float value : {0.0f, 0.3f, 1.0f}) {
            parameter->setValue(value);
            juce::MidiBuffer midi;
            juce::AudioBuffer<float> buffer(2, 4800);
            midi.addEvent(juce::MidiMessage::noteOn(1, 70, juce::uint8{100}), 0);
            processor.processBlock(buffer, midi);
            midi.clear();
            midi.addEvent(juce::MidiMessage::noteOff(1, 70), 0);
            processor.processBlock(buffer, midi);
            said((parameter->getName(50) + " " + juce::String(value)).toRawUTF8());
        }
    }
    const auto send = [&](const juce::MidiMessage& message, const char* what) {
        juce::MidiBuffer midi;
        juce::AudioBuffer<float> buffer(2, 4800);
        midi.addEvent(message, 0);
        midi.addEvent(juce::MidiMessage::noteOn(1, 70, juce::uint8{100}), 0);
        processor.processBlock(buffer, midi);
        midi.clear();
        midi.addEvent(juce::MidiMessage::noteOff(1, 70), 0);
        processor.processBlock(buffer, midi);
        said(what);
    };
    send(juce::MidiMessage::pitchWheel(1, 3000), "wheel");
    for (int c : {1, 64, 66, 67, 74, 120, 121, 123}) send(juce::MidiMessage::controllerEvent(1, c, 80), std::to_string(c).c_str());
    const unsigned char one[]{0x7f, 0x7f, 8, 2, 0, 1, 70, 71, 3, 3};
    send(juce::MidiMessage::createSysExMessage(one, sizeof one), "sysex");
}

TEST_CASE("TEMP stage", "[.temp]") {
    const auto cpu = [] { return double(std::clock()) / CLOCKS_PER_SEC; };
    Processor processor;
    RandomSession session(processor);
    std::map<std::string, std::pair<double, double>> used;
    for (int i = 0; i < 240; ++i) {
        const double start = cpu();
        const bool before = processor.hasStage();
        session.play(0.5, 100 + i);
        const auto name = processor.loadedSound().preset.name + (before == processor.hasStage() ? "" : "*");
        used[name].first += 0.5;
        used[name].second += cpu() - start;
    }
    for (auto& [name, seconds] : used) std::printf("%s: %.1f s in %.2f\n", name.c_str(), seconds.first, seconds.second);
    double start = cpu();
    session.settle();
    std::printf("settle %.2f\n", cpu() - start);
}
