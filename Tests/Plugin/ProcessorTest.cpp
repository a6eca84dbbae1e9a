// Host requests to the processor: buses, programs, tail, resets and shared objects.

#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Support/GestureLog.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>
#include <numeric>
#include <optional>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

juce::MidiBuffer oneMessage(const juce::MidiMessage& message) {
    juce::MidiBuffer midi;
    midi.addEvent(message, 0);
    return midi;
}

const auto hardNote = oneMessage(juce::MidiMessage::noteOn(1, 72, static_cast<juce::uint8>(127)));

/// Returns a state with a long room, in which the fluid damping decides how long keys ring.
State inLongRoom(double fluidDampingPerSecond) {
    auto state = testState();
    state.parameters.set(ParameterId::strikeSpread, 0);
    state.parameters.set(ParameterId::material, customMaterial);
    state.parameters.set(ParameterId::fluidDamping, fluidDampingPerSecond);
    state.parameters.set(ParameterId::room, 100);
    state.parameters.set(ParameterId::roomDecay, 10);
    return state;
}

bool supports(std::initializer_list<juce::AudioChannelSet> inputs,
              std::initializer_list<juce::AudioChannelSet> outputs) {
    Processor processor;
    juce::AudioProcessor::BusesLayout layout;
    for (const auto& set : inputs)
        layout.inputBuses.add(set);
    for (const auto& set : outputs)
        layout.outputBuses.add(set);
    return processor.isBusesLayoutSupported(layout);
}

} // namespace

TEST_CASE("The processor supports one mono or stereo output and no input") {
    using Set = juce::AudioChannelSet;
    CHECK(supports({}, {Set::mono()}));
    CHECK(supports({}, {Set::stereo()}));
    CHECK_FALSE(supports({}, {}));
    CHECK_FALSE(supports({}, {Set::disabled()}));
    CHECK_FALSE(supports({}, {Set::create5point1()}));
    CHECK_FALSE(supports({}, {Set::stereo(), Set::stereo()}));
    CHECK_FALSE(supports({Set::stereo()}, {Set::stereo()}));
}

TEST_CASE("The processor takes MIDI, sends none, has no latency and works in single precision") {
    Processor processor;
    CHECK(processor.acceptsMidi());
    CHECK_FALSE(processor.producesMidi());
    CHECK_FALSE(processor.isMidiEffect());
    CHECK(processor.getLatencySamples() == 0);
    CHECK_FALSE(processor.supportsDoublePrecisionProcessing());
}

TEST_CASE("Every factory preset is a program that has a name and sounds") {
    Processor processor;
    REQUIRE(processor.getNumPrograms() == static_cast<int>(factoryPresets().size()));
    processor.setNonRealtime(true); // waits for the bodies of a scene
    processor.prepareToPlay(48000, 512);
    for (int program = 0; program < processor.getNumPrograms(); ++program) {
        INFO(processor.getProgramName(program));
        CHECK(processor.getProgramName(program).isNotEmpty());
        processor.setCurrentProgram(program);
        CHECK(processor.getCurrentProgram() == program);
        const auto status = processor.view().status.takeStatus();
        CHECK_FALSE(status.isError);
        const auto delay = static_cast<int>((status.delaySeconds + 0.3) * 48000);
        const auto output =
            render(processor, status.delaySeconds > 0 ? delay : 4800, 480, hardNote);
        CHECK(loudest(output) > 0.001f);
        CHECK(allFinite(output));
        CHECK(processor.engineReport().notFinite == 0);
    }
    CHECK(processor.getProgramName(-1).isEmpty());
    CHECK(processor.getProgramName(1000).isEmpty());
    processor.setCurrentProgram(-1);
    processor.setCurrentProgram(1000);
    CHECK(processor.getCurrentProgram() == processor.getNumPrograms() - 1);
}

TEST_CASE("A new instance plays the first factory preset") {
    Processor processor;
    CHECK(processor.getCurrentProgram() == 0);
    CHECK(processor.view().presets.playingPreset().id == factoryPresetId(factoryPresets()[0].name));
    CHECK_FALSE(processor.view().status.takeStatus().isError);
    processor.prepareToPlay(44100, 512);
    CHECK(loudest(render(processor, 4096, 512, hardNote)) > 0.001f);
}

TEST_CASE("A program sets every parameter except bypass, concert pitch and MPE") {
    Processor processor;
    for (auto* parameter : processor.getParameters())
        parameter->setValue(1);
    processor.setCurrentProgram(1);
    for (const auto& info : parameterTable()) {
        INFO(info.id);
        const double expected =
            info.isSetup ? info.maximum : factoryPresets()[1].parameters[info.parameter];
        CHECK(processor.view().parameters.value(info.parameter) == expected);
    }
}

TEST_CASE("In real time the message thread loads a program that MIDI asks for") {
    Processor processor;
    processor.prepareToPlay(48000, 512);
    render(processor, 512, 512, oneMessage(juce::MidiMessage::programChange(1, 2)));
    CHECK(processor.getCurrentProgram() == 0);
    processor.poll();
    CHECK(processor.getCurrentProgram() == 2);
    render(processor, 512, 512, oneMessage(juce::MidiMessage::programChange(1, 127)));
    processor.poll();
    CHECK(processor.getCurrentProgram() == 2);
}

TEST_CASE("In an offline render a MIDI program change takes effect from the next block on") {
    Processor processor;
    processor.setNonRealtime(true);
    processor.prepareToPlay(48000, 512);
    render(processor, 512, 512, oneMessage(juce::MidiMessage::programChange(1, 2)));
    CHECK(processor.getCurrentProgram() == 2);
}

TEST_CASE("A preset change while notes ring makes no step larger than the sound's own") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 480);
    const auto largestStep = [](const std::vector<float>& samples) {
        float step = 0;
        for (std::size_t i = 1; i < samples.size(); ++i)
            step = std::max(step, std::abs(samples[i] - samples[i - 1]));
        return step;
    };
    auto before = render(processor, 9600, 480,
                         oneMessage(juce::MidiMessage::noteOn(1, 60, static_cast<juce::uint8>(90))))
                      .left;
    before.erase(before.begin(), before.end() - 480);
    restore(processor, testState("other", 1.3));
    auto after = render(processor, 960, 480, {}).left;
    CHECK(loudest({after.end() - 480, after.end()}) == 0);
    const float natural = largestStep(before);
    after.insert(after.begin(), before.back());
    CHECK(largestStep(after) <= 1.05f * natural);
}

TEST_CASE("Instances share the objects they play") {
    Processor first, second;
    const auto a = first.soundSession().instrument(), b = second.soundSession().instrument();
    REQUIRE(a != nullptr);
    REQUIRE(b != nullptr);
    REQUIRE(a->slots().size() == b->slots().size());
    for (std::size_t slot = 0; slot < a->slots().size(); ++slot)
        CHECK(a->slots()[slot].object == b->slots()[slot].object);
}

TEST_CASE("A reset silences the next block, and the same notes sound the same again") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 480);
    const auto first = render(processor, 9600, 480, testMusic(9600));
    processor.reset();
    const auto again = render(processor, 9600, 480, testMusic(9600));
    CHECK(again == first);
    processor.reset();
    CHECK(loudest(render(processor, 480, 480, {})) == 0);
}

TEST_CASE("Another preparation, in any order and at any rate, starts from silence") {
    Processor processor;
    restore(processor, testState());
    processor.releaseResources();
    processor.reset();
    juce::AudioBuffer<float> buffer(2, 64);
    juce::MidiBuffer none;
    processor.processBlock(buffer, none); // never prepared
    CHECK(buffer.getMagnitude(0, 64) == 0);
    for (const double rateHz : {48000.0, 8000.0, 384000.0, 44100.0, 44100.0}) {
        processor.prepareToPlay(rateHz, 64);
        processor.prepareToPlay(rateHz, 8192);
        CHECK(loudest(render(processor, 64, 64, {})) == 0);
        CHECK(loudest(render(processor, 2400, 480, testMusic(2400, 100))) > 0.001f);
        processor.releaseResources();
        processor.releaseResources();
    }
}

TEST_CASE("The tail is that of the slowest possible mode and is bounded") {
    using enum ParameterId;
    Processor processor;
    auto state = testState();
    // The values match the test objects' own stiffness, so a change moves their lowest mode of
    // 261.6 Hz.
    state.parameters.set(material, customMaterial);
    state.parameters.set(youngsModulus, 10);
    state.parameters.set(density, 1000);
    state.parameters.set(fluidDamping, 10);
    state.parameters.set(viscoelasticDamping, 2);
    state.parameters.set(lossFactor, 0);
    state.parameters.set(bendRange, 12);
    state.parameters.set(keepPitch, 0);
    const auto tail = [&] {
        restore(processor, state);
        return processor.getTailLengthSeconds();
    };
    // γ/2, plus the share of η at the lowest mode bent down by an octave.
    const double omega = std::numbers::pi * 440 * std::exp2(-9 / 12.0);
    CHECK_THAT(tail(), WithinRel(std::log(65536) / (5 + 1e-6 * omega * omega), 1e-12));
    for (const auto parameter : {fluidDamping, viscoelasticDamping})
        state.parameters.set(parameter, parameterInfo(parameter).minimum);
    CHECK(tail() == TailLength::maximumSeconds);
    // Damping at the minimum values, plus χω/2 of a loss factor.
    const auto rayleigh = [](double frequency) {
        return parameterInfo(fluidDamping).minimum / 2 +
               parameterInfo(viscoelasticDamping).minimum * 1e-6 * frequency * frequency / 2;
    };
    const auto seconds = [&](double frequency) {
        return std::log(65536) / (rayleigh(frequency) + 0.005 * frequency);
    };
    state.parameters.set(lossFactor, 0.01);
    CHECK_THAT(tail(), WithinRel(seconds(omega), 1e-12));
    // A lower mode has a longer tail: by size, pitch, material or MPE bends.
    state.parameters.set(size, 2);
    CHECK_THAT(tail(), WithinRel(seconds(omega / 2), 1e-12));
    state.parameters.set(size, 1);
    state.parameters.set(tune, -1200);
    CHECK_THAT(tail(), WithinRel(seconds(omega / 2), 1e-12));
    state.parameters.set(tune, 0);
    state.parameters.set(density, 4000);
    CHECK_THAT(tail(), WithinRel(seconds(omega / 2), 1e-12));
    state.parameters.set(density, 1000);
    state.parameters.set(mpe, 1);
    state.parameters.set(mpeBendRange, 12);
    CHECK_THAT(tail(), WithinRel(seconds(omega / 2), 1e-12));
    state.parameters.set(mpe, 0);
    // Modes below 20 Hz do not sound.
    state.parameters.set(size, 10);
    state.parameters.set(tune, -1200);
    CHECK_THAT(tail(), WithinRel(seconds(40 * std::numbers::pi), 1e-12));
    state.parameters.set(size, 1);
    state.parameters.set(tune, 0);
    // The objects' own material has γ = 5/s and η = 1e-8 s.
    state.parameters.set(material, ownMaterial);
    CHECK_THAT(tail(), WithinRel(std::log(65536) / (2.5 + 0.5e-8 * omega * omega), 1e-12));
    // A kept pitch keeps its tail at any size.
    const double own = tail();
    state.parameters.set(keepPitch, 1);
    state.parameters.set(size, 4);
    CHECK_THAT(tail(), WithinRel(own, 1e-5)); // except for the shift of the damped frequency
    state.parameters.set(keepPitch, 0);
    state.parameters.set(size, 1);
    CHECK(tail() == own);
    // A room adds its decay over 96 dB, where the parameter is the decay over 60 dB.
    const double dry = processor.getTailLengthSeconds();
    state.parameters.set(room, 10);
    state.parameters.set(roomDecay, 2);
    restore(processor, state);
    CHECK_THAT(processor.getTailLengthSeconds(), WithinRel(dry + 2 * std::log10(65536) / 3, 1e-12));
}

TEST_CASE("Nothing is louder than a 16-bit step after the tail, also in a room") {
    for (const double percent : {0.0, 100.0}) {
        Processor processor;
        auto state = testState();
        state.parameters.set(ParameterId::material, customMaterial);
        state.parameters.set(ParameterId::fluidDamping, 20);
        state.parameters.set(ParameterId::room, percent);
        state.parameters.set(ParameterId::roomDecay, 3);
        restore(processor, state);
        processor.prepareToPlay(48000, 480);
        const auto played = render(processor, 480, 480, hardNote);
        const int tail = static_cast<int>(std::ceil(processor.getTailLengthSeconds() * 48000));
        render(processor, tail, 480, {});
        CHECK(loudest(render(processor, 4800, 480, {})) < loudest(played) / 65536);
    }
}

TEST_CASE("All Sound Off silences the room too, and later notes sound in the room") {
    Processor processor;
    restore(processor, inLongRoom(20));
    processor.prepareToPlay(48000, 480);
    const auto played = render(processor, 9600, 480, hardNote);
    juce::MidiBuffer off;
    off.addEvent(juce::MidiMessage::allSoundOff(1), 0);
    render(processor, 4800, 480, off);
    CHECK(loudest(render(processor, 4800, 480, {})) < loudest(played) / 1000);
    render(processor, 9600, 480, hardNote);
    render(processor, 48000, 480, {});
    CHECK(loudest(render(processor, 4800, 480, {})) > loudest(played) / 1000);
}

TEST_CASE("The room does not respond to sound that fades after All Sound Off") {
    const auto tail = [](const juce::MidiBuffer& before) {
        Processor processor;
        restore(processor, inLongRoom(200));
        processor.prepareToPlay(48000, 480);
        render(processor, 480, 480, before);
        auto midi = oneMessage(juce::MidiMessage::allSoundOff(1));
        midi.addEvent(juce::MidiMessage::noteOn(1, 64, static_cast<juce::uint8>(5)), 900);
        render(processor, 9600, 4800, midi);
        return loudest(render(processor, 9600, 480, {}));
    };
    const float alone = tail({});
    CHECK(alone > 0);
    CHECK_THAT(tail(hardNote) / alone, WithinRel(1, 0.1));
}

TEST_CASE("A note at or soon after All Sound Off gets the room's full response") {
    const auto sound = [](std::optional<int> offAt) {
        Processor processor;
        restore(processor, inLongRoom(200));
        processor.prepareToPlay(48000, 480);
        if (offAt) // otherwise nothing rings
            render(processor, 9600, 480, hardNote);
        juce::MidiBuffer midi;
        if (offAt)
            midi.addEvent(juce::MidiMessage::allSoundOff(1), *offAt);
        midi.addEvent(juce::MidiMessage::noteOn(1, 64, static_cast<juce::uint8>(100)), 1000);
        return render(processor, 48000, 480, midi);
    };
    const auto tailPower = [](const HostSound& heard) {
        return std::inner_product(heard.left.begin() + 12000, heard.left.end(),
                                  heard.left.begin() + 12000, 0.0);
    };
    const double alone = tailPower(sound({}));
    REQUIRE(alone > 0);
    for (const int offAt : {1000, 999, 700, 40})
        CHECK_THAT(10 * std::log10(tailPower(sound(offAt)) / alone), WithinAbs(0, 1));
}

TEST_CASE("All Sound Off in a room sounds the same at all block sizes") {
    juce::MidiBuffer midi;
    for (const int stamp : {0, 5000, 9600})
        midi.addEvent(juce::MidiMessage::noteOn(1, 64, static_cast<juce::uint8>(100)), stamp);
    for (const int stamp : {4711, 9600, 9901, 14000})
        for (const int channel : {1, 2, 16})
            midi.addEvent(juce::MidiMessage::allSoundOff(channel), stamp);
    midi.addEvent(juce::MidiMessage::noteOn(1, 66, static_cast<juce::uint8>(100)), 9901);
    const auto played = [&](int blockSize) {
        Processor processor;
        restore(processor, inLongRoom(200));
        processor.prepareToPlay(48000, blockSize);
        return render(processor, 19200, blockSize, midi);
    };
    const auto expected = played(64);
    REQUIRE(loudest(expected) > 0.001f);
    for (const int blockSize : {1, 7, 300, 800, 4096})
        CHECK(played(blockSize) == expected);
}

TEST_CASE("Blocks before the first preparation are silent for every sound") {
    const auto firstBlocks = [](Processor& processor) {
        for (int block = 0; block < 3; ++block) {
            juce::AudioBuffer<float> buffer(2, 3000);
            for (int channel = 0; channel < 2; ++channel)
                std::fill_n(buffer.getWritePointer(channel), 3000, 1.0f);
            auto midi = hardNote;
            processor.reset();
            processor.processBlock(buffer, midi);
            REQUIRE(buffer.getMagnitude(0, 3000) == 0);
            REQUIRE(midi.isEmpty());
        }
    };
    Processor factory;
    for (int program = 0; program < static_cast<int>(factoryPresets().size()); ++program) {
        factory.setCurrentProgram(program);
        CAPTURE(factory.getProgramName(program));
        firstBlocks(factory);
    }
    Processor restored;
    auto state = testState();
    state.parameters.set(ParameterId::room, 50);
    restore(restored, state);
    firstBlocks(restored);
    restored.prepareToPlay(48000, 480);
    CHECK(loudest(render(restored, 480, 480, {})) == 0);
    CHECK(loudest(render(restored, 9600, 480, hardNote)) > 0.001f);
    // releaseResources keeps the resources.
    restored.releaseResources();
    CHECK(loudest(render(restored, 9600, 480, hardNote)) > 0.001f);
}

TEST_CASE("Notes of the on-screen keyboard sound") {
    Processor processor;
    processor.prepareToPlay(48000, 480);
    processor.view().instrument.playNote(72, 127);
    CHECK(loudest(render(processor, 4800, 480, {})) > 0.001f);
    CHECK(processor.view().status.takeStatus().peak > 0.001f);
}

TEST_CASE("A change in the window is sent to the host as one gesture with the exact value") {
    GestureLog listener;
    Processor processor;
    processor.addListener(&listener);
    processor.view().parameters.beginChange(ParameterId::density);
    processor.view().parameters.change(ParameterId::density, 1000.1);
    processor.view().parameters.endChange(ParameterId::density);
    processor.removeListener(&listener);
    CHECK(listener.text == "(=)");
    CHECK(processor.view().parameters.value(ParameterId::density) == 1000.1);
}
