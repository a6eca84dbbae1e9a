// Host automation and MIDI controllers that move the same parameter.
#include "Plugin/ListeningHost.h"
#include "Support/GestureLog.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <functional>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// Turns the controller to `value` and returns the parameter's normalised value.
float turned(Processor& processor, const juce::AudioProcessorParameter& parameter, int value) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::controllerEvent(1, 21, value), 0);
    render(processor, testBlockSize, testBlockSize, midi);
    return parameter.getValue();
}

} // namespace

TEST_CASE("A host's late echo of a controller change is ignored") {
    ListeningHost host(ParameterId::density);
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    processor.addListener(&host);
    auto& parameter = *processor.getParameters()[static_cast<int>(ParameterId::density)];
    const auto turn = [&](int value) { return turned(processor, parameter, value); };
    processor.windowSession().controllers.learnController(ParameterId::density);
    const float first = turn(20);
    pollOften(processor);
    REQUIRE(host.heard == std::vector{first});

    const float second = turn(90);
    parameter.setValue(first); // a late echo
    CHECK(parameter.getValue() == second);
    pollOften(processor);
    CHECK(host.heard == std::vector{first, second});
    parameter.setValue(second);
    CHECK(parameter.getValue() == second);

    // A value is an echo only if it was sent and a newer value is unreported.
    for (const float value : {first, second}) {
        parameter.setValue(value);
        CHECK(parameter.getValue() == value);
    }
    turn(60);
    parameter.setValue(0.125f);
    CHECK(parameter.getValue() == 0.125f);
    pollOften(processor);
    CHECK(host.heard == std::vector{first, second}); // the host knows the value that it has set
    turn(20);
    pollOften(processor);
    CHECK(host.heard == std::vector{first, second, first});
    processor.removeListener(&host);
}

TEST_CASE("A controller that moves a parameter held by the mouse leaves that gesture open") {
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    auto& parameter = *processor.getParameters()[static_cast<int>(ParameterId::density)];
    processor.windowSession().controllers.learnController(ParameterId::density);
    turned(processor, parameter, 20);
    pollOften(processor);
    GestureLog host;
    processor.addListener(&host);
    processor.view().parameters.beginChange(ParameterId::density);
    processor.view().parameters.change(ParameterId::density, 1000);
    turned(processor, parameter, 90);
    pollOften(processor);
    CHECK(host.text == "(==");
    processor.view().parameters.endChange(ParameterId::density);
    CHECK(host.text == "(==)");
    turned(processor, parameter, 20);
    pollOften(processor);
    CHECK(host.text == "(==)(=)");
    processor.removeListener(&host);
}

TEST_CASE("Learning or forgetting a controller marks the project as changed in the host") {
    struct Host final : juce::AudioProcessorListener {
        void audioProcessorParameterChanged(juce::AudioProcessor*, int, float) override {}
        void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails& details) override {
            timesChanged += details.nonParameterStateChanged ? 1 : 0;
        }
        int timesChanged = 0;
    } host;
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    processor.addListener(&host);
    auto& parameter = *processor.getParameters()[static_cast<int>(ParameterId::density)];
    processor.windowSession().controllers.learnController(ParameterId::density);
    pollOften(processor);
    CHECK(host.timesChanged == 0);
    turned(processor, parameter, 20);
    pollOften(processor);
    CHECK(host.timesChanged == 1);
    processor.windowSession().controllers.forgetController(ParameterId::density);
    pollOften(processor);
    processor.removeListener(&host);
    CHECK(host.timesChanged == 2);
}

TEST_CASE("Automation during a bounce is never taken for an echo of an earlier controller change") {
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    auto& parameter = *processor.getParameters()[static_cast<int>(ParameterId::density)];
    processor.windowSession().controllers.learnController(ParameterId::density);
    const float sent = turned(processor, parameter, 20);
    pollOften(processor);
    processor.setNonRealtime(true);
    const auto isFollowed = [&](float automated) {
        CHECK(turned(processor, parameter, 90) != automated);
        parameter.setValue(automated);
        CHECK(parameter.getValue() == automated);
    };
    isFollowed(sent);
    isFollowed(sent);
    processor.setCurrentProgram(3);
    isFollowed(parameter.getValue());
}

TEST_CASE(
    "A controller change is not sent to the host if something else has moved the parameter since") {
    ListeningHost host(ParameterId::density);
    Processor processor;
    processor.prepareToPlay(testRateHz, testBlockSize);
    processor.addListener(&host);
    auto& parameter = *processor.getParameters()[static_cast<int>(ParameterId::density)];
    processor.windowSession().controllers.learnController(ParameterId::density);
    const float sent = turned(processor, parameter, 20);
    const double exact = processor.view().parameters.value(ParameterId::density);
    pollOften(processor);
    const auto state = saved(processor);
    const std::function<void()> moves[] = {
        [&] { restoreBytes(processor, state); },
        [&] { processor.view().parameters.change(ParameterId::density, exact); }};
    for (const auto& move : moves) {
        turned(processor, parameter, 90);
        move();
        pollOften(processor);
        CHECK(host.heard.back() == sent);
        CHECK(parameter.getValue() == sent);
    }
    processor.removeListener(&host);
}
