// Tests states that cannot be restored at all, or only in part.
#include "Plugin/FactoryPrograms.h"
#include "Plugin/RestoredSound.h"

#include "Instrument/FactoryContent.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <string>
#include <utility>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("A state that cannot be restored changes nothing and gives one sentence") {
    auto future = encodeState(unusualState());
    future.replace(future.find("\"version\":1"), 11, "\"version\":9");
    auto damaged = testState("damaged");
    damaged.objects[3].modal.resize(20);
    const auto good = encodeState(unusualState());
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "The saved state"},
        {std::string("\x80\x00\xff noise", 9), "The saved state"},
        {good.substr(0, good.size() / 2), "The saved state"},
        {future, "newer Idiophone"},
        {encodeState(damaged), "damaged/63"}};

    const auto expected = reference(testState());
    for (const auto& [bytes, sentence] : cases) {
        INFO(bytes.substr(0, 80));
        Processor processor;
        restore(processor, testState());
        processor.prepareToPlay(48000, blockSamples);
        REQUIRE(processor.view().sound.muteMode(0, 1, true));
        restoreBytes(processor, bytes);
        const auto status = processor.view().status.takeStatus();
        CHECK(status.isError);
        CHECK_THAT(status.sentence, ContainsSubstring(sentence));
        processor.windowSession().history.undo(); // the steps are kept too
        CHECK(saved(processor) == encodeState(testState()));
        CHECK(firstBlock(processor) == expected);
        restore(processor, testState());
        CHECK_FALSE(processor.view().status.takeStatus().isError);
    }
}

TEST_CASE("An empty state is an error") {
    Processor processor;
    const auto before = saved(processor);
    processor.setStateInformation(nullptr, 0);
    processor.setStateInformation(nullptr, -1);
    CHECK(processor.view().status.takeStatus().isError);
    CHECK(saved(processor) == before);
}

TEST_CASE(
    "If objects are missing, a ring plays, the rest is restored, and the names are saved again") {
    auto state = unusualState();
    state.tuning.scale = {.name = "two.scl", .text = "two\n2\n600.\n1200.\n"};
    state.controllers[ParameterId::tau] = 21;
    REQUIRE(state.preset.mutedModes.set("61", 2, true));
    const auto whole = encodeState(state);
    state.objects.erase(state.objects.begin()); // the other objects may be missing
    const auto bytes = encodeState(state);
    Processor processor;
    processor.prepareToPlay(48000, blockSamples);
    restoreBytes(processor, bytes);
    const auto status = processor.view().status.takeStatus();
    CHECK(status.isError);
    CHECK(status.sentence ==
          "Test keyboard: test/60 is missing; until it is back a steel ring plays in its place.");
    CHECK(loudest(firstBlock(processor)) > 1e-4f);
    CHECK(processor.view().instrument.keyRange().lowest == lowestTestNote);
    CHECK(processor.view().parameters.value(ParameterId::size) == 1.2345678901234567);
    CHECK(processor.windowSession().controllers.controllerOf(ParameterId::tau) == 21);
    CHECK(processor.view().tuning.tuningStatus().scale == "two");
    CHECK(saved(processor) == bytes);

    SECTION("with changes made while the ring plays") {
        auto changed = state;
        changed.parameters.set(ParameterId::size, 2);
        processor.view().parameters.change(ParameterId::size, 2);
        CHECK(saved(processor) == encodeState(changed));
        processor.setCurrentProgram(0);
        CHECK(parseState(saved(processor))->preset.keyMap == factoryPresets()[0].keyMap);
    }
    SECTION("the keys cannot be changed") {
        const auto number = processor.view().instrument.instrumentNumber();
        const auto isKept = [&] {
            const auto now = processor.view().status.takeStatus();
            CHECK(now.isError);
            CHECK_THAT(now.sentence, ContainsSubstring("keys cannot be changed"));
            CHECK_THAT(now.sentence, ContainsSubstring("test/60"));
            CHECK(processor.view().instrument.instrumentNumber() == number);
            CHECK(saved(processor) == bytes);
            processor.view().status.reportError({});
        };
        processor.view().workshop.setKeyLayout(KeyLayout::zones);
        isKept();
        processor.view().workshop.setStrikePath(0, processor.view().instrument.struckPlaces(0));
        isKept();
    }
    SECTION("without a preset name") {
        state.preset.name.clear();
        restore(processor, state);
        CHECK(processor.view().status.takeStatus().sentence ==
              "test/60 is missing; until it is back a steel ring plays in its place.");
        CHECK(saved(processor) == encodeState(state));
    }
    SECTION("after an undo") {
        REQUIRE(processor.view().presets.loadPreset(factoryPresetId("Wok")));
        REQUIRE(saved(processor) != bytes);
        processor.windowSession().history.undo();
        CHECK(saved(processor) == bytes);
    }
    SECTION("complete once the object is back") {
        auto back = *parseState(saved(processor));
        back.objects = parseState(whole)->objects;
        restore(processor, back);
        CHECK_FALSE(processor.view().status.takeStatus().isError);
        CHECK(saved(processor) == whole);
    }
}
