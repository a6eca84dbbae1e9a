// The tail length that hosts read, compared with the rendered decay.
#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Support/Larger.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <string>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double rateHz = 22050; // the lowest modes ring longest
constexpr int blockSize = 441;

/// Strikes four keys over the whole range and returns the time until the sound stays 96 dB below
/// its peak.
double ringingSeconds(Processor& processor, double longestSeconds) {
    const auto keys = processor.view().instrument.keyRange();
    juce::MidiBuffer midi;
    for (int i = 0; i < 4; ++i)
        midi.addEvent(juce::MidiMessage::noteOn(
                          1, keys.lowest + (keys.highest - keys.lowest) * i / 3, juce::uint8{127}),
                      0);
    float highest = 0;
    double lastHeard = 0;
    for (double seconds = 0; seconds < longestSeconds; seconds += blockSize / rateHz) {
        const float block = loudest(render(processor, blockSize, blockSize, midi));
        midi.clear();
        highest = larger(highest, block);
        if (block > highest / 65536)
            lastHeard = seconds + blockSize / rateHz;
    }
    return lastHeard;
}

} // namespace

TEST_CASE("The tail reported for a factory preset covers its decay and is at most twice as long") {
    for (const std::string name : {"Glockenspiel", "Tubular Bells", "Ammunition Shell", "Marimba",
                                   "Steel Plate", "Glass Bowls"}) {
        CAPTURE(name);
        Processor processor;
        processor.setNonRealtime(true);
        processor.setCurrentProgram(factoryProgram(factoryPresetId(name)));
        // From afar the slowest modes may be faint. A tubular bell's lowest mode has 60 Hz and
        // radiates almost nothing.
        processor.parameters()[ParameterId::radiation].changeByHand(0);
        processor.prepareToPlay(rateHz, blockSize);
        const double reported = processor.getTailLengthSeconds();
        REQUIRE(reported <= 120);
        const double rings = ringingSeconds(processor, reported + 1);
        CAPTURE(reported, rings);
        CHECK(rings > 0.5);
        CHECK(rings <= reported);
        CHECK(reported <= 2 * rings);
    }
}

TEST_CASE("A key that resizes a bar lengthens the tail once the key has been played") {
    Processor processor;
    processor.setCurrentProgram(factoryProgram(factoryPresetId("Glockenspiel")));
    processor.prepareToPlay(rateHz, blockSize);
    const auto play = [&](int note) {
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), 0);
        render(processor, blockSize, blockSize, midi);
        return processor.getTailLengthSeconds();
    };
    const double reported = processor.getTailLengthSeconds();
    CHECK(play(79) == reported);
    CHECK(play(67) > 1.5 * reported); // a constant loss factor makes it twice as long
}

TEST_CASE("A bend range set by MIDI and a tuning that lowers keys lengthen the tail") {
    Processor processor;
    auto state = testState();
    state.parameters.set(ParameterId::material, customMaterial);
    state.parameters.set(ParameterId::lossFactor, 0.01);
    state.parameters.set(ParameterId::fluidDamping, 0);
    state.parameters.set(ParameterId::viscoelasticDamping, 0);
    state.parameters.set(ParameterId::bendRange, 0);
    restore(processor, state); // the smallest fluid damping is not quite 0
    processor.prepareToPlay(48000, 512);
    const double reported = processor.getTailLengthSeconds();
    const auto lengthened = [&] { return processor.getTailLengthSeconds() / reported; };

    juce::MidiBuffer octave;
    for (const auto& [number, value] : {std::pair{101, 0}, {100, 0}, {6, 12}})
        octave.addEvent(juce::MidiMessage::controllerEvent(1, number, value), 0);
    render(processor, 512, 512, octave);
    CHECK(std::abs(lengthened() - 2) < 2e-3);

    state.tuning = {.scale = {.name = "equal.scl", .text = "Equal\n1\n100.0\n"},
                    .mapping = {.name = "low.kbm", .text = "0\n0\n127\n60\n69\n220.0\n0\n"}};
    Processor tuned;
    restore(tuned, state); // before any callback
    CHECK(std::abs(tuned.getTailLengthSeconds() / reported - 2) < 2e-3);
    tuned.prepareToPlay(48000, 512);
    render(tuned, 512, 512, {});
    CHECK(std::abs(tuned.getTailLengthSeconds() / reported - 2) < 2e-3);
}
