// Rendering does not depend on the host's block sizes, sample rates and bus layouts.
#include "Instrument/FactoryContent.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr int songSamples = 24000;

HostSound renderedSong(int blockSize, bool offline = false, double rateHz = 48000) {
    Processor processor;
    restore(processor, testState());
    processor.setNonRealtime(offline);
    processor.prepareToPlay(rateHz, blockSize);
    return render(processor, songSamples, blockSize, testMusic(songSamples));
}

} // namespace

TEST_CASE("Renders are bit-identical for block sizes 1, 7, 64, 480 and 4096") {
    const auto expected = renderedSong(64);
    REQUIRE(loudest(expected) > 0.01f);
    REQUIRE(loudest(expected) < 100);
    for (const int blockSize : {1, 7, 480, 4096})
        CHECK(renderedSong(blockSize) == expected);
}

TEST_CASE("Renders are bit-identical in real time and offline") {
    CHECK(renderedSong(480, true) == renderedSong(480, false));
}

TEST_CASE("A bounce of every factory preset except scenes equals its real-time sound") {
    const auto presets = factoryPresets(); // scenes are tested in StageInProcessorTest
    for (std::size_t program = 0; program < presets.size(); ++program) {
        INFO(presets[program].name);
        const auto sound = [&](bool offline) {
            Processor processor;
            processor.setCurrentProgram(static_cast<int>(program));
            processor.setNonRealtime(offline);
            processor.prepareToPlay(48000, 480);
            return render(processor, 14400, 480,
                          testMusic(14400, 701, processor.view().instrument.keyRange()));
        };
        if (presets[program].keyMap.kind == KeyMapKind::scene)
            continue;
        const auto heard = sound(false);
        CHECK(loudest(heard) > 0.001f);
        CHECK((heard == sound(true)));
    }
}

TEST_CASE("At every sample rate from 8 to 384 kHz the output sounds and is finite") {
    for (const double rateHz : {8000, 11025, 22050, 44100, 48000, 88200, 96000, 192000, 384000}) {
        const auto output = renderedSong(512, false, rateHz);
        INFO(rateHz << " Hz");
        CHECK(allFinite(output));
        CHECK(loudest(output) > 0.01f);
    }
}

TEST_CASE("Blocks of changing size, also larger than prepared, render the same") {
    const auto expected = renderedSong(64);
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 32);
    const auto midi = testMusic(songSamples);
    HostSound output;
    int size = 1;
    for (int start = 0; start < songSamples;) {
        size = (size * 7 + 13) % 9000;
        const int count = std::min(size, songSamples - start);
        juce::AudioBuffer<float> buffer(2, count);
        juce::MidiBuffer block;
        block.addEvents(midi, start, count, -start);
        processor.processBlock(buffer, block);
        output.append(buffer);
        start += count;
    }
    CHECK(output == expected);
}

TEST_CASE("Without radiation mono and both channels of stereo are the same") {
    const auto expected = renderedSong(480);
    Processor mono;
    restore(mono, testState());
    juce::AudioProcessor::BusesLayout layout;
    layout.outputBuses.add(juce::AudioChannelSet::mono());
    REQUIRE(mono.setBusesLayout(layout));
    mono.prepareToPlay(48000, 480);
    CHECK(render(mono, songSamples, 480, testMusic(songSamples), 1).left == expected.left);

    CHECK(expected.left == expected.right);
}

TEST_CASE("A mono bus gets the mean of both stereo channels") {
    const auto play = [](const juce::AudioChannelSet& channels) {
        Processor processor;
        juce::AudioProcessor::BusesLayout layout;
        layout.outputBuses.add(channels);
        REQUIRE(processor.setBusesLayout(layout));
        processor.setCurrentProgram(0);
        processor.view().parameters.change(ParameterId::radiation, 60);
        processor.view().parameters.change(ParameterId::strikeAcross, 80);
        processor.prepareToPlay(48000, 4800);
        juce::AudioBuffer<float> buffer(channels.size(), 4800);
        juce::MidiBuffer midi;
        for (const int note : {72, 81, 97})
            midi.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(120)), note);
        processor.processBlock(buffer, midi);
        return buffer;
    };
    const auto mono = play(juce::AudioChannelSet::mono());
    const auto stereo = play(juce::AudioChannelSet::stereo());
    float mostSide = 0, mostError = 0;
    for (int i = 0; i < mono.getNumSamples(); ++i) {
        const float left = stereo.getSample(0, i), right = stereo.getSample(1, i);
        mostSide = std::max(mostSide, std::abs(left - right) / 2);
        mostError = std::max(mostError, std::abs(mono.getSample(0, i) - (left + right) / 2));
    }
    CHECK(mostSide > 1e-4f);
    CHECK(mostError < 1e-7f);
}

TEST_CASE("A note sounds from its exact sample on") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 1000);
    for (const int stamp : {0, 1, 63, 64, 517, 999}) {
        processor.prepareToPlay(48000, 1000);
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::noteOn(1, 65, static_cast<juce::uint8>(127)), stamp);
        const auto output = render(processor, 1100, 1000, midi).left;
        const auto first =
            std::find_if(output.begin(), output.end(), [](float x) { return x != 0; });
        INFO(stamp);
        // The force pulse begins at zero, so a sample or two may pass before the sound.
        CHECK(std::distance(output.begin(), first) >= stamp);
        CHECK(std::distance(output.begin(), first) <= stamp + 2);
    }
}

TEST_CASE("Events in a block without samples sound in the next block") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 512);
    juce::AudioBuffer<float> nothing(2, 0);
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, 65, static_cast<juce::uint8>(127)), 0);
    processor.processBlock(nothing, midi);
    CHECK(loudest(render(processor, 512, 512, {})) > 0.01f);
}

TEST_CASE("Five thousand events on one sample are all played") {
    // 4999 wheel moves come before the note. The note must sound with the last wheel position.
    juce::MidiBuffer crowded, sparse;
    for (int i = 0; i < 4999; ++i)
        crowded.addEvent(juce::MidiMessage::pitchWheel(1, i), 511);
    sparse.addEvent(juce::MidiMessage::pitchWheel(1, 4998), 511);
    for (auto* midi : {&crowded, &sparse})
        midi->addEvent(juce::MidiMessage::noteOn(1, 65, static_cast<juce::uint8>(127)), 511);
    std::vector<HostSound> outputs;
    for (const auto* midi : {&crowded, &sparse}) {
        Processor processor;
        restore(processor, testState());
        processor.prepareToPlay(48000, 512);
        outputs.push_back(render(processor, 4096, 512, *midi));
    }
    CHECK(loudest(outputs[0]) > 0.01f);
    CHECK(outputs[0] == outputs[1]);
}

TEST_CASE("Automation of every parameter to both ends leaves the output finite") {
    Processor processor; // its channels differ
    processor.prepareToPlay(48000, 256);
    const auto midi = testMusic(256, 64, processor.view().instrument.keyRange());
    std::mt19937 random(5);
    bool finite = true;
    const auto renderBlocks = [&](int blocks) {
        for (int block = 0; block < blocks; ++block)
            finite = finite && allFinite(render(processor, 256, 256, midi)) &&
                     processor.engineReport().notFinite == 0;
    };
    renderBlocks(8);
    const auto sound = render(processor, 256, 256, midi);
    CHECK(loudest(sound) > 0.001f);
    CHECK(sound.left != sound.right);
    for (auto* parameter : processor.getParameters()) {
        INFO(parameter->getName(100));
        for (const float end : {0.0f, 1.0f}) {
            parameter->setValue(end);
            renderBlocks(8);
        }
        parameter->setValue(parameter->getDefaultValue());
        CHECK(finite);
    }
    for (int round = 0; round < 300; ++round) {
        for (auto* parameter : processor.getParameters())
            if (parameter != processor.getBypassParameter())
                parameter->setValue(static_cast<float>(random() % 2));
        renderBlocks(2);
    }
    CHECK(finite);
}

TEST_CASE("In bypass the output is silent, and the sound rings on unheard") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 480);
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, 65, static_cast<juce::uint8>(127)), 0);
    render(processor, 480, 480, midi);
    processor.getBypassParameter()->setValue(1);
    render(processor, 960, 480, {}); // the ramp
    CHECK(loudest(render(processor, 960, 480, {})) == 0);
    processor.getBypassParameter()->setValue(0);
    CHECK(loudest(render(processor, 960, 480, {})) > 0);
}

TEST_CASE("The level parameter acts in decibels") {
    const auto renderAt = [](double decibels) {
        Processor processor;
        auto state = testState();
        state.parameters.set(ParameterId::level, decibels);
        restore(processor, state);
        processor.prepareToPlay(48000, 480);
        return loudest(render(processor, songSamples, 480, testMusic(songSamples)));
    };
    const float ratio = renderAt(-20) / renderAt(0);
    CHECK(std::abs(ratio - 0.1f) < 1e-6f);
}
