// Saving and restoring: exact, at once, and never harmful.
#include "Plugin/FactoryPrograms.h"
#include "Support/ImportedFiles.h"
#include "Support/TestSound.h"
#include "Support/UserSettings.h"

#include "Instrument/FactoryContent.h"
#include "Object/ModalObjectFile.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <functional>
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

/// As a processor saves it.
State ofThisVersion(State state) {
    Processor processor;
    state.engineVersion = parseState(saved(processor))->engineVersion;
    return state;
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

TEST_CASE("What cannot be restored leaves the sound as it was, is saved again as it came, and says "
          "one sentence") {
    auto future = encodeState(unusualState());
    future.replace(future.find("\"version\":1"), 11, "\"version\":9");
    auto damaged = testState("damaged");
    damaged.objects[3].modal.resize(20);
    const auto good = encodeState(unusualState());
    const std::vector<std::pair<std::string, std::string>> cases{
        {std::string("\x80\x00\xff noise", 9), "The saved state"},
        {good.substr(0, good.size() / 2), "The saved state"},
        {future, "newer Idiophone"},
        {encodeState(damaged), "damaged/63"}};

    const auto expected = reference(testState());
    for (const auto& [bytes, sentence] : cases) {
        Processor processor;
        restore(processor, testState());
        processor.prepareToPlay(48000, blockSamples);
        restoreBytes(processor, bytes);
        INFO(bytes.substr(0, 80));
        CHECK(saved(processor) == bytes);
        const auto status = processor.takeStatus();
        CHECK(status.isError);
        CHECK_THAT(status.sentence, ContainsSubstring(sentence));
        CHECK_THAT(status.sentence, ContainsSubstring("The project keeps it"));
        CHECK(firstBlock(processor) == expected);
        restore(processor, testState());
        CHECK_FALSE(processor.takeStatus().isError);
        CHECK(saved(processor) == encodeState(ofThisVersion(testState())));
    }
}

TEST_CASE("A state of no bytes is an error, and nothing that would be kept") {
    Processor processor;
    const auto before = saved(processor);
    processor.setStateInformation(nullptr, 0);
    processor.setStateInformation(nullptr, -1);
    CHECK(processor.takeStatus().isError);
    CHECK(saved(processor) == before);
}

TEST_CASE("A refused state outlives what a song does by itself, and ends with what people do") {
    const std::string refused = "of a later version";
    const UserSettings user;
    Processor processor;
    processor.prepareToPlay(48000, blockSamples);
    restore(processor, testState());
    restoreBytes(processor, refused);
    REQUIRE(saved(processor) == refused);
    const auto refuseAgain = [&] {
        restoreBytes(processor, refused);
        return saved(processor) == refused;
    };

    auto& history = processor.editHistory();
    auto& shelf = processor.presetShelf();

    SECTION(
        "automation, notes, controllers, other rates, a window that is only opened, an audition "
        "that is left and a sound that is saved as a preset") {
        for (auto* parameter : processor.getParameters())
            parameter->setValue(0.7f);
        render(processor, 4800, 480, testMusic(4800));
        processor.releaseResources();
        processor.prepareToPlay(96000, 64);
        render(processor, 640, 64, chord());
        processor.hearModeAlone(0, 1, true);
        processor.windowClosed();
        juce::Timer::callPendingTimersSynchronously();
        REQUIRE(shelf.auditionPreset(factoryPresetId("Wok")));
        REQUIRE(shelf.auditionPreset(factoryPresetId("Marimba")));
        shelf.endAudition();
        REQUIRE(shelf.savePreset(
            {.name = "Test", .folder = {}, .author = {}, .description = {}, .tags = {}}, false));
        CHECK(saved(processor) == refused);
        CHECK(processor.takeStatus().isError);
    }
    SECTION("what is left of what was begun before it: an audition, and steps") {
        REQUIRE(shelf.auditionPreset(factoryPresetId("Wok")));
        REQUIRE(refuseAgain());
        shelf.endAudition();
        history.undo();
        CHECK_FALSE(history.canUndo());
        CHECK(processor.loadedLabel().name == "Wok");
        CHECK(saved(processor) == refused);
        CHECK(processor.takeStatus().isError);
    }
    SECTION("each of these ends it, and the sentence") {
        const auto ends = [&](const char* what, const std::function<void()>& change) {
            INFO(what);
            REQUIRE(refuseAgain());
            change();
            CHECK(parseState(saved(processor)));
            CHECK_FALSE(processor.takeStatus().isError);
        };
        ends("a parameter by hand", [&] {
            processor.beginParameterChange(ParameterId::size);
            processor.changeParameter(ParameterId::size, 1.5);
            processor.endParameterChange(ParameterId::size);
        });
        ends("a mutation", [&] { processor.soundVariants().mutate(0.5, 1); });
        ends("a muted mode", [&] { REQUIRE(processor.muteMode(0, 1, true)); });
        ends("unmuted modes", [&] { processor.unmuteModes(0); });
        ends("a scale",
             [&] { processor.openTuning(writtenFile("two.scl", "two\n2\n600.\n1200.\n")); });
        ends("no scale", [&] { processor.forgetTuning(); });
        ends("a preset", [&] { REQUIRE(shelf.loadPreset(factoryPresetId("Wok"))); });
        ends("one that is kept after an audition", [&] {
            REQUIRE(shelf.auditionPreset(factoryPresetId("Wok")));
            shelf.keepAudition();
        });
        ends("other keys", [&] { processor.setKeyLayout(KeyLayout::scaled); });
        ends("a program", [&] { processor.setCurrentProgram(0); });
    }
    SECTION("with another sound undone it is there again, with it redone no more") {
        const std::pair<const char*, std::function<void()>> ends[] = {
            {"a preset", [&] { REQUIRE(shelf.loadPreset(factoryPresetId("Wok"))); }},
            {"a mutation", [&] { processor.soundVariants().mutate(0.5, 1); }},
            {"a muted mode", [&] { REQUIRE(processor.muteMode(0, 1, true)); }},
            {"unmuted modes", [&] { processor.unmuteModes(0); }},
        };
        for (const auto& [what, end] : ends) {
            INFO(what);
            end();
            history.undo();
            CHECK(saved(processor) == refused);
            CHECK(processor.takeStatus().isError);
            history.redo();
            CHECK(parseState(saved(processor)));
            CHECK_FALSE(processor.takeStatus().isError);
            history.undo();
            REQUIRE(saved(processor) == refused);
        }
    }
    SECTION("a learned controller ends it") {
        processor.midiLearn().learnController(ParameterId::size);
        CHECK(saved(processor) == refused);
        juce::MidiBuffer midi;
        midi.addEvent(juce::MidiMessage::controllerEvent(1, 20, 64), 0);
        render(processor, 480, 480, midi);
        const auto state = parseState(saved(processor));
        REQUIRE(state);
        CHECK(state->controllers[ParameterId::size] == 20);
    }
}

TEST_CASE(
    "Where objects are missing a ring plays with all else restored, and what the state named is "
    "saved again") {
    auto state = ofThisVersion(unusualState());
    state.tuning.scale = {.name = "two.scl", .text = "two\n2\n600.\n1200.\n"};
    state.controllers[ParameterId::tau] = 21;
    REQUIRE(state.preset.mutedModes.set("61", 2, true));
    const auto whole = encodeState(state);
    state.objects.erase(state.objects.begin() + 4);
    const auto bytes = encodeState(state);
    Processor processor;
    processor.prepareToPlay(48000, blockSamples);
    restoreBytes(processor, bytes);
    const auto status = processor.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence ==
          "Test keyboard: test/64 is missing; until it is back a steel ring plays in its place.");
    CHECK(loudest(firstBlock(processor)) > 1e-4f);
    CHECK(processor.keyRange().lowest == lowestTestNote);
    CHECK(processor.parameterValue(ParameterId::size) == 1.2345678901234567);
    CHECK(processor.midiLearn().controllerOf(ParameterId::tau) == 21);
    CHECK(processor.tuningStatus().scale == "two");
    CHECK(saved(processor) == bytes);

    SECTION("with what was changed, as long as the ring plays") {
        auto changed = state;
        changed.parameters.set(ParameterId::size, 2);
        processor.changeParameter(ParameterId::size, 2);
        CHECK(saved(processor) == encodeState(changed));
        processor.setCurrentProgram(0);
        CHECK(parseState(saved(processor))->preset.keyMap == factoryPresets()[0].keyMap);
    }
    SECTION("with the keys that it has, which are nobody's to change") {
        const auto number = processor.instrumentNumber();
        const auto isKept = [&] {
            const auto now = processor.takeStatus();
            CHECK(now.isError);
            CHECK_THAT(now.sentence, ContainsSubstring("keys cannot be changed"));
            CHECK_THAT(now.sentence, ContainsSubstring("test/64"));
            CHECK(processor.instrumentNumber() == number);
            CHECK(saved(processor) == bytes);
            processor.reportError({});
        };
        processor.setKeyLayout(KeyLayout::zones);
        isKept();
        processor.setStrikePath(0, processor.struckPlaces(0));
        isKept();
    }
    SECTION("without a name too") {
        state.preset.name.clear();
        restore(processor, state);
        CHECK(processor.takeStatus().sentence ==
              "test/64 is missing; until it is back a steel ring plays in its place.");
        CHECK(saved(processor) == encodeState(state));
    }
    SECTION("with it, undo too brings it back") {
        REQUIRE(processor.presetShelf().loadPreset(factoryPresetId("Wok")));
        REQUIRE(saved(processor) != bytes);
        processor.editHistory().undo();
        CHECK(saved(processor) == bytes);
    }
    SECTION("and is whole once it is back") {
        auto back = *parseState(saved(processor));
        back.objects = parseState(whole)->objects;
        restore(processor, back);
        CHECK_FALSE(processor.takeStatus().isError);
        CHECK(saved(processor) == whole);
    }
}

TEST_CASE(
    "What a newer version added stays with its sound, and its controllers with the instance") {
    auto newer = encodeState(unusualState());
    newer.replace(newer.find("\"parameters\":{"), 14,
                  R"("later":[1],"parameters":{"radiance":0.5,)");
    newer.replace(newer.find("\"preset\":{"), 10, R"("preset":{"layers":2,)");
    newer.insert(newer.size() - 1, R"(,"controllers":{"radiance":20})");
    const auto ofSound = [](const std::string& bytes) { return parseState(bytes)->unknownOfSound; };
    const auto ofInstance = [](const std::string& bytes) {
        return parseState(bytes)->unknownOfInstance;
    };
    const std::string kept = R"({"later":[1],"parameters":{"radiance":0.5},"preset":{"layers":2}})";
    const std::string learned = R"({"controllers":{"radiance":20}})";
    Processor processor;
    restoreBytes(processor, newer);
    CHECK(ofSound(saved(processor)) == kept);
    CHECK(ofInstance(saved(processor)) == learned);

    processor.changeParameter(ParameterId::size, 1.1);
    processor.soundVariants().mutate(0.5, 1);
    REQUIRE(processor.muteMode(0, 1, true));
    CHECK(ofSound(saved(processor)) == kept);

    REQUIRE(processor.presetShelf().loadPreset(factoryPresetId("Wok")));
    CHECK(ofSound(saved(processor)).empty());
    CHECK(ofInstance(saved(processor)) == learned);
    processor.editHistory().undo();
    CHECK(ofSound(saved(processor)) == kept);
    processor.editHistory().redo();
    CHECK(ofSound(saved(processor)).empty());
    processor.editHistory().undo();
    processor.editHistory().undo();
    processor.editHistory().redo();
    CHECK(ofSound(saved(processor)) == kept);

    processor.setCurrentProgram(1);
    CHECK(ofSound(saved(processor)).empty());
    CHECK(ofInstance(saved(processor)) == learned);
    restore(processor, testState());
    CHECK(ofInstance(saved(processor)).empty());
}

TEST_CASE("Whatever can be loaded can be saved and restored") {
    const UserSettings user;
    Processor first;
    const auto comesBack = [&] {
        INFO(first.loadedLabel().name);
        CHECK_FALSE(first.takeStatus().isError);
        const auto bytes = saved(first);
        Processor second;
        restoreBytes(second, bytes);
        CHECK(second.takeStatus().sentence == first.takeStatus().sentence);
        CHECK_FALSE(second.takeStatus().isError);
        CHECK(saved(second) == bytes);
    };
    SECTION("every program") {
        for (int program = 0; program < static_cast<int>(factoryPresets().size()); ++program) {
            first.setCurrentProgram(program);
            comesBack();
        }
    }
    SECTION("objects without a name, and with one that is not UTF-8") {
        for (const auto* name : {"", "\xff\xfe", "a/{note}\n"}) {
            auto object = syntheticObject({300, 700});
            object.name = name;
            const auto file = testFolder() / "nameless.modal";
            REQUIRE(writeModalObject(object, file));
            first.openFile(file);
            finish(first);
            CHECK((first.loadedLabel().name == "nameless") == object.name.empty());
            comesBack();
            for (const auto layout : {KeyLayout::zones, KeyLayout::scaled}) {
                first.setKeyLayout(layout);
                comesBack();
            }
        }
    }
    SECTION("another analysis of an object without a name") {
        auto object = syntheticObject({300, 700});
        object.name.clear();
        for (auto& coordinate : object.vertices)
            coordinate *= 0.1f;
        auto state = testState();
        state.preset.keyMap.kind = KeyMapKind::zones;
        state.preset.keyMap.object = "without";
        state.objects = {{.name = "without", .modal = encodeModalObject(object)}};
        restore(first, state);
        first.analyseAgain();
        finish(first);
        CHECK(first.loadedLabel().name == "Object");
        comesBack();
    }
    SECTION("scales of any bytes") {
        std::string text = "from 1995\n2\n600.\n1200.\n! ";
        text.resize(ScalaTuning::largestFileBytes, '\xe9');
        first.openTuning(writtenFile("any.scl", text));
        comesBack();
    }
    SECTION("the longest of presets") {
        std::string text = R"({"format":"idiophone-preset","version":1,"name":"Long","keyMap":)"
                           R"({"kind":"zones","lowestNote":36,"highestNote":96,"object":"plate"},)"
                           R"("description":")";
        text.resize(largestPresetBytes - 2, 'x');
        user.write("Presets/Long.json", text + R"("})");
        REQUIRE(first.presetShelf().loadPreset("Long.json"));
        comesBack();
    }
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
