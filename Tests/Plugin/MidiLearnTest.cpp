#include "Plugin/MidiLearn.h"

#include "Support/TestSound.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

namespace {

juce::MidiBuffer controllers(std::initializer_list<std::pair<int, int>> numbersAndValues,
                             int channel = 1) {
    juce::MidiBuffer midi;
    int stamp = 0;
    for (const auto& [number, value] : numbersAndValues)
        midi.addEvent(juce::MidiMessage::controllerEvent(channel, number, value), stamp++);
    return midi;
}

void play(Processor& processor, const juce::MidiBuffer& midi) {
    render(processor, 64, 64, midi);
}

} // namespace

TEST_CASE("The next controller on any channel is learned and moves the parameter at once") {
    Processor processor;
    processor.prepareToPlay(48000, 64);
    auto& learn = processor.windowSession().controllers;
    CHECK_FALSE(learn.controllerOf(density));
    learn.learnController(density);
    CHECK(learn.learningParameter() == density);
    play(processor, controllers({{21, 127}}, 5));
    CHECK_FALSE(learn.learningParameter());
    CHECK(learn.controllerOf(density) == 21);
    CHECK(processor.view().parameters.value(density) == parameterInfo(density).maximum);
    play(processor, controllers({{21, 0}}, 16));
    CHECK(processor.view().parameters.value(density) == Approx(parameterInfo(density).minimum));
    play(processor, controllers({{22, 64}}));
    CHECK(processor.view().parameters.value(density) == Approx(parameterInfo(density).minimum));
}

TEST_CASE("A forgotten controller, or one that arrives after learning has stopped, moves nothing") {
    Processor processor;
    processor.prepareToPlay(48000, 64);
    auto& learn = processor.windowSession().controllers;
    learn.learnController(density);
    learn.stopLearning();
    const auto before = processor.view().parameters.value(density);
    play(processor, controllers({{21, 100}}));
    CHECK_FALSE(learn.controllerOf(density));
    CHECK(processor.view().parameters.value(density) == before);
    learn.learnController(density);
    play(processor, controllers({{21, 100}}));
    learn.forgetController(density);
    const auto moved = processor.view().parameters.value(density);
    play(processor, controllers({{21, 0}}));
    CHECK(processor.view().parameters.value(density) == moved);
}

TEST_CASE("Bank selection and channel modes are not learned, because hosts send them unasked") {
    Processor processor;
    processor.prepareToPlay(48000, 64);
    auto& learn = processor.windowSession().controllers;
    learn.learnController(density);
    play(processor, controllers({{0, 1}, {32, 1}, {120, 0}, {121, 0}, {123, 0}, {127, 0}}));
    CHECK(learn.learningParameter() == density);
    CHECK_FALSE(learn.controllerOf(density));
}

TEST_CASE("The last value in a block counts, and one controller moves several parameters") {
    Processor processor;
    processor.prepareToPlay(48000, 64);
    auto& learn = processor.windowSession().controllers;
    learn.learnController(radiation);
    play(processor, controllers({{21, 1}}));
    learn.learnController(width);
    play(processor, controllers({{21, 1}}));
    play(processor, controllers({{21, 3}, {21, 127}, {22, 5}, {21, 64}}));
    CHECK(processor.view().parameters.value(radiation) == Approx(100 * 64 / 127.0));
    CHECK(processor.view().parameters.value(width) == Approx(200 * 64 / 127.0));
}

TEST_CASE("A controller covers all names of a choice and both sides of a switch") {
    const auto last = static_cast<double>(choiceNames(material).size() - 1);
    CHECK(controlledValue(parameterInfo(material), 0) == 0);
    CHECK(controlledValue(parameterInfo(material), 127) == last);
    CHECK(controlledValue(parameterInfo(contact), 64) == double{rollContact});
    CHECK(controlledValue(parameterInfo(letRing), 63) == 0);
    CHECK(controlledValue(parameterInfo(letRing), 64) == 1);
    for (const auto& info : parameterTable())
        for (const int value : {0, 1, 63, 64, 126, 127}) {
            const double result = controlledValue(info, value);
            CHECK(info.clamped(result) == result);
        }
}

TEST_CASE("The sustain pedal can be learned and still sustains") {
    const auto ringsOn = [](bool learned) {
        Processor processor;
        auto state = testState();
        state.parameters.set(letRing, 0);
        state.parameters.set(releaseTime, 0.005);
        restore(processor, state);
        processor.prepareToPlay(48000, 480);
        if (learned)
            processor.windowSession().controllers.learnController(chatter);
        auto midi = controllers({{64, 127}});
        midi.addEvent(juce::MidiMessage::noteOn(1, 60, static_cast<juce::uint8>(100)), 5);
        midi.addEvent(juce::MidiMessage::noteOff(1, 60), 20);
        const auto output = render(processor, 4800, 480, midi).left;
        if (learned)
            CHECK(processor.view().parameters.value(chatter) == 100);
        return loudest({output.end() - 480, output.end()}) > 1e-3f;
    };
    CHECK(ringsOn(false));
    CHECK(ringsOn(true));
}

TEST_CASE("A learned controller sounds like a parameter set before the same block") {
    auto state = testState();
    state.controllers[size] = 21;
    const auto midiValue = 100;
    Processor byController, byHand;
    for (auto* processor : {&byController, &byHand}) {
        restore(*processor, state);
        processor->prepareToPlay(48000, 480);
        render(*processor, 480, 480, testMusic(480, 100));
    }
    byHand.view().parameters.change(size, controlledValue(parameterInfo(size), midiValue));
    auto music = testMusic(480, 90);
    const auto expected = render(byHand, 480, 480, music);
    music.addEvent(juce::MidiMessage::controllerEvent(1, 21, midiValue), 470);
    CHECK(render(byController, 480, 480, music) == expected);
}

TEST_CASE("The message thread sends controller changes to the host, but not offline") {
    struct Listener final : juce::AudioProcessorListener {
        void audioProcessorParameterChanged(juce::AudioProcessor*, int index, float) override {
            heard.push_back(index);
        }
        void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails&) override {}
        std::vector<int> heard;
    } listener;
    Processor processor;
    processor.prepareToPlay(48000, 64);
    processor.addListener(&listener);
    processor.windowSession().controllers.learnController(density);
    processor.setNonRealtime(true);
    play(processor, controllers({{21, 100}}));
    processor.poll();
    CHECK(listener.heard.empty());
    processor.setNonRealtime(false);
    processor.poll();
    processor.removeListener(&listener);
    CHECK(listener.heard == std::vector<int>{static_cast<int>(density)});
    CHECK_FALSE(processor.windowSession().history.canUndo());
}

TEST_CASE("Learned controllers are saved in the state, and a state without them clears them") {
    Processor first;
    first.prepareToPlay(48000, 64);
    first.windowSession().controllers.learnController(tau);
    play(first, controllers({{119, 100}}));
    first.windowSession().controllers.learnController(thickness);
    play(first, controllers({{1, 10}}));
    const auto bytes = saved(first);
    Processor second;
    second.windowSession().controllers.assign([] {
        ControllerAssignments others;
        others[density] = 3;
        return others;
    }());
    restoreBytes(second, bytes);
    CHECK(saved(second) == bytes);
    CHECK(second.windowSession().controllers.controllerOf(tau) == 119);
    CHECK(second.windowSession().controllers.controllerOf(thickness) == 1);
    CHECK_FALSE(second.windowSession().controllers.controllerOf(density));
    restore(second, testState());
    CHECK(second.windowSession().controllers.assignments() == ControllerAssignments{});
    // A preset does not change the learned controllers.
    restoreBytes(second, bytes);
    second.setCurrentProgram(3);
    CHECK(second.windowSession().controllers.controllerOf(tau) == 119);
}

TEST_CASE("Malformed controller messages are ignored") {
    Processor processor;
    processor.prepareToPlay(48000, 64);
    processor.windowSession().controllers.learnController(density);
    juce::MidiBuffer midi;
    const juce::uint8 shortOne[] = {0xb0, 21};
    midi.addEvent(shortOne, 2, 0);
    std::vector<juce::uint8> dump(300, 0x30);
    midi.addEvent(juce::MidiMessage::createSysExMessage(dump.data(), 300), 1);
    play(processor, midi);
    CHECK(processor.windowSession().controllers.learningParameter() == density);
}
