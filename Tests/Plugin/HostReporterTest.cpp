#include "Plugin/HostReporter.h"

#include "Plugin/BareHost.h"

#include <catch2/catch_test_macros.hpp>
#include <map>
#include <pluginterfaces/vst/ivsteditcontroller.h>
#include <stdexcept>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;

namespace {

struct Listener final : juce::AudioProcessorListener {
    void audioProcessorParameterChanged(juce::AudioProcessor*, int, float) override { ++values; }
    void audioProcessorChanged(juce::AudioProcessor*, const ChangeDetails& details) override {
        programs += details.programChanged ? 1 : 0;
        states += details.nonParameterStateChanged ? 1 : 0;
    }
    int values = 0, programs = 0, states = 0;
};

struct Reported {
    Reported() { host.addListener(&heard); }
    BareHost host;
    HostParameters parameters{host};
    HostReporter reporter{host, parameters, [] {}};
    MidiLearn controllers;
    Listener heard;
};

JUCE_BEGIN_IGNORE_WARNINGS_GCC_LIKE("-Wnon-virtual-dtor") // of the VST3 interface
/// A VST3 host that keeps the values that it is sent.
struct Vst3Host final : Steinberg::Vst::IComponentHandler {
    Steinberg::tresult PLUGIN_API beginEdit(Steinberg::Vst::ParamID) override { return 0; }
    Steinberg::tresult PLUGIN_API performEdit(Steinberg::Vst::ParamID id,
                                              Steinberg::Vst::ParamValue value) override {
        values[id] = value;
        return 0;
    }
    Steinberg::tresult PLUGIN_API endEdit(Steinberg::Vst::ParamID) override { return 0; }
    Steinberg::tresult PLUGIN_API restartComponent(Steinberg::int32) override { return 0; }
    Steinberg::tresult PLUGIN_API queryInterface(const Steinberg::TUID, void**) override {
        return Steinberg::kNoInterface;
    }
    Steinberg::uint32 PLUGIN_API addRef() override { return ++references; }
    Steinberg::uint32 PLUGIN_API release() override { return --references; }
    std::map<Steinberg::Vst::ParamID, double> values;
    Steinberg::uint32 references = 1;
};
JUCE_END_IGNORE_WARNINGS_GCC_LIKE

} // namespace

TEST_CASE("An offline VST3 host that chose a program off the message thread knows all its values") {
    Vst3Host vst3;
    Reported reported;
    auto& density = reported.parameters[ParameterId::density];
    density.setExactValue(1234);
    const auto choose = [&](bool isOffline) {
        vst3.values.clear();
        reported.heard.values = 0;
        reported.host.setNonRealtime(isOffline);
        std::thread([&] { reported.reporter.reportChosenProgram(); }).join();
    };
    choose(true);
    CHECK(reported.heard.values == int(parameterCount)); // no handler: another format
    reported.reporter.vst3().setIComponentHandler(&vst3);
    choose(true);
    CHECK(vst3.values.size() == parameterCount);
    CHECK(vst3.values.at(juce::VST3ClientExtensions::convertJuceParameterId(density.paramID)) ==
          density.getValue());
    CHECK(reported.heard.values == 0); // a later report could bring an older value
    choose(false);
    CHECK(vst3.values.empty());
    CHECK(reported.heard.values == int(parameterCount));
    CHECK(vst3.references == 2);
    reported.reporter.vst3().setIComponentHandler(nullptr);
    CHECK(vst3.references == 1);
}

TEST_CASE("A new sound is reported with all values and its program") {
    Reported reported;
    reported.reporter.reportSound();
    CHECK(reported.heard.values == int(parameterCount));
    CHECK(reported.heard.programs == 1);
}

TEST_CASE("Values that move after a report are reported by the next two polls") {
    Reported reported;
    reported.reporter.reportSound();
    reported.heard.values = 0;
    auto& density = reported.parameters[ParameterId::density];
    for (const int expected : {1, 2, 2}) {
        density.setExactValue(density.exactValue() + 100);
        reported.reporter.poll(reported.controllers);
        CHECK(reported.heard.values == expected);
    }
}

TEST_CASE("While a state is restored, and after reports are dropped, polls report no sound") {
    Reported reported;
    reported.reporter.reportSound();
    reported.heard.values = 0;
    auto& density = reported.parameters[ParameterId::density];
    density.setExactValue(1234);
    {
        const HostReporter::Restoring restoring(reported.reporter);
        reported.reporter.poll(reported.controllers);
        CHECK(reported.heard.values == 0);
    }
    reported.reporter.forget();
    reported.reporter.poll(reported.controllers);
    CHECK(reported.heard.values == 0);
}

TEST_CASE("Polls report the sound again after restoring a state has failed with an exception") {
    Reported reported;
    reported.reporter.reportSound();
    reported.heard.values = 0;
    reported.parameters[ParameterId::density].setExactValue(1234);
    const auto restore = [&] {
        const HostReporter::Restoring restoring(reported.reporter);
        throw std::length_error("a state too long");
    };
    CHECK_THROWS_AS(restore(), std::length_error);
    reported.reporter.poll(reported.controllers);
    CHECK(reported.heard.values == 1);
}

TEST_CASE("A poll reports the moves of controllers and new assignments") {
    Reported reported;
    reported.parameters[ParameterId::density].moveByController(1234);
    reported.controllers.forgetController(ParameterId::density);
    reported.reporter.poll(reported.controllers);
    CHECK(reported.heard.values == 1);
    CHECK(reported.heard.states == 1);
}
