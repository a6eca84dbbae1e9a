// Saving and restoring: exact, at once, and never harmful.
#include "Plugin/FactoryPrograms.h"
#include "Support/TestSound.h"

#include "Instrument/FactoryContent.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr int blockSamples = 4800;

juce::MidiBuffer chord() {
    juce::MidiBuffer midi;
    for (const int note : {60, 64, 67})
        midi.addEvent(juce::MidiMessage::noteOn(1, note, static_cast<juce::uint8>(100)), 10);
    return midi;
}

State unusualState() {
    auto state = testState();
    state.parameters.set(ParameterId::size, 1.2345678901234567);
    state.parameters.set(ParameterId::material, customMaterial);
    state.parameters.set(ParameterId::youngsModulus, 70.1);
    state.parameters.set(ParameterId::level, -3.3);
    return state;
}

HostSound firstBlock(Processor& processor) {
    return render(processor, blockSamples, blockSamples, chord());
}

/// The first block of a fresh instance that was given the state before it was prepared.
HostSound reference(const State& state) {
    Processor processor;
    restore(processor, state);
    processor.prepareToPlay(48000, blockSamples);
    return firstBlock(processor);
}

} // namespace

TEST_CASE("Save, restore into another instance, save: the bytes are the same") {
    Processor first, second;
    restore(first, unusualState());
    std::mt19937 random(2);
    for (auto* parameter : first.getParameters())
        parameter->setValue(std::uniform_real_distribution<float>(0, 1)(random));
    const auto bytes = saved(first);
    restoreBytes(second, bytes);
    CHECK(saved(second) == bytes);
    for (std::size_t i = 0; i < parameterCount; ++i) {
        const auto id = static_cast<ParameterId>(i);
        CHECK(first.parameterValue(id) == second.parameterValue(id));
    }
}

TEST_CASE("A host that echoes every parameter after a restore does not change the state") {
    Processor processor;
    restore(processor, unusualState());
    const auto bytes = saved(processor);
    for (auto* parameter : processor.getParameters())
        parameter->setValueNotifyingHost(parameter->getValue());
    CHECK(saved(processor) == bytes);
}

TEST_CASE("The first block after a restore is bit-identical to the first render") {
    const auto expected = reference(unusualState());
    REQUIRE(loudest(expected) > 0.001f);

    SECTION("into an instance that is prepared") {
        Processor processor;
        processor.prepareToPlay(48000, blockSamples);
        restore(processor, unusualState());
        CHECK(firstBlock(processor) == expected);
    }
    SECTION("into an instance that played something else, once that is silent") {
        Processor processor;
        restore(processor, testState("other", 1.7));
        processor.prepareToPlay(48000, blockSamples);
        firstBlock(processor);
        processor.reset();
        restore(processor, unusualState());
        CHECK(firstBlock(processor) == expected);
    }
    SECTION("twice in a row, with a short block between") {
        Processor processor;
        processor.prepareToPlay(48000, blockSamples);
        restore(processor, testState("other", 1.7));
        render(processor, 16, 16, {});
        restore(processor, unusualState());
        const auto output = firstBlock(processor);
        // All but the level, which ramps from that of the state before.
        CHECK(std::equal(output.left.begin() + 960, output.left.end(), expected.left.begin() + 960,
                         expected.left.end()));
    }
    SECTION("from another thread") {
        Processor processor;
        processor.prepareToPlay(48000, blockSamples);
        std::thread([&] { restore(processor, unusualState()); }).join();
        CHECK(firstBlock(processor) == expected);
    }
    SECTION("into an instance that is prepared again, at another rate and back") {
        Processor processor;
        processor.prepareToPlay(96000, 64);
        render(processor, 640, 64, chord());
        restore(processor, unusualState());
        processor.releaseResources();
        processor.prepareToPlay(48000, blockSamples);
        CHECK(firstBlock(processor) == expected);
    }
}

TEST_CASE("What cannot be restored leaves sound and state as they were, and says one sentence") {
    auto future = encodeState(unusualState());
    future.replace(future.find("\"version\":1"), 11, "\"version\":9");
    auto lost = testState("nowhere");
    lost.objects.clear();
    const auto good = encodeState(unusualState());
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "The saved state"},
        {std::string("\x80\x00\xff noise", 9), "The saved state"},
        {good.substr(0, good.size() / 2), "The saved state"},
        {future, "newer Idiophone"},
        {encodeState(lost), "nowhere/60"}};

    const auto expected = reference(testState());
    for (const auto& [bytes, sentence] : cases) {
        Processor processor;
        restore(processor, testState());
        processor.prepareToPlay(48000, blockSamples);
        const auto before = saved(processor);
        restoreBytes(processor, bytes);
        INFO(bytes.substr(0, 80));
        CHECK(saved(processor) == before);
        const auto status = processor.takeStatus();
        CHECK(status.isError);
        CHECK_THAT(status.sentence, ContainsSubstring(sentence));
        CHECK(firstBlock(processor) == expected);
        restore(processor, testState());
        CHECK_FALSE(processor.takeStatus().isError);
    }
    Processor processor;
    processor.setStateInformation(nullptr, 0);
    processor.setStateInformation(nullptr, -1);
    CHECK(processor.takeStatus().isError);
}

TEST_CASE("States are restored and saved from several threads while the audio runs") {
    Processor processor;
    processor.prepareToPlay(48000, 256);
    const auto stateOf = [](const char* folder, double size) {
        auto state = testState(folder);
        state.parameters.set(ParameterId::size, size);
        return encodeState(state);
    };
    const auto a = stateOf("a", 1), b = stateOf("b", 2);
    std::atomic<bool> stop{false}, finite{true}, whole{true};
    std::thread audio([&] {
        while (!stop)
            if (!allFinite(render(processor, 256, 256, testMusic(256, 50))))
                finite = false;
    });
    const auto hammer = [&](const std::string& bytes) {
        for (int i = 0; i < 40; ++i) {
            restoreBytes(processor, bytes);
            const auto now = parseState(saved(processor));
            // The parameters are those of the preset beside them.
            const double size = now ? now->parameters[ParameterId::size] : 0;
            if (!now || now->preset.keyMap.object != (size == 1 ? "a/{note}" : "b/{note}"))
                whole = false;
        }
    };
    std::thread other([&] { hammer(b); });
    hammer(a);
    other.join();
    stop = true;
    audio.join();
    CHECK(finite);
    CHECK(whole);
}

TEST_CASE(
    "A restored factory preset is the current program, another sound is not mistaken for it") {
    Processor first, second;
    REQUIRE(first.getNumPrograms() > 1);
    first.setCurrentProgram(1);
    restoreBytes(second, saved(first));
    CHECK(second.getCurrentProgram() == 1);
    CHECK(second.presetShelf().chosenPreset() == factoryPresetId(factoryPresets()[1].name));
    restore(second, testState());
    CHECK(second.presetShelf().chosenPreset().empty());
    CHECK(second.getCurrentProgram() == 0); // hosts know no other
}
