#include "Plugin/HostParameter.h"

#include "Plugin/BareHost.h"
#include "Support/TestSound.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

HostParameter& parameterOf(Processor& processor, const char* id) {
    for (auto* parameter : processor.getParameters())
        if (auto* found = dynamic_cast<HostParameter*>(parameter);
            found != nullptr && found->getParameterID() == id)
            return *found;
    FAIL("no parameter " << id);
    throw 0;
}

} // namespace

TEST_CASE("Every parameter can be automated and has a name, a text and a default in range") {
    Processor processor;
    for (auto* parameter : processor.getParameters()) {
        INFO(parameter->getName(100));
        CHECK(parameter->isAutomatable());
        CHECK(parameter->getName(100).isNotEmpty());
        CHECK(parameter->getDefaultValue() >= 0);
        CHECK(parameter->getDefaultValue() <= 1);
        for (const float place : {0.0f, 0.3f, 1.0f})
            CHECK(parameter->getText(place, 100).isNotEmpty());
    }
}

TEST_CASE("A parameter's text reads back to its value, with and without the unit") {
    Processor processor;
    for (auto* parameter : processor.getParameters()) {
        INFO(parameter->getName(100));
        for (const float place : {0.0f, 0.25f, 0.5f, 1.0f}) {
            const auto text = parameter->getText(place, 100);
            const float read = parameter->getValueForText(text);
            CHECK(parameter->getText(read, 100) == text);
            CHECK(parameter->getValueForText(text + " " + parameter->getLabel()) == read);
            CHECK_FALSE(
                (parameter->getLabel().isNotEmpty() && text.endsWith(" " + parameter->getLabel())));
        }
    }
}

TEST_CASE("Text that is not a value leaves the parameter unchanged") {
    Processor processor;
    auto& density = parameterOf(processor, "density");
    density.setExactValue(1234.5);
    CHECK(density.getValueForText("heavy") == density.getValue());
    CHECK(density.getValueForText("3 Hz") == density.getValue());
}

TEST_CASE("A host's text may have another unit, and a number alone is never 0 to 100") {
    Processor processor;
    auto& hardness = parameterOf(processor, "mallet_hardness");
    CHECK(hardness.getValueForText("0.2 GPa") == hardness.getValueForText("200"));
    CHECK(hardness.getValueForText("200") == hardness.getValueForText("200 MPa"));
    CHECK(hardness.getText(hardness.getValueForText("50"), 100) == "50.0");
}

TEST_CASE("A host that echoes a value changes no bit of it") {
    HostParameter young(parameterInfo(ParameterId::youngsModulus));
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const double exact = std::uniform_real_distribution<double>(young.info().minimum,
                                                                    young.info().maximum)(random);
        young.setExactValue(exact);
        young.setValue(young.getValue());
        REQUIRE(young.exactValue() == exact);
    }
}

TEST_CASE("NaN and values out of range give a value inside the range") {
    for (const auto& info : parameterTable()) {
        HostParameter parameter(info);
        INFO(info.id);
        const float infinity = std::numeric_limits<float>::infinity();
        for (const float hostile : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity,
                                    -1.0f, 2.0f, std::numeric_limits<float>::denorm_min()}) {
            parameter.setValue(hostile);
            CHECK(parameter.exactValue() >= info.minimum);
            CHECK(parameter.exactValue() <= info.maximum);
        }
    }
}

TEST_CASE("Steps, switches and choices are discrete with the right number of steps") {
    Processor processor;
    CHECK(parameterOf(processor, "let_ring").isBoolean());
    CHECK(parameterOf(processor, "let_ring").getNumSteps() == 2);
    CHECK(parameterOf(processor, "bypass").isBoolean());
    CHECK(parameterOf(processor, "bend_range").getNumSteps() == 49);
    const auto named = static_cast<int>(choiceNames(ParameterId::material).size());
    CHECK(parameterOf(processor, "material").getNumSteps() == named);
    CHECK(parameterOf(processor, "material").isDiscrete());
    CHECK_FALSE(parameterOf(processor, "level").isDiscrete());
    const auto materials = parameterOf(processor, "material").getAllValueStrings();
    REQUIRE(materials.size() == named);
    CHECK(materials[0] == "Own");
    CHECK(materials[2] == "Rosewood");
    for (const auto& name : materials)
        CHECK(name.isNotEmpty());
}

TEST_CASE("A modulation moves what is heard, within the range, and no value") {
    BareHost host;
    HostParameters parameters(host);
    auto& volume = parameters[ParameterId::volume]; // -60 to 12 dB
    volume.setExactValue(0);
    volume.setModulation(-0.25);
    CHECK(volume.exactValue() == 0);
    CHECK(parameters.values() == ParameterValues());
    CHECK(volume.modulatedValue() == Approx(-18));
    ParameterValues heard;
    parameters.read(heard);
    CHECK(heard[ParameterId::volume] == Approx(-18));
    CHECK(parameters.modulatedValues() == heard);
    volume.setModulation(1);
    CHECK(volume.modulatedValue() == Approx(12));
    CHECK(volume.normalisedWith(-1) == 0);
    volume.setModulation(0);
    CHECK(volume.modulatedValue() == 0);
}

TEST_CASE("The host's bypass is the parameter of the table") {
    Processor processor;
    CHECK(processor.getBypassParameter() == &parameterOf(processor, "bypass"));
}

TEST_CASE("A parameter snapshot never mixes two loads") {
    BareHost host;
    HostParameters parameters(host);
    ParameterValues low, high;
    for (const auto& info : parameterTable()) {
        low.set(info.parameter, info.minimum);
        high.set(info.parameter, info.maximum);
    }
    parameters.load(low);
    auto previous = parameters.values(), now = previous;
    REQUIRE(previous == low);
    std::atomic<bool> stop{false};
    std::atomic<int> changes{0};
    std::thread loader([&] {
        for (int i = 0; !stop; ++i) {
            parameters.load(i % 2 == 0 ? high : low);
            while (!stop && changes <= i)
                std::this_thread::yield();
        }
    });
    bool whole = true;
    while (changes < 1000) {
        parameters.read(now);
        whole = whole && (now == low || now == high);
        if (!(now == previous))
            ++changes;
        previous = now;
    }
    stop = true;
    loader.join();
    CHECK(whole);
}
