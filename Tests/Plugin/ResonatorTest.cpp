// Tests the effect, and the side chain of the instrument's VST3.
#include "Plugin/FactoryPrograms.h"
#include "Plugin/Vst3Instrument.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

using Set = juce::AudioChannelSet;

bool supports(Processor& processor, const Set& input, const Set& output) {
    auto layout = processor.getBusesLayout();
    layout.inputBuses.getReference(0) = input;
    layout.outputBuses.getReference(0) = output;
    return processor.isBusesLayoutSupported(layout);
}

juce::AudioBuffer<float> noise(int channels, int samples) {
    juce::AudioBuffer<float> buffer(channels, samples);
    juce::Random random(4);
    for (int channel = 0; channel < channels; ++channel)
        for (int k = 0; k < samples; ++k)
            buffer.setSample(channel, k, 0.2f * random.nextFloat() - 0.1f);
    return buffer;
}

float peakAfter(Processor& processor, juce::AudioBuffer<float>& buffer) {
    juce::MidiBuffer midi;
    processor.processBlock(buffer, midi);
    return buffer.getMagnitude(0, buffer.getNumSamples());
}

} // namespace

TEST_CASE("The resonator takes and gives mono or stereo") {
    Processor resonator(PluginKind::resonator);
    CHECK(resonator.getName() == "Idiophone Resonator");
    CHECK(resonator.getLatencySamples() == 0);
    for (const auto& input : {Set::mono(), Set::stereo()})
        for (const auto& output : {Set::mono(), Set::stereo()})
            CHECK(supports(resonator, input, output));
    CHECK_FALSE(supports(resonator, Set::disabled(), Set::stereo()));
    CHECK_FALSE(supports(resonator, Set::create5point1(), Set::stereo()));
    CHECK(resonator.getVST3ClientExtensions()->getPluginHasMainInput());
}

TEST_CASE("Sound in drives the resonator's object, and silence gives silence") {
    Processor resonator(PluginKind::resonator);
    restore(resonator, testState());
    resonator.prepareToPlay(48000, 512);
    juce::AudioBuffer<float> silence(2, 512);
    silence.clear();
    CHECK(peakAfter(resonator, silence) == 0);
    auto sound = noise(2, 5000); // longer than a piece of the engine
    const auto before = sound;
    CHECK(peakAfter(resonator, sound) > 0);
    CHECK(sound.getSample(0, 4000) != before.getSample(0, 4000));
    CHECK(peakAfter(resonator, silence) > 0);
}

TEST_CASE("The resonator mixes what comes in with what comes out, and bypass lets it pass") {
    const bool isMono = GENERATE(false, true);
    Processor resonator(PluginKind::resonator);
    restore(resonator, testState());
    auto& parameters = resonator.parameters();
    auto layout = resonator.getBusesLayout();
    layout.inputBuses.getReference(0) = isMono ? Set::mono() : Set::stereo();
    REQUIRE(resonator.setBusesLayout(layout));
    SECTION("dry") {
        parameters[ParameterId::dryWet].setValueNotifyingHost(0);
    }
    SECTION("bypassed") {
        parameters[ParameterId::bypass].setValueNotifyingHost(1);
    }
    resonator.prepareToPlay(48000, 512);
    auto sound = noise(2, 512);
    const auto before = sound;
    peakAfter(resonator, sound);
    for (int k = 0; k < 512; ++k) {
        REQUIRE(sound.getSample(0, k) == before.getSample(0, k));
        REQUIRE(sound.getSample(1, k) == before.getSample(isMono ? 0 : 1, k));
    }
}

TEST_CASE("A stage does not hear what comes in") {
    Processor resonator(PluginKind::resonator);
    resonator.setCurrentProgram(factoryProgram(factoryPresetId("Falling Rings")));
    resonator.prepareToPlay(48000, 512);
    for (int block = 0; block < 4; ++block) {
        auto sound = noise(2, 512);
        CHECK(peakAfter(resonator, sound) == 0);
    }
}

TEST_CASE("An instrument's VST3 has a side chain, closed at first, which drives but is not heard") {
    CHECK(Processor().getBusCount(true) == 0);
    Vst3Instrument vst3;
    auto& instrument = *vst3.processor;
    CHECK_FALSE(instrument.getVST3ClientExtensions()->getPluginHasMainInput());
    REQUIRE(instrument.getBusCount(true) == 1);
    CHECK_FALSE(instrument.getBus(true, 0)->isEnabled());
    CHECK(supports(instrument, Set::disabled(), Set::stereo()));
    CHECK(supports(instrument, Set::mono(), Set::mono()));

    restore(instrument, testState());
    instrument.prepareToPlay(48000, 512);
    auto closed = noise(2, 512); // what a host leaves in the buffer
    CHECK(peakAfter(instrument, closed) == 0);
    instrument.releaseResources();
    REQUIRE(instrument.getBus(true, 0)->enable(true));
    instrument.prepareToPlay(48000, 512);
    auto sound = noise(2, 512);
    const auto before = sound;
    CHECK(peakAfter(instrument, sound) > 0);
    instrument.parameters()[ParameterId::bypass].setValueNotifyingHost(1);
    for (int block = 0; block < 4; ++block) {
        sound = before;
        peakAfter(instrument, sound);
    }
    CHECK(sound.getMagnitude(0, 512) == 0);
}
