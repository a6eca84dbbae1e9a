// States that cannot be restored, or not whole, are kept until somebody decides otherwise.
#include "Plugin/FactoryPrograms.h"
#include "Plugin/RestoredSound.h"
#include "Support/ImportedFiles.h"
#include "Support/UserSettings.h"

#include "Instrument/FactoryContent.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

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
        CHECK(saved(processor) == encodeState(testState()));
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
    auto state = unusualState();
    state.tuning.scale = {.name = "two.scl", .text = "two\n2\n600.\n1200.\n"};
    state.controllers[ParameterId::tau] = 21;
    REQUIRE(state.preset.mutedModes.set("61", 2, true));
    const auto whole = encodeState(state);
    state.objects.erase(state.objects.begin()); // the others may be missing
    const auto bytes = encodeState(state);
    Processor processor;
    processor.prepareToPlay(48000, blockSamples);
    restoreBytes(processor, bytes);
    const auto status = processor.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence ==
          "Test keyboard: test/60 is missing; until it is back a steel ring plays in its place.");
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
            CHECK_THAT(now.sentence, ContainsSubstring("test/60"));
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
              "test/60 is missing; until it is back a steel ring plays in its place.");
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
