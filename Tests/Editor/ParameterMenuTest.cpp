#include "Editor/ParameterMenu.h"

#include "Editor/IconButton.h"
#include "Editor/LeftClicked.h"
#include "Editor/Look.h"
#include "Editor/MalletRack.h"
#include "Editor/MaterialPage.h"
#include "Editor/Mouse.h"
#include "Editor/ParameterControl.h"
#include "Editor/WindowParts.h"
#include "Plugin/Processor.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

namespace {

juce::StringArray textsOf(const juce::PopupMenu& menu) {
    juce::StringArray texts;
    for (juce::PopupMenu::MenuItemIterator item(menu); item.next();)
        texts.add(item.getItem().text);
    return texts;
}

/// Runs the first enabled item whose text starts with `beginning`. Returns whether there is one.
bool choose(const juce::PopupMenu& menu, const juce::String& beginning) {
    for (juce::PopupMenu::MenuItemIterator item(menu); item.next();)
        if (item.getItem().text.startsWith(beginning) && item.getItem().isEnabled) {
            item.getItem().action();
            return true;
        }
    return false;
}

juce::PopupMenu menuOf(Processor& processor, ParameterId parameter) {
    return parameterMenu(parameterInfo(parameter), processor.view(), ValueDisplay::plain, {});
}

void play(Processor& processor, int controller, int value) {
    juce::MidiBuffer midi;
    midi.addEvent(juce::MidiMessage::controllerEvent(1, controller, value), 0);
    render(processor, 64, 64, midi);
}

} // namespace

TEST_CASE("The menu shows the value, and sets the preset's or the default in one step") {
    Processor processor;
    auto state = testState();
    state.preset.parameters.set(strikeSpread, 12);
    restore(processor, state);
    processor.view().parameters.change(strikeSpread, 33);
    CHECK(textsOf(menuOf(processor, strikeSpread))[0].contains("33"));
    const auto checkStep = [&](const char* item, double expected) {
        REQUIRE(choose(menuOf(processor, strikeSpread), item));
        CHECK(processor.view().parameters.value(strikeSpread) == expected);
        processor.windowSession().history.undo();
        CHECK(processor.view().parameters.value(strikeSpread) == 33);
        CHECK_FALSE(processor.windowSession().history.canUndo());
    };
    checkStep("Reset to 12.0 %", 12);
    checkStep("Default: 2.0 %", parameterInfo(strikeSpread).defaultValue);
}

TEST_CASE("A reset from the menu is a step with the parameter's name, also with a named material") {
    Processor processor;
    restore(processor, testState());
    processor.view().parameters.changeOnce(material, firstLibraryMaterial + 8); // steel
    REQUIRE(choose(menuOf(processor, youngsModulus), "Default: "));
    CHECK(processor.view().parameters.value(material) == double{customMaterial});
    CHECK(processor.windowSession().history.undoName() == "Stiffness");
    processor.windowSession().history.undo();
    CHECK(processor.view().parameters.value(material) == double{firstLibraryMaterial} + 8);
}

TEST_CASE("The menu and the tooltip of a figure name its units in both displays") {
    Processor processor;
    restore(processor, testState());
    processor.view().parameters.change(material, customMaterial);
    processor.view().parameters.change(youngsModulus, 100);
    const auto& info = parameterInfo(youngsModulus);
    const auto header = [&](ValueDisplay display) {
        return textsOf(parameterMenu(info, processor.view(), display, {}))[0];
    };
    CHECK(header(ValueDisplay::plain) == "Stiffness: 80 (100.0 GPa)");
    CHECK(header(ValueDisplay::units) == "Stiffness: 100.0 GPa");
    CHECK(parameterTooltip(info, ValueDisplay::plain)
              .endsWith("\n0 to 100 (0.01000 GPa to 1000 GPa)"));
    CHECK(parameterTooltip(info, ValueDisplay::units).endsWith("\n0.01000 GPa to 1000 GPa"));
}

TEST_CASE("The list of materials and the rack of mallets have the menu of their parameter") {
    Processor processor;
    restore(processor, testState());
    auto& parameters = processor.view().parameters;
    auto& midi = processor.windowSession().controllers;
    MaterialPage page(processor.view());
    parameters.changeOnce(material, firstLibraryMaterial + 8);
    REQUIRE(choose(page.materialMenu(), "Reset to Own"));
    CHECK(parameters.value(material) == double{ownMaterial});
    CHECK(processor.windowSession().history.undoName() == "Material");
    auto* list = find<ChoiceList>(page, "Material");
    REQUIRE(list != nullptr);
    REQUIRE(choose(page.materialMenu(), "Learn"));
    CHECK(midi.learningParameter() == material);
    page.refresh();
    CHECK(list->getTooltip().contains("Move the MIDI controller"));

    MalletRack rack(processor.view());
    rack.setSize(600, 60);
    const double before = parameters.value(mallet);
    auto& yarn = *find<juce::Button>(rack, "Yarn mallet");
    parameters.changeOnce(mallet, firstRackMallet + 1);
    REQUIRE(choose(rack.menu(), "Reset to "));
    CHECK(parameters.value(mallet) == before);
    REQUIRE(choose(rack.menu(), "Learn"));
    CHECK(midi.learningParameter() == mallet);
    rack.refresh();
    CHECK(yarn.getTooltip() == "Take the yarn mallet\nMove the MIDI controller to assign to this "
                               "parameter");
    midi.stopLearning();
    rack.refresh();
    CHECK(yarn.getTooltip() == "Take the yarn mallet");

    const auto press = [](juce::Component& part, int button) {
        part.mouseDown(mouseAt(part, {9, 9}, {9, 9}, button));
        part.mouseUp(mouseAt(part, {9, 9}, {9, 9}, button));
    };
    parameters.changeOnce(mallet, firstRackMallet + 1);
    rack.refresh();
    press(yarn, juce::ModifierKeys::rightButtonModifier); // opens only the menu
    CHECK(parameters.value(mallet) == double{firstRackMallet} + 1);
    press(yarn, juce::ModifierKeys::leftButtonModifier);
    CHECK(parameters.value(mallet) == double{firstRackMallet});
}

TEST_CASE("The menu learns, names and forgets a controller") {
    Processor processor;
    processor.prepareToPlay(48000, 64);
    REQUIRE(choose(menuOf(processor, tau), "Learn"));
    CHECK(processor.windowSession().controllers.learningParameter() == tau);
    CHECK(controllerSentence(parameterInfo(tau), processor.windowSession().controllers)
              .startsWith("Move the"));
    REQUIRE(choose(menuOf(processor, tau), "Stop waiting"));
    CHECK_FALSE(processor.windowSession().controllers.learningParameter());
    REQUIRE(choose(menuOf(processor, tau), "Learn"));
    play(processor, 21, 64);
    CHECK(controllerSentence(parameterInfo(tau), processor.windowSession().controllers) ==
          "Moved by MIDI controller 21");
    CHECK(
        controllerSentence(parameterInfo(level), processor.windowSession().controllers).isEmpty());
    REQUIRE(choose(menuOf(processor, tau), "Forget MIDI controller 21"));
    CHECK_FALSE(processor.windowSession().controllers.controllerOf(tau));
    CHECK_FALSE(choose(menuOf(processor, tau), "Forget"));
}

TEST_CASE("A control's tooltip says when it learns, and then names the controller") {
    Processor processor;
    processor.prepareToPlay(48000, 64);
    Look look;
    ParameterControl control(parameterInfo(density), processor.view());
    control.setLookAndFeel(&look);
    control.setSize(180, 40);
    const auto labelText = [&] {
        juce::String text;
        visit(control, [&](juce::Component& part) {
            if (auto* label = dynamic_cast<juce::Label*>(&part);
                label != nullptr && label->getTooltip().contains("Density"))
                text = label->getTooltip();
        });
        return text;
    };
    CHECK_FALSE(labelText().contains("MIDI"));
    processor.windowSession().controllers.learnController(density);
    control.refresh();
    CHECK(labelText().contains("Move the MIDI controller"));
    play(processor, 74, 64);
    control.refresh();
    CHECK(labelText().contains("controller 74"));
    CHECK(control.getDescription().contains("controller 74"));
    control.setLookAndFeel(nullptr);
}

TEST_CASE("The right button does not change a control") {
    Processor processor;
    LeftClicked<juce::ToggleButton> toggle;
    toggle.setSize(40, 20);
    const auto right = juce::ModifierKeys(juce::ModifierKeys::rightButtonModifier);
    const juce::MouseEvent event(juce::Desktop::getInstance().getMainMouseSource(), {5, 5}, right,
                                 0, 0, 0, 0, 0, &toggle, &toggle, {}, {5, 5}, {}, 1, false);
    toggle.mouseDown(event);
    toggle.mouseUp(event);
    CHECK_FALSE(toggle.getToggleState());
    CHECK(toggle.getState() == juce::Button::buttonNormal);
}

TEST_CASE("Shift+F10 opens the menu; other keys do not") {
    using juce::KeyPress;
    CHECK(asksForMenu({KeyPress::F10Key, juce::ModifierKeys::shiftModifier, 0}));
    CHECK_FALSE(asksForMenu(KeyPress(KeyPress::F10Key)));
    CHECK_FALSE(asksForMenu(KeyPress('m')));
}

TEST_CASE("A button with a menu opens it on each menu key") {
    IconButton button("Mutate", {});
    int shown = 0;
    button.onMenu = [&] { ++shown; };
    CHECK(button.keyPressed({juce::KeyPress::F10Key, juce::ModifierKeys::shiftModifier, 0}));
    CHECK(shown == 1);
#if JUCE_LINUX
    CHECK(button.keyPressed(juce::KeyPress(0x10000067)));
    CHECK(shown == 2);
#endif
}

TEST_CASE("A drag ends when the last button is released, whichever button that is") {
    struct Noting : juce::Component {
        void mouseDown(const juce::MouseEvent&) override { heard += "("; }
        void mouseDrag(const juce::MouseEvent&) override { heard += "="; }
        void mouseUp(const juce::MouseEvent&) override { heard += ")"; }
        std::string heard;
    };
    LeftClicked<Noting> control;
    const auto event = [&](int buttons) {
        return juce::MouseEvent(juce::Desktop::getInstance().getMainMouseSource(), {}, buttons, 0,
                                0, 0, 0, 0, &control, &control, {}, {}, {}, 1, true);
    };
    constexpr int left = juce::ModifierKeys::leftButtonModifier,
                  right = juce::ModifierKeys::rightButtonModifier;
    control.mouseDown(event(left));
    control.mouseDrag(event(left | right));
    control.mouseUp(event(right));
    CHECK(control.heard == "(=)");
    control.mouseDown(event(right));
    control.mouseDrag(event(right));
    control.mouseUp(event(left));
    CHECK(control.heard == "(=)");
}
