// Tests of the list of learned MIDI controllers, and of the end of a pending learn.
#include "Editor/ControllerList.h"

#include "Editor/EditorWindow.h"
#include "Editor/OpenWindow.h"
#include "Editor/WindowParts.h"
#include "Plugin/FactoryPrograms.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <cstdint>
#include <initializer_list>
#include <utility>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

/// Assigns controllers, in the order of the test's choice.
void assign(Processor& processor,
            std::initializer_list<std::pair<ParameterId, std::int8_t>> wanted) {
    ControllerAssignments assignments;
    for (const auto& [parameter, number] : wanted)
        assignments[parameter] = number;
    processor.windowSession().controllers.assign(assignments);
}

void chooseListIn(const juce::PopupMenu& menu) {
    for (juce::PopupMenu::MenuItemIterator item(menu); item.next();)
        if (item.getItem().text == "MIDI controllers...")
            item.getItem().action();
}

juce::StringArray rowsOf(ControllerList& list) {
    juce::StringArray rows;
    visit(list, [&](juce::Component& part) {
        if (part.getTitle().contains(" moves "))
            rows.add(part.getTitle());
    });
    return rows;
}

} // namespace

TEST_CASE("The list shows each learned controller by its number, and a button removes one") {
    Processor processor;
    processor.prepareToPlay(48000, 64);
    const auto window = open(processor);
    window->setSize(1180, 860);
    auto& list = *find<ControllerList>(*window, "MIDI controllers");
    auto& deck = *find<PageDeck>(*window, "Pages");
    assign(processor, {{density, 74}, {tau, 21}, {size, 74}});
    CHECK_FALSE(list.isVisible());
    dynamic_cast<ControlHost&>(*window).showControllers();
    CHECK(list.isVisible());
    CHECK_FALSE(deck.isVisible());
    CHECK(rowsOf(list) == juce::StringArray{"Controller 21 moves Truncation threshold",
                                            "Controller 74 moves Size",
                                            "Controller 74 moves Density"});
    find<juce::Button>(list, "Remove controller 74 from Size")->onClick();
    CHECK_FALSE(processor.windowSession().controllers.controllerOf(size));
    list.refresh();
    CHECK(rowsOf(list).size() == 2);
    CHECK(list.keyPressed(juce::KeyPress(juce::KeyPress::escapeKey)));
    CHECK_FALSE(list.isVisible());
    CHECK(deck.isVisible());
}

TEST_CASE("Without controllers the list says how to learn one, and then for what it waits") {
    Processor processor;
    ControllerList list(processor.view());
    list.setSize(500, 300);
    list.setVisible(true);
    const auto hint = [&] {
        list.refresh();
        return find<juce::Label>(list, "Hint")->getText();
    };
    CHECK(rowsOf(list).isEmpty());
    CHECK(hint().startsWith("To add one, right-click"));
    processor.windowSession().controllers.learnController(density);
    CHECK(hint() == "Move the MIDI controller to assign to Density");
}

TEST_CASE("A pending learn ends with the preset and with the window") {
    Processor processor;
    auto& controllers = processor.windowSession().controllers;
    auto window = open(processor);
    auto& list = *find<ControllerList>(*window, "MIDI controllers");
    controllers.learnController(density);
    list.refresh();
    CHECK(controllers.learningParameter() == density);
    REQUIRE(processor.view().presets.loadPreset(factoryPresetId("Marimba")));
    runTimersUntil([&] { return !controllers.learningParameter(); });
    controllers.learnController(tau);
    window.reset();
    CHECK_FALSE(controllers.learningParameter());
}

TEST_CASE("A pending learn goes on when the preset's objects are built anew") {
    Processor processor;
    auto& controllers = processor.windowSession().controllers;
    ControllerList list(processor.view());
    controllers.learnController(density);
    list.refresh();
    const int before = processor.view().instrument.instrumentNumber();
    processor.view().workshop.setStrikePath(0, {{0, 0, 0}, {0.05, 0, 0}});
    CHECK(processor.view().instrument.instrumentNumber() != before);
    list.refresh();
    CHECK(controllers.learningParameter() == density);
}

TEST_CASE("The menu of a control opens the list, and the preset browser closes it") {
    Processor processor;
    const auto window = open(processor);
    auto& list = *find<ControllerList>(*window, "MIDI controllers");
    ParameterControl* control = nullptr;
    visit(*window, [&](juce::Component& part) {
        if (auto* found = dynamic_cast<ParameterControl*>(&part); found && control == nullptr)
            control = found;
    });
    REQUIRE(control != nullptr);
    chooseListIn(control->menu());
    CHECK(list.isVisible());
    dynamic_cast<EditorWindow&>(*window).setBrowsing(true);
    CHECK_FALSE(list.isVisible());
    ParameterControl alone(parameterInfo(density), processor.view());
    const auto menuAlone = alone.menu();
    for (juce::PopupMenu::MenuItemIterator item(menuAlone); item.next();)
        CHECK(item.getItem().text != "MIDI controllers...");
}

TEST_CASE("The list opens in place of the preset browser, and a dropped file in place of both") {
    Processor processor;
    EditorWindow window(processor, processor.view());
    auto& list = *find<ControllerList>(window, "MIDI controllers");
    auto& browser = *find<PresetBrowser>(window, "Preset browser");
    auto& deck = *find<PageDeck>(window, "Pages");
    window.setBrowsing(true);
    CHECK_FALSE(deck.isVisible());
    chooseListIn(find<ParameterControl>(window, "Volume")->menu());
    CHECK(list.isVisible());
    CHECK_FALSE(browser.isVisible());
    CHECK_FALSE(deck.isVisible());
    // The focus may be anywhere in the window, as after a menu.
    CHECK(window.keyPressed(juce::KeyPress(juce::KeyPress::escapeKey)));
    CHECK(deck.isVisible());
    CHECK_FALSE(list.isVisible());
    CHECK_FALSE(browser.isVisible());
    CHECK_FALSE(window.keyPressed(juce::KeyPress(juce::KeyPress::escapeKey)));

    for (const char* file : {"/nowhere/teapot.obj", "/nowhere/meantone.scl"})
        for (const bool browses : {false, true}) {
            INFO(file << ", " << browses);
            browses ? window.setBrowsing(true) : window.showControllers();
            CHECK_FALSE(deck.isVisible());
            window.filesDropped({file}, 5, 5);
            CHECK(deck.isVisible());
            CHECK_FALSE(list.isVisible());
            CHECK_FALSE(browser.isVisible());
        }
}
