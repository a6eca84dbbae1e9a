// MPE zones and bend ranges set by MIDI: shown, sent to the host, saved, and reset by a state.
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <utility>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr int blockSize = 480;

/// Sends a registered parameter. Channels count from 1, as in JUCE.
void give(juce::MidiBuffer& midi, int channel, int registered, int value) {
    for (const auto& [number, data] : {std::pair{101, 0}, {100, registered}, {6, value}})
        midi.addEvent(juce::MidiMessage::controllerEvent(channel, number, data), 0);
}

constexpr int bendRange = 0, zone = 6; // registered parameters

/// Notes on three channels whose pitch wheels differ.
juce::MidiBuffer bentNotes() {
    juce::MidiBuffer midi;
    for (const auto& [channel, note, wheel] :
         {std::tuple{2, 62, 16383}, {9, 65, 0}, {12, 70, 12000}}) {
        midi.addEvent(juce::MidiMessage::noteOn(channel, note, juce::uint8{100}), 10);
        midi.addEvent(juce::MidiMessage::pitchWheel(channel, wheel), 10);
    }
    return midi;
}

struct Instance {
    explicit Instance(const State& state) {
        restore(processor, state);
        processor.prepareToPlay(testRateHz, blockSize);
    }
    void send(const juce::MidiBuffer& midi) { render(processor, blockSize, blockSize, midi); }
    HostSound playBent() { return render(processor, 9600, blockSize, bentNotes()); }
    double value(ParameterId parameter) { return processor.view().parameters.value(parameter); }

    Processor processor;
};

struct CountingHost final : juce::AudioProcessorListener {
    void audioProcessorParameterChanged(juce::AudioProcessor*, int index, float value) override {
        heard.emplace_back(index, value);
    }
    void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails&) override {}
    std::vector<std::pair<int, float>> heard;
};

} // namespace

TEST_CASE("Zones and bend ranges set by MIDI become parameter values and are saved") {
    Instance before(testState());
    juce::MidiBuffer setup;
    give(setup, 1, zone, 15);
    give(setup, 3, bendRange, 24);
    before.send(setup);
    CHECK(before.value(ParameterId::mpe) == 1);
    CHECK(before.value(ParameterId::mpeBendRange) == 24);

    Instance reopened(testState()), plain(testState());
    restoreBytes(reopened.processor, saved(before.processor));
    reopened.send({}); // takes the restored sound
    const auto sound = reopened.playBent();
    CHECK(sound != plain.playBent());
    Instance fresh(testState());
    fresh.send(setup);
    CHECK(sound == fresh.playBent());

    juce::MidiBuffer none;
    give(none, 1, zone, 0);
    before.send(none);
    CHECK(before.value(ParameterId::mpe) == 0);
}

TEST_CASE("Zones and bend ranges set by MIDI are sent to the host only if they change a value") {
    CountingHost host;
    Instance instance(testState());
    instance.processor.addListener(&host);
    juce::MidiBuffer setup;
    give(setup, 1, zone, 15);
    give(setup, 1, bendRange, 12);
    for (int times = 0; times < 3; ++times) {
        instance.send(setup);
        for (int polls = 0; polls < 6; ++polls)
            instance.processor.poll();
    }
    const std::vector<std::pair<int, float>> once{{static_cast<int>(ParameterId::mpe), 1.0f}};
    CHECK(host.heard == once); // the members' range was 48 before; the other is the preset's
    instance.processor.removeListener(&host);
}

TEST_CASE("A bend range set by MIDI holds in the next preset and changes none of its values") {
    constexpr int marimba = 8;
    juce::MidiBuffer setup;
    give(setup, 1, bendRange, 12);
    juce::MidiBuffer bent;
    bent.addEvent(juce::MidiMessage::noteOn(1, 62, juce::uint8{100}), 10);
    bent.addEvent(juce::MidiMessage::pitchWheel(1, 16383), 10);
    const auto played = [&](const juce::MidiBuffer& before, const juce::MidiBuffer& after) {
        Instance instance(testState());
        instance.send(before);
        instance.processor.setCurrentProgram(marimba);
        instance.send(after);
        CHECK(instance.value(ParameterId::bendRange) == 2);
        CHECK_FALSE(instance.processor.soundSession().playingPreset().isChanged);
        return render(instance.processor, 9600, blockSize, bent);
    };
    const auto sound = played(setup, {});
    CHECK(sound == played({}, setup));
    CHECK(sound != played({}, {}));
}

TEST_CASE("A restored state resets zones and bend ranges set by MIDI") {
    auto state = testState();
    SECTION("without zones") {}
    SECTION("with a zone") {
        state.parameters.set(ParameterId::mpe, 1);
        state.parameters.set(ParameterId::mpeBendRange, 12);
    }
    Instance configured(state), fresh(state);
    juce::MidiBuffer setup;
    give(setup, 1, zone, 6);
    give(setup, 16, zone, 6);
    give(setup, 2, bendRange, 24);
    give(setup, 10, bendRange, 24);
    configured.send(setup);
    configured.send({});
    restore(configured.processor, state);
    for (auto* each : {&configured, &fresh})
        each->send({});
    CHECK(configured.value(ParameterId::mpe) == state.parameters[ParameterId::mpe]);
    CHECK(configured.playBent() == fresh.playBent());
}

TEST_CASE("Zones and bend ranges that no parameter can hold are kept until a parameter moves") {
    Instance atOnce(testState()), later(testState());
    juce::MidiBuffer setup;
    give(setup, 1, zone, 6);
    give(setup, 16, zone, 4);
    give(setup, 2, bendRange, 24);
    setup.addEvent(juce::MidiMessage::controllerEvent(2, 38, 30), 0);
    auto notes = setup;
    notes.addEvents(bentNotes(), 0, blockSize, 0);
    later.send(setup);
    for (int block = 0; block < 10; ++block)
        later.send({});
    later.send({});
    for (int block = 0; block < 4; ++block) // up to a grid point, like the other processor
        atOnce.send({});
    CHECK(render(atOnce.processor, 9600, blockSize, notes) == later.playBent());
}
