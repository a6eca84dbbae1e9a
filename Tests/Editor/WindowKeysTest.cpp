// Tests of mouse wheel and keys: one gesture and one step each, and Tab reaches everything.
#include "Editor/EditorWindow.h"
#include "Editor/MaterialPad.h"
#include "Editor/MaterialPage.h"
#include "Editor/OpenWindow.h"
#include "Editor/WindowParts.h"
#include "Support/GestureLog.h"
#include "Support/TestSound.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <juce_gui_basics/juce_gui_basics.h>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

TEST_CASE("A turn of the wheel or a held arrow key is one gesture and one step") {
    Processor processor;
    auto window = open(processor);
    auto* pad = find<MaterialPad>(*window, "Material pad");
    REQUIRE(pad != nullptr);
    GestureLog host;
    processor.addListener(&host);
    const double before = processor.view().parameters.value(ParameterId::level);
    auto* level = find<juce::Slider>(*window, "Preset level");
    REQUIRE(level != nullptr);
    const auto source = juce::Desktop::getInstance().getMainMouseSource();
    const auto at = level->getLocalBounds().getCentre().toFloat();
    for (int notch = 0; notch < 3; ++notch)
        level->mouseWheelMove({source,
                               at,
                               {},
                               0,
                               0,
                               0,
                               0,
                               0,
                               level,
                               level,
                               juce::Time(1000 + notch),
                               at,
                               {},
                               0,
                               false},
                              {.deltaX = 0,
                               .deltaY = -0.1f,
                               .isReversed = false,
                               .isSmooth = false,
                               .isInertial = false});
    CHECK(processor.view().parameters.value(ParameterId::level) < before);
    CHECK(host.text.startsWith("(="));
    CHECK_FALSE(host.text.contains(")"));
    runTimersUntil([&] { return host.text.endsWithChar(')'); });
    CHECK(host.text.retainCharacters("()") == "()");
    processor.removeListener(&host);
    processor.windowSession().history.undo();
    CHECK(processor.view().parameters.value(ParameterId::level) == before);
    CHECK_FALSE(processor.windowSession().history.canUndo());

    const double densityBefore = processor.view().parameters.effectiveValue(ParameterId::density);
    for (int press = 0; press < 3; ++press)
        pad->keyPressed(juce::KeyPress(juce::KeyPress::rightKey));
    CHECK(processor.view().parameters.effectiveValue(ParameterId::density) != densityBefore);
    processor.windowSession().history.undo();
    CHECK(processor.view().parameters.effectiveValue(ParameterId::density) == densityBefore);
    CHECK_FALSE(processor.windowSession().history.canUndo());
}

TEST_CASE("Changing a figure that makes the material custom is one step, and undo restores it") {
    Processor processor;
    auto window = open(processor);
    auto* slider = find<juce::Slider>(*window, "Density");
    REQUIRE(slider != nullptr);
    const double before = processor.view().parameters.effectiveValue(ParameterId::density);
    for (int press = 0; press < 3; ++press)
        slider->keyPressed(juce::KeyPress(juce::KeyPress::upKey));
    const double after = processor.view().parameters.effectiveValue(ParameterId::density);
    CHECK(after > before);
    auto& history = processor.windowSession().history;
    history.undo(); // in the middle of the burst
    CHECK(processor.view().parameters.effectiveValue(ParameterId::density) == before);
    CHECK_FALSE(history.canUndo());
    history.redo();
    CHECK(processor.view().parameters.effectiveValue(ParameterId::density) == after);
    CHECK(processor.view().parameters.value(ParameterId::material) == double{customMaterial});
}

TEST_CASE("Tab reaches each enabled control once, and arrows move the focused one") {
    Processor processor;
    const auto window = open(processor);
    window->setSize(1180, 860);
    const auto order = window->createKeyboardFocusTraverser()->getAllComponents(window.get());
    visit(*window, [&](juce::Component& part) {
        const bool isUsed = dynamic_cast<juce::Slider*>(&part) != nullptr ||
                            dynamic_cast<juce::Button*>(&part) != nullptr ||
                            dynamic_cast<juce::ComboBox*>(&part) != nullptr;
        if (!isUsed || !isOnScreen(part, *window) || !part.isEnabled())
            return;
        INFO(part.getTitle() << " (" << typeid(part).name() << ")");
        CHECK(std::ranges::count(order, &part) == 1);
    });
    for (const auto parameter : {ParameterId::density, ParameterId::tau, ParameterId::lossFactor,
                                 ParameterId::bendRange}) {
        const auto& info = parameterInfo(parameter);
        INFO(info.name);
        auto* slider = find<juce::Slider>(*window, info.name);
        REQUIRE(slider != nullptr);
        const auto placeNow = [&] {
            return info.toNormalised(processor.view().parameters.effectiveValue(parameter));
        };
        const double before = placeNow();
        CHECK(slider->keyPressed(juce::KeyPress(juce::KeyPress::upKey)));
        const double step =
            std::max(0.01, info.scale == ParameterScale::steps ? 1 / info.maximum : 0);
        CHECK(placeNow() == Approx(before + step));
        CHECK(slider->keyPressed(juce::KeyPress(juce::KeyPress::leftKey)));
        CHECK(placeNow() == Approx(before));
        CHECK(slider->keyPressed(juce::KeyPress(juce::KeyPress::endKey)));
        CHECK(placeNow() == 1);
        CHECK_FALSE(slider->keyPressed(juce::KeyPress('x')));
        auto* value = find<juce::Label>(*window, info.name);
        REQUIRE(value != nullptr);
        CHECK(slider->keyPressed(juce::KeyPress(juce::KeyPress::returnKey)));
        CHECK(value->isBeingEdited());
        value->hideEditor(true);
    }
}
