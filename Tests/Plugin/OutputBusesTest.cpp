// Tests the further outputs of the instrument's VST3, as a host switches them on.
#include "Plugin/OutputBuses.h"
#include "Plugin/FactoryPrograms.h"
#include "Plugin/RealTimeTrap.h"
#include "Plugin/Vst3Instrument.h"
#include "Support/TestSound.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <initializer_list>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

using Set = juce::AudioChannelSet;
constexpr int samples = 6000;
const auto all = OutputSet().set();

/// Keys 60 to 67 are on the outputs from the main one on, if each output is open.
State byKey(const std::string& folder = "test") {
    auto state = testState(folder);
    state.parameters.set(outputs, outputsByKey);
    state.parameters.set(limiter, 0);
    return state;
}

/// A host of the VST3 with some outputs switched on.
struct Host : Vst3Instrument {
    explicit Host(OutputSet open, const State& state = byKey(), Set main = Set::stereo()) {
        auto layout = processor->getBusesLayout();
        layout.outputBuses.getReference(0) = main;
        for (std::size_t bus = 1; bus < maximumOutputs; ++bus)
            layout.outputBuses.getReference(static_cast<int>(bus)) =
                open[bus] ? Set::stereo() : Set::disabled();
        REQUIRE(processor->setBusesLayout(layout));
        restore(*processor, state);
        processor->prepareToPlay(48000, samples);
    }

    /// Returns the sound of each bus; nothing of a closed one.
    std::vector<HostSound> play(const juce::MidiBuffer& midi, int blockSize = samples) {
        std::vector<HostSound> sounds(maximumOutputs);
        for (int start = 0; start < samples; start += blockSize) {
            const int count = std::min(blockSize, samples - start);
            juce::AudioBuffer<float> buffer(processor->getTotalNumOutputChannels(), count);
            for (int channel = 0; channel < buffer.getNumChannels(); ++channel)
                std::fill_n(buffer.getWritePointer(channel), count, 0.7f); // hosts leave anything
            juce::MidiBuffer block;
            block.addEvents(midi, start, count, -start);
            processor->processBlock(buffer, block);
            for (int bus = 0; bus < processor->getBusCount(false); ++bus)
                if (auto view = processor->getBusBuffer(buffer, false, bus);
                    view.getNumChannels() > 0)
                    sounds[static_cast<std::size_t>(bus)].append(view);
        }
        return sounds;
    }
};

juce::MidiBuffer struck(std::initializer_list<int> notes) {
    juce::MidiBuffer midi;
    for (const int note : notes)
        midi.addEvent(juce::MidiMessage::noteOn(1, note, juce::uint8{100}), 100);
    return midi;
}

} // namespace

TEST_CASE("An instrument's VST3 has seven further stereo outputs, closed at first") {
    CHECK(Processor().getBusCount(false) == 1);
    CHECK(Processor(PluginKind::resonator).getBusCount(false) == 1);
    Vst3Instrument vst3;
    auto& instrument = *vst3.processor;
    REQUIRE(instrument.getBusCount(false) == 8);
    CHECK(instrument.getTotalNumOutputChannels() == 2);
    for (int bus = 1; bus < 8; ++bus)
        CHECK(instrument.getBus(false, bus)->getName() == "Out " + juce::String(bus + 1));
    auto layout = instrument.getBusesLayout();
    for (const int bus : {7, 2, 4}) {
        layout.outputBuses.getReference(bus) = Set::stereo();
        CHECK(instrument.isBusesLayoutSupported(layout));
    }
    layout.outputBuses.getReference(2) = Set::mono();
    CHECK_FALSE(instrument.isBusesLayoutSupported(layout));
}

TEST_CASE("A key sounds on its output if the host has it on, otherwise on the main one") {
    Host some(OutputSet().set(1).set(3));
    auto sounds = some.play(struck({61}));
    CHECK(loudest(sounds[0]) == 0);
    CHECK(loudest(sounds[1]) > 0);
    CHECK(loudest(sounds[3]) == 0);
    CHECK(sounds[2].left.empty());
    some.processor->reset();
    sounds = some.play(struck({62}));
    CHECK(loudest(sounds[0]) > 0);
    CHECK(loudest(sounds[1]) == 0);

    some.processor->releaseResources();
    REQUIRE(some.processor->getBus(false, 1)->enable(false));
    some.processor->prepareToPlay(48000, samples);
    sounds = some.play(struck({61, 63}));
    CHECK(loudest(sounds[0]) > 0);
    CHECK(sounds[1].left.empty());
    CHECK(loudest(sounds[3]) > 0);
}

TEST_CASE("The outputs add up to the main one alone, which plays the same bits as any format") {
    const auto music = testMusic(samples, 211);
    Processor plain;
    restore(plain, byKey());
    plain.prepareToPlay(48000, samples);
    const auto expected = render(plain, samples, samples, music);
    CHECK(Host(1).play(music).front() == expected);
    auto mainOnly = byKey();
    mainOnly.parameters.set(outputs, mainOutput);
    const auto unused = Host(all, mainOnly).play(music);
    CHECK(unused.front() == expected);
    CHECK(loudest(unused[5]) == 0);

    const auto sounds = Host(all).play(music);
    const auto monoMain = Host(all, byKey(), Set::mono()).play(music);
    for (int i = 0; i < samples; ++i) {
        const auto at = static_cast<std::size_t>(i);
        float left = 0, right = 0;
        for (const auto& sound : sounds) {
            left += sound.left[at];
            right += sound.right[at];
        }
        REQUIRE(std::abs(left - expected.left[at]) < 1e-5f * loudest(expected));
        REQUIRE(std::abs(right - expected.right[at]) < 1e-5f * loudest(expected));
        REQUIRE(std::abs(monoMain[0].left[at] - sounds[0].left[at]) < 1e-6f);
    }
    for (const auto& sound : sounds)
        CHECK(loudest(sound) > 0);
    CHECK(monoMain[3] == sounds[3]);
}

TEST_CASE("Eight outputs with room, brightness and limiter are the same bits in all blocks") {
    auto state = byKey();
    state.parameters.set(room, 40);
    state.parameters.set(brightness, 50);
    state.parameters.set(limiter, 1);
    state.parameters.set(level, 24);
    const auto music = testMusic(samples, 211);
    const auto expected = Host(all, state).play(music, 512);
    CHECK(loudest(expected[6]) > 0);
    for (const int blockSize : {1, 37, 1024, samples}) {
        INFO("blocks of " << blockSize);
        CHECK(Host(all, state).play(music, blockSize) == expected);
    }
}

TEST_CASE("When the sound changes, what rings fades on its output within 5 ms") {
    Host host(OutputSet().set(1));
    const auto ringing = host.play(struck({61}))[1];
    restore(*host.processor, byKey("other"));
    const auto after = host.play({})[1];
    const auto fadeSamples = static_cast<std::size_t>(PlayerCrossfade::fadeSeconds * 48000);
    CHECK(loudest({after.left.begin(), after.left.begin() + 48}) > loudest(ringing) / 50);
    CHECK(loudest({after.left.begin() + static_cast<std::ptrdiff_t>(fadeSamples),
                   after.left.end()}) == 0);
}

TEST_CASE("The choice of outputs is saved with the project, and programs keep it") {
    Vst3Instrument first, second;
    const auto choice = [](const Vst3Instrument& vst3) {
        return static_cast<int>(vst3.processor->parameters()[outputs].exactValue());
    };
    first.processor->parameters()[outputs].setExactValue(outputsByOctave);
    restoreBytes(*second.processor, saved(*first.processor));
    CHECK(choice(second) == outputsByOctave);
    second.processor->setCurrentProgram(2);
    CHECK(choice(second) == outputsByOctave);
}

TEST_CASE("A stage is heard on the main output only") {
    Host host(all);
    auto& processor = *host.processor;
    processor.setNonRealtime(true); // waits for the bodies
    processor.setCurrentProgram(factoryProgram(factoryPresetId("Falling Rings")));
    float loudestMain = 0;
    for (int block = 0; block < 10; ++block) {
        const auto sounds = host.play(block == 0 ? struck({61}) : juce::MidiBuffer());
        loudestMain = std::max(loudestMain, loudest(sounds[0]));
        for (std::size_t bus = 1; bus < maximumOutputs; ++bus)
            CHECK(loudest(sounds[bus]) == 0);
    }
    CHECK(loudestMain > 0);
}

TEST_CASE("Eight outputs never make the callback allocate, lock or call the system") {
    if (!realTimeTrapWorks())
        SKIP("the trap needs Linux with glibc and no sanitizer");
    auto state = byKey();
    state.parameters.set(room, 40);
    Host host(all, state);
    auto& processor = *host.processor;
    juce::AudioBuffer<float> buffer(16, 3000);
    auto music = testMusic(3000, 301);
    music.addEvent(juce::MidiMessage::allSoundOff(1), 2000);
    for (int block = 0; block < 12; ++block) {
        if (block % 4 == 2) // the former sound fades under the new one
            restore(processor, byKey(block % 8 == 2 ? "other" : "test"));
        processor.parameters()[outputs].setExactValue(block % outputChoices);
        auto events = music;
        const auto faults = faultsOf([&] { processor.processBlock(buffer, events); });
        INFO("block " << block << ": first " << faults.first);
        CHECK(faults.none());
    }
    CHECK(buffer.getMagnitude(0, 3000) > 0);
}

TEST_CASE("Output buses clear what they were not prepared for, and sum what sounds") {
    OutputBuses buses;
    buses.prepare(48000, OutputSet().set(2));
    ParameterValues values;
    constexpr std::size_t count = 64;
    const auto memory = buses.memory(count);
    CHECK(connectedOutputs(memory) == OutputSet().set(0).set(2));
    for (const std::size_t output : {0u, 2u}) {
        std::ranges::fill(memory[output].left, output == 0 ? 0.25f : 0.125f);
        std::ranges::fill(memory[output].right, output == 0 ? 0.5f : 0.0f);
    }
    std::vector<std::vector<float>> host(6, std::vector<float>(count, 0.7f));
    std::vector<float*> pointers;
    for (auto& channel : host)
        pointers.push_back(channel.data());
    OutputBuses::Channels channels;
    for (std::size_t output = 0; output < 3; ++output)
        channels[output] = std::span(pointers).subspan(2 * output, 2);
    REQUIRE(buses.process(memory, channels, values));
    CHECK(loudest(host[2]) == 0);
    CHECK(loudest(host[3]) == 0);
    CHECK(host[4] == std::vector<float>(count, 0.125f));
    const auto sum = buses.sum(channels, count);
    REQUIRE(sum.size() == 2);
    CHECK(std::ranges::equal(std::span(sum[0], count), std::vector<float>(count, 0.375f)));
    CHECK(std::ranges::equal(std::span(sum[1], count), std::vector<float>(count, 0.5f)));
    channels.front() = channels.front().first(1);
    CHECK(buses.sum(channels, count)[0][9] == 0.25f + 0.125f / 2);
}
