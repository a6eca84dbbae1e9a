#include "Plugin/HostReporter.h"

#include "Plugin/BareHost.h"

#include <catch2/catch_test_macros.hpp>
#include <stdexcept>

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

} // namespace

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
