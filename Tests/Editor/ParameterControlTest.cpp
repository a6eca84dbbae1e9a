// Tests of the controls of parameters: what they show, what is typed, and one step for one drag.
#include "Editor/ParameterControl.h"

#include "Editor/EditorWindow.h"
#include "Editor/MaterialPad.h"
#include "Editor/Mouse.h"
#include "Editor/OpenWindow.h"
#include "Editor/VelocityGraph.h"
#include "Editor/WindowParts.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/FactoryPrograms.h"
#include "Support/GestureLog.h"
#include "Support/UserSettings.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

namespace {

/// A processor with a window, and how to look at both.
struct Opened {
    Opened() { window->setSize(1900, 1000); }

    template <class Kind>
    Kind& part(const juce::String& title) {
        return test::part<Kind>(*window, title);
    }
    double value(ParameterId parameter) {
        return processor.view().parameters.effectiveValue(parameter);
    }
    ParameterValues values() { return processor.soundSession().loadedSound().parameters; }
    void load(const char* preset) {
        REQUIRE(processor.view().presets.loadPreset(factoryPresetId(preset)));
    }

    UserSettings user;
    Processor processor;
    std::unique_ptr<juce::AudioProcessorEditor> window = open(processor);
    SoundHistory& history = processor.windowSession().history;
};

} // namespace

TEST_CASE("Figures of physics show 0 to 100 until units are switched on, and the switch is kept") {
    Opened opened;
    opened.load("Steel Plate");
    auto& shown = opened.part<juce::Label>("Stiffness");
    runTimersUntil([&] { return shown.getText() == "86"; }); // of 0.01 to 1000 GPa
    auto& units = opened.part<juce::Button>("Units");
    units.setToggleState(true, juce::sendNotificationSync);
    CHECK(shown.getText() == "200.0 GPa");
    CHECK(opened.part<juce::Label>("Tune").getText() == "0.0 cents");
    opened.window.reset();
    opened.window = open(opened.processor);
    CHECK(opened.part<juce::Button>("Units").getToggleState());
}

TEST_CASE("A typed number follows the display, and a number with a unit is physical") {
    Opened opened;
    auto& stiffness = opened.part<juce::Label>("Stiffness");
    stiffness.setText("50", juce::sendNotificationSync);
    CHECK(opened.value(youngsModulus) == Approx(std::sqrt(0.01 * 1000)));
    CHECK(stiffness.getText() == "50");
    stiffness.setText("70 GPa", juce::sendNotificationSync);
    CHECK(opened.value(youngsModulus) == 70);
    stiffness.setText("500 MPa", juce::sendNotificationSync);
    CHECK(opened.value(youngsModulus) == Approx(0.5));
    stiffness.setText("3 kg", juce::sendNotificationSync);
    CHECK(opened.value(youngsModulus) == Approx(0.5));
    auto& units = opened.part<juce::Button>("Units");
    units.setToggleState(true, juce::sendNotificationSync);
    stiffness.setText("50", juce::sendNotificationSync);
    CHECK(opened.value(youngsModulus) == 50);
}

TEST_CASE("A double click resets a control to the preset's value, in one step") {
    Opened opened;
    opened.load("Steel Plate");
    const auto checkReset = [&](ParameterId parameter, double moved, juce::Point<float> share) {
        auto& slider = opened.part<juce::Slider>(parameterInfo(parameter).name);
        opened.processor.view().parameters.changeOnce(parameter, moved);
        runTimersUntil([&] { return slider.getValue() == moved; });
        doubleClickOn(slider, slider.getLocalBounds().toFloat().getRelativePoint(share.x, share.y));
        const double wanted = factoryPresets()[3].parameters[parameter];
        CHECK(wanted != parameterInfo(parameter).defaultValue);
        CHECK(opened.value(parameter) == wanted);
        opened.history.undo();
        CHECK(opened.value(parameter) == moved);
    };
    // The preset has other values than the table's defaults.
    SECTION("a knob") {
        checkReset(ParameterId::room, 77, {0.5f, 0.5f});
    }
    SECTION("a row's slider, which moves to the click first") {
        checkReset(malletSpeed, 5, {0.9f, 0.5f});
    }
}

TEST_CASE("A knob's arc starts at the preset's value, before any click and after a new preset") {
    Opened opened;
    const auto hasArc = [&](const juce::String& name) {
        auto& knob = opened.part<juce::Slider>(name);
        const auto picture = knob.createComponentSnapshot(knob.getLocalBounds());
        const auto accent = colourOf(knob, LookColour::accent);
        for (int y = 0; y < picture.getHeight(); ++y)
            for (int x = 0; x < picture.getWidth(); ++x)
                if (picture.getPixelAt(x, y) == accent)
                    return true;
        return false;
    };
    const auto checkNoArcs = [&] {
        for (const auto& info : parameterTable())
            if (info.group == std::string_view("Play")) {
                INFO(info.name);
                CHECK_FALSE(hasArc(info.name));
            }
    };
    checkNoArcs();
    opened.load("Thrown Shells");
    auto& room = opened.part<juce::Slider>("Room");
    runTimersUntil([&] { return room.getValue() == 70; });
    checkNoArcs();
    opened.processor.view().parameters.changeOnce(ParameterId::room, 40);
    runTimersUntil([&] { return room.getValue() == 40; });
    CHECK(hasArc("Room"));
}

TEST_CASE(
    "A figure is reset to the one of the preset's material, a setup parameter to its default") {
    Opened opened;
    opened.load("Steel Plate");
    auto& parameters = opened.processor.view().parameters;
    const double steel = parameters.effectiveValue(density);
    parameters.changeOnce(density, 1000);
    CHECK(parameters.presetValue(density) == Approx(steel));
    CHECK(parameters.presetValue(material) == double{ownMaterial});
    parameters.changeOnce(volume, -20);
    CHECK(parameters.presetValue(volume) == parameterInfo(volume).defaultValue);
}

TEST_CASE("One drag is one step and one gesture") {
    Opened opened;
    opened.load("Steel Plate");
    const auto before = opened.values();
    GestureLog host;
    opened.processor.addListener(&host);
    const auto checkStep = [&](const char* name) {
        INFO(name);
        CHECK(opened.history.undoName() == name);
        CHECK(opened.values() != before);
        CHECK(host.text.retainCharacters("(").length() == host.text.retainCharacters(")").length());
        opened.history.undo();
        CHECK(opened.values() == before);
    };
    auto& knob = opened.part<juce::Slider>("Size");
    dragOver(knob, {30, 40}, {30, 10});
    CHECK(host.text.startsWith("(="));
    CHECK(host.text.retainCharacters("()") == "()");
    checkStep("Size");

    auto& row = opened.part<juce::Slider>("Density"); // makes the other figures custom too
    dragOver(row, {20, 8}, {90, 8});
    checkStep("Density");

    auto& pad = opened.part<MaterialPad>("Material pad");
    const auto area = pad.getLocalBounds().toFloat();
    dragOver(pad, area.getRelativePoint(0.1f, 0.8f), area.getRelativePoint(0.6f, 0.3f));
    checkStep("Material");

    auto& graph = opened.part<VelocityGraph>("Velocity graph");
    const auto plot = graph.getLocalBounds().toFloat();
    dragOver(graph, plot.getRelativePoint(0.5f, 0.5f), plot.getRelativePoint(0.3f, 0.2f));
    checkStep("Velocity curve");

    auto& mallet = opened.part<juce::Button>("Yarn mallet");
    mallet.setToggleState(true, juce::sendNotificationSync);
    mallet.onClick();
    checkStep("Mallet");
    opened.processor.removeListener(&host);
}

TEST_CASE("A drag on the map that begins on a material is one step") {
    Opened opened;
    auto& pad = opened.part<MaterialPad>("Material pad");
    const auto before = opened.values();
    // Some press of this row of places hits a dot.
    std::optional<juce::Point<float>> dot;
    for (float x = 0; x < static_cast<float>(pad.getWidth()) && !dot; x += 2)
        for (float y = 0; y < static_cast<float>(pad.getHeight()) && !dot; y += 2) {
            clickOn(pad, {x, y});
            if (opened.processor.view().parameters.value(material) >= double{firstLibraryMaterial})
                dot = juce::Point(x, y);
            opened.history.undo();
        }
    REQUIRE(dot);
    REQUIRE(opened.values() == before);
    dragOver(pad, *dot, *dot + juce::Point<float>(40, 30));
    CHECK(opened.processor.view().parameters.value(material) == double{customMaterial});
    opened.history.undo();
    CHECK(opened.values() == before);
    CHECK_FALSE(opened.history.canUndo());
}

TEST_CASE("A drag in the velocity graph bends the curve through the mouse") {
    Opened opened;
    auto& graph = opened.part<VelocityGraph>("Velocity graph");
    const auto area = graph.getLocalBounds().toFloat();
    CHECK(graph.description().startsWith("At half velocity, 35 %")); // 0.5^1.5
    dragOver(graph, area.getCentre(), area.getRelativePoint(0.5f, 0.9f));
    CHECK(opened.value(velocityCurve) > 2);
    dragOver(graph, area.getCentre(), area.getCentre());
    CHECK(opened.value(velocityCurve) == Approx(1));
    for (const auto corner : {area.getTopLeft(), area.getBottomRight(), area.getTopRight()}) {
        dragOver(graph, area.getCentre(), corner);
        CHECK(std::isfinite(opened.value(velocityCurve)));
    }
    clickOn(graph, area.getCentre());
    graph.mouseDown(mouseAt(graph, area.getTopLeft(), area.getTopLeft(),
                            juce::ModifierKeys::rightButtonModifier));
    CHECK(opened.value(velocityCurve) == Approx(1));
}
