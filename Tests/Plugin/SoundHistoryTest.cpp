#include "Plugin/SoundHistory.h"

#include "Plugin/HistorySteps.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <functional>
#include <thread>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

juce::MidiBuffer oneNote() {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::noteOn(1, 72, static_cast<juce::uint8>(100)), 0);
    return midi;
}

float largestStep(const std::vector<float>& samples) {
    float step = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        step = std::max(step, std::abs(samples[i] - samples[i - 1]));
    return step;
}

} // namespace

TEST_CASE("A new instance has nothing to undo or redo") {
    Processor processor;
    auto& history = processor.windowSession().history;
    CHECK_FALSE(history.canUndo());
    CHECK_FALSE(history.canRedo());
    CHECK(history.undoName().empty());
    const auto before = saved(processor);
    history.undo();
    history.redo();
    CHECK(saved(processor) == before);
}

TEST_CASE("Undo returns every earlier state, and redo every later one") {
    Processor processor;
    auto& history = processor.windowSession().history;
    std::vector<std::string> states;
    const auto step = [&](const std::function<void()>& action) {
        action();
        states.push_back(saved(processor));
    };
    step([] {});
    step([&] { drag(processor, tau, {0.5}); });
    step([&] { load(processor, 3); });
    step([&] { drag(processor, material, {5}); });
    step([&] { processor.windowSession().variants.mutate(0.5, 3); });
    step([&] { processor.windowSession().variants.compare(); });
    step([&] { load(processor, 8); });
    step([&] { drag(processor, size, {2, 3}); });
    step([&] { processor.windowSession().variants.compare(); });
    for (std::size_t i = states.size() - 1; i > 0; --i) {
        CHECK(saved(processor) == states[i]);
        history.undo();
    }
    CHECK(saved(processor) == states[0]);
    for (std::size_t i = 1; i < states.size(); ++i) {
        history.redo();
        CHECK(saved(processor) == states[i]);
    }
    CHECK_FALSE(history.canRedo());
}

TEST_CASE("A new step after an undo discards the undone steps") {
    Processor processor;
    auto& history = processor.windowSession().history;
    drag(processor, tau, {0.5});
    history.undo();
    drag(processor, density, {1000});
    CHECK_FALSE(history.canRedo());
    CHECK(history.undoName() == "Density");
}

TEST_CASE("A state or program loaded by the host clears the steps and the other variant") {
    Processor processor;
    auto& history = processor.windowSession().history;
    drag(processor, density, {1000});
    processor.windowSession().variants.compare();
    CHECK(processor.windowSession().variants.playsB());
    SECTION("a state") {
        restore(processor, testState());
    }
    SECTION("a program") {
        processor.setCurrentProgram(2);
    }
    const auto before = saved(processor);
    CHECK_FALSE(history.canUndo());
    CHECK_FALSE(processor.windowSession().variants.playsB());
    history.undo();
    CHECK(saved(processor) == before);
    drag(processor, density, {1200});
    CHECK(history.canUndo());
}

TEST_CASE("MIDI program changes in a row are one step, whose undo returns the unsaved sound") {
    const UserSettings user;
    Processor processor;
    auto& history = processor.windowSession().history;
    const bool isOffline = GENERATE(false, true);
    processor.setNonRealtime(isOffline);
    processor.prepareToPlay(48000, 512);
    const auto ask = [&](int program) {
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::programChange(1, program), 0);
        render(processor, 512, 512, midi);
        processor.poll();
        REQUIRE(processor.getCurrentProgram() == program);
    };
    const auto first = saved(processor);
    drag(processor, density, {1000});
    const auto before = saved(processor);

    SECTION("in a row") {
        processor.windowSession().variants.compare();
        const auto compared = saved(processor);
        ask(2);
        CHECK(history.undoName() == factoryPresets()[2].name);
        ask(3);
        ask(4);
        CHECK(history.undoName() == factoryPresets()[4].name);
        history.undo();
        CHECK(saved(processor) == compared);
        CHECK(processor.windowSession().variants.playsB());
        history.redo();
        CHECK(processor.getCurrentProgram() == 4);
        history.undo();
        ask(5); // a new step that discards the redo
        CHECK_FALSE(history.canRedo());
        history.undo();
        CHECK(saved(processor) == compared);
    }
    SECTION("with a change in between") {
        ask(2);
        drag(processor, tau, {5});
        const auto changed = saved(processor);
        ask(3);
        history.undo();
        CHECK(saved(processor) == changed);
        history.undo();
        CHECK(processor.getCurrentProgram() == 2);
        history.undo();
        CHECK(saved(processor) == before);
        history.undo();
        CHECK(saved(processor) == first);
    }
    SECTION("during an audition") {
        auto& shelf = processor.view().presets;
        REQUIRE(shelf.auditionPreset(factoryPresetId("Wok")));
        ask(3);
        shelf.endAudition();
        CHECK(processor.getCurrentProgram() == 3);
        history.undo();
        CHECK(saved(processor) == before);
    }
    SECTION("while a parameter is held and moved on") {
        processor.view().parameters.beginChange(tau);
        processor.view().parameters.change(tau, 5);
        const auto held = saved(processor);
        ask(3);
        processor.view().parameters.change(tau, 7);
        processor.view().parameters.endChange(tau);
        history.undo();
        CHECK(processor.view().parameters.value(tau) == factoryPresets()[3].parameters[tau]);
        history.undo();
        CHECK(saved(processor) == held);
        history.undo();
        CHECK(saved(processor) == before);
    }
    SECTION("while a parameter is held and then released") {
        processor.view().parameters.beginChange(tau);
        processor.view().parameters.change(tau, 5);
        const auto held = saved(processor);
        ask(3);
        processor.view().parameters.endChange(tau);
        history.undo();
        CHECK(saved(processor) == held);
        history.undo();
        CHECK(saved(processor) == before);
        history.redo();
        CHECK(saved(processor) == held);
    }
    SECTION("before the host loads a program") {
        ask(3);
        processor.setCurrentProgram(5);
        CHECK_FALSE(history.canUndo());
    }
    SECTION("after the host has loaded a program") {
        processor.setCurrentProgram(5);
        const auto loaded = saved(processor);
        ask(3);
        history.undo();
        CHECK(saved(processor) == loaded);
        CHECK_FALSE(history.canUndo());
    }
}

TEST_CASE("An undone load plays the same objects as before and keeps the setup parameters") {
    Processor processor;
    const auto first = processor.soundSession().instrument();
    load(processor, 4);
    CHECK(processor.soundSession().instrument() != first);
    processor.view().parameters.change(bypass, 1);
    processor.view().parameters.change(concertPitch, 415);
    processor.windowSession().history.undo();
    CHECK(processor.soundSession().instrument() == first);
    CHECK(processor.view().parameters.value(bypass) == 1);
    CHECK(processor.view().parameters.value(concertPitch) == 415);
    CHECK(processor.getCurrentProgram() == 0);
}

TEST_CASE("The number of steps is bounded, and the newest steps are kept") {
    Processor processor;
    auto& history = processor.windowSession().history;
    for (int i = 0; i < 20000; ++i)
        drag(processor, density, {1000.0 + i % 1000});
    int steps = 0;
    while (history.canUndo()) {
        history.undo();
        ++steps;
    }
    CHECK(steps > 1000);
    CHECK(steps < 10000);
}

TEST_CASE("renewSounds also replaces the sounds in the steps") {
    Processor processor;
    auto& history = processor.windowSession().history;
    const auto preview = processor.soundSession().instrument();
    load(processor, 3);
    auto full = processor.soundSession().loadedSound();
    history.renewSounds([&](Sound& sound) {
        if (sound.instrument != preview)
            return;
        sound.instrument = full.instrument;
        sound.preset.keyMap = full.preset.keyMap;
    });
    history.undo();
    CHECK(processor.soundSession().instrument() == full.instrument);
    CHECK(processor.soundSession().loadedSound().preset.keyMap == full.preset.keyMap);
}

TEST_CASE("Undo, compare and mutate while notes ring make no step larger than the sound's own") {
    Processor processor;
    restore(processor, testState());
    processor.prepareToPlay(48000, 480);
    auto& history = processor.windowSession().history;
    processor.windowSession().variants.compare(); // B has another mallet and material
    drag(processor, malletHardness, {200});
    drag(processor, material, {firstLibraryMaterial});
    processor.windowSession().variants.compare();
    const auto ringing = render(processor, 9600, 480, oneNote()).left;
    float natural = largestStep({ringing.end() - 4800, ringing.end()});
    float last = ringing.back();
    const auto check = [&](auto&& action) {
        action();
        auto after = render(processor, 960, 480, {}).left;
        after.insert(after.begin(), last);
        CHECK(loudest(after) > 0);
        CHECK(largestStep(after) <= 1.5f * natural);
        last = after.back();
    };
    check([&] { processor.windowSession().variants.compare(); });
    check([&] { history.undo(); });
    check([&] { processor.windowSession().variants.mutate(1, 4); });
    check([&] { history.undo(); });
    check([&] { history.redo(); });
}

TEST_CASE("Undo and redo of loads during audio keep the sound finite and restore the first state") {
    Processor processor;
    processor.prepareToPlay(48000, 256);
    std::atomic<bool> stop{false}, finite{true};
    std::thread audio([&] {
        while (!stop)
            if (!allFinite(render(processor, 256, 256, testMusic(256, 50))) ||
                processor.engineReport().notFinite > 0)
                finite = false;
    });
    const auto before = saved(processor);
    auto& history = processor.windowSession().history;
    for (std::size_t i = 0; i < 20; ++i) {
        load(processor, i % 4 + 1);
        processor.windowSession().variants.mutate(0.3, static_cast<std::uint32_t>(i));
        processor.windowSession().variants.compare();
        history.undo();
        history.undo();
        history.redo();
    }
    while (history.canUndo())
        history.undo();
    stop = true;
    audio.join();
    CHECK(finite);
    CHECK(saved(processor) == before);
}
