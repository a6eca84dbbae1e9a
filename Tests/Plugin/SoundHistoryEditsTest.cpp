// Steps made by edits in the window, and the effects of variants and auditions.
#include "Plugin/SoundHistory.h"

#include "Plugin/HistorySteps.h"
#include "Support/GestureLog.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

TEST_CASE("A gesture is one step with the parameter's name") {
    Processor processor;
    auto& history = processor.windowSession().history;
    const double before = processor.view().parameters.value(density);
    drag(processor, density, {900, 1000, 1100.5});
    CHECK(history.undoName() == "Density");
    history.undo();
    CHECK(processor.view().parameters.value(density) == before);
    CHECK_FALSE(history.canUndo());
    CHECK(history.redoName() == "Density");
    history.redo();
    CHECK(processor.view().parameters.value(density) == 1100.5);
    CHECK_FALSE(history.canRedo());
}

TEST_CASE("A gesture that ends where it began is no step") {
    Processor processor;
    drag(processor, density, {900, 1000, processor.view().parameters.value(density)});
    CHECK_FALSE(processor.windowSession().history.canUndo());
}

TEST_CASE("An edit of several parameters is one step, and so are overlapping gestures") {
    Processor processor;
    auto& history = processor.windowSession().history;
    const auto before = valuesOf(processor);
    SECTION("a named edit") {
        history.beginEdit("Steel as measured");
        drag(processor, youngsModulus, {200});
        history.beginEdit("inner");
        drag(processor, density, {7850});
        history.endEdit();
        history.endEdit();
        CHECK(history.undoName() == "Steel as measured");
    }
    SECTION("overlapping gestures") {
        processor.view().parameters.beginChange(youngsModulus);
        processor.view().parameters.change(youngsModulus, 200);
        processor.view().parameters.beginChange(density);
        processor.view().parameters.change(density, 7850);
        processor.view().parameters.endChange(youngsModulus);
        processor.view().parameters.endChange(density);
        CHECK(history.undoName() == "2 parameters");
    }
    history.undo();
    CHECK(valuesOf(processor) == before);
    CHECK_FALSE(history.canUndo());
    history.redo();
    CHECK(processor.view().parameters.value(youngsModulus) == 200);
    CHECK(processor.view().parameters.value(density) == 7850);
}

TEST_CASE("Automation during a gesture and between steps is neither a step nor undone") {
    Processor processor;
    auto& history = processor.windowSession().history;
    auto* automated = processor.getParameters()[static_cast<int>(level)];
    const double before = processor.view().parameters.value(density);
    processor.view().parameters.beginChange(density);
    processor.view().parameters.change(density, 1000);
    automated->setValue(0.25f);
    processor.view().parameters.endChange(density);
    const double level25 = processor.view().parameters.value(level);
    automated->setValue(0.5f);
    const double level50 = processor.view().parameters.value(level);
    CHECK(level25 != level50);
    history.undo();
    CHECK(processor.view().parameters.value(density) == before);
    CHECK(processor.view().parameters.value(level) == level50);
    CHECK_FALSE(history.canUndo());
}

TEST_CASE("An undone parameter is sent to the host as a gesture") {
    GestureLog listener;
    Processor processor;
    drag(processor, density, {1000});
    processor.addListener(&listener);
    processor.windowSession().history.undo();
    processor.removeListener(&listener);
    CHECK(listener.text == "(=)");
}

TEST_CASE("A state loaded during a gesture or an audition is not changed when either ends") {
    Processor processor;
    auto& history = processor.windowSession().history;
    processor.view().parameters.beginChange(density);
    processor.view().parameters.change(density, 1000);
    restore(processor, testState());
    processor.view().parameters.change(density, 1500);
    processor.view().parameters.endChange(density);
    history.undo();
    CHECK(processor.view().parameters.value(density) == testState().parameters[density]);

    REQUIRE(processor.view().presets.auditionPreset(factoryPresetId(factoryPresets()[2].name)));
    restore(processor, testState());
    const auto before = saved(processor);
    processor.view().presets.endAudition();
    processor.view().presets.keepAudition();
    CHECK(saved(processor) == before);
}

TEST_CASE("A window that closes during a gesture leaves one complete step") {
    Processor processor;
    auto& history = processor.windowSession().history;
    processor.view().parameters.beginChange(density);
    processor.view().parameters.change(density, 1000);
    history.beginEdit("never ended");
    history.endAllGestures();
    drag(processor, tau, {1});
    CHECK(history.undoName() == "Truncation threshold");
    history.undo();
    history.undo();
    CHECK_FALSE(history.canUndo());
    history.endEdit(); // no edit was begun
    drag(processor, tau, {1});
    CHECK(history.canUndo());
}

TEST_CASE("A and B are two complete sounds, and B begins as a copy of A") {
    Processor processor;
    auto& variants = processor.view().variants;
    drag(processor, density, {1000});
    const auto a = valuesOf(processor);
    CHECK_FALSE(variants.playsB());
    variants.compare();
    CHECK(variants.playsB());
    CHECK(valuesOf(processor) == a);
    load(processor, 5);
    drag(processor, density, {2000});
    const auto b = saved(processor);
    variants.compare();
    CHECK_FALSE(variants.playsB());
    CHECK(valuesOf(processor) == a);
    CHECK(processor.getCurrentProgram() == 0);
    variants.compare();
    CHECK(saved(processor) == b);

    variants.copyToOther();
    variants.compare();
    CHECK(saved(processor) == b);
    processor.windowSession().history.undo();
    processor.windowSession().history.undo(); // the copy
    variants.compare();
    CHECK(valuesOf(processor) == a);
}

TEST_CASE("A mutation is one step, repeats with the same seed, and keeps the instrument") {
    Processor processor;
    const auto instrument = processor.soundSession().instrument();
    const auto before = valuesOf(processor);
    processor.view().variants.mutate(0.5, 9);
    const auto once = valuesOf(processor);
    CHECK_FALSE(once == before);
    CHECK(processor.soundSession().instrument() == instrument);
    processor.windowSession().history.undo();
    CHECK(valuesOf(processor) == before);
    processor.view().variants.mutate(0.5, 9);
    CHECK(valuesOf(processor) == once);
}

TEST_CASE("Compare, copy and mutate first keep the preset of an audition") {
    Processor processor;
    auto& variants = processor.view().variants;
    const auto audition = [&](std::size_t preset) {
        REQUIRE(processor.view().presets.auditionPreset(
            factoryPresetId(factoryPresets()[preset].name)));
    };
    audition(3);
    variants.copyToOther();
    CHECK(processor.getCurrentProgram() == 3);
    audition(4);
    variants.compare();
    CHECK(processor.getCurrentProgram() == 3);
    variants.compare();
    CHECK(processor.getCurrentProgram() == 4);
    audition(5);
    const auto instrument = processor.soundSession().instrument();
    variants.mutate(0.5, 9);
    CHECK(processor.soundSession().instrument() == instrument);
    processor.windowSession().history.undo(); // the mutation
    CHECK(processor.getCurrentProgram() == 5);
    processor.windowSession().history.undo(); // the audition
    CHECK(processor.getCurrentProgram() == 4);
}

TEST_CASE("Auditioned presets are one step if kept, and no step otherwise") {
    Processor processor;
    auto& history = processor.windowSession().history;
    auto& shelf = processor.view().presets;
    drag(processor, density, {1000});
    const auto before = saved(processor);
    for (const std::size_t preset : {1, 2, 3})
        REQUIRE(shelf.auditionPreset(factoryPresetId(factoryPresets()[preset].name)));
    CHECK(processor.getCurrentProgram() == 3);
    SECTION("kept") {
        shelf.keepAudition();
        CHECK(processor.getCurrentProgram() == 3);
        CHECK(history.undoName() == factoryPresets()[3].name);
        history.undo();
        CHECK(saved(processor) == before);
        CHECK(history.undoName() == "Density");
    }
    SECTION("not kept") {
        shelf.endAudition();
        CHECK(saved(processor) == before);
        CHECK(history.undoName() == "Density");
        CHECK_FALSE(history.canRedo());
    }
}
