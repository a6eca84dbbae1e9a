// Tests of the window's scale: what grows, what stays, and its limits.
#include "Editor/WindowScale.h"

#include "Editor/EditorWindow.h"
#include "Editor/OpenWindow.h"
#include "Editor/WindowParts.h"
#include "Support/UserSettings.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

struct ScaledWindow {
    UserSettings user;
    Processor processor;
    juce::Component host;
    EditorWindow window{processor, processor.view()};

    ScaledWindow() {
        window.setSize(1000, 600);
        host.setSize(5000, 3000);
        host.setVisible(true);
        host.addAndMakeVisible(window);
    }
    juce::Rectangle<int> onScreen() { return host.getLocalArea(&window, window.getLocalBounds()); }
};

} // namespace

TEST_CASE("A scale enlarges everything in the window and keeps its layout") {
    ScaledWindow shown;
    auto* volume = find<juce::Slider>(shown.window, "Volume");
    REQUIRE(volume != nullptr);
    const auto before = shown.window.getLocalArea(volume, volume->getLocalBounds());
    for (const int percent : ScaleButton::percents) {
        shown.window.setScale(percent);
        CHECK(shown.window.getWidth() == 1000);
        CHECK(shown.onScreen().getWidth() == 10 * percent);
        CHECK(shown.onScreen().getHeight() == 6 * percent);
        CHECK(shown.window.getLocalArea(volume, volume->getLocalBounds()) == before);
        CHECK(shown.host.getComponentAt(before.getCentre() * percent / 100) == volume);
    }
}

TEST_CASE("The next window opens at the chosen scale and size") {
    const UserSettings user;
    Processor processor;
    const auto scaleOf = [](juce::Component& window) {
        auto* button = find<ScaleButton>(window, "Scale");
        REQUIRE(button != nullptr);
        return button;
    };
    {
        EditorWindow first(processor, processor.view());
        first.setSize(900, 600);
        scaleOf(first)->onScale(125);
    }
    {
        EditorWindow next(processor, processor.view());
        CHECK(next.getTransform().mat00 == Approx(1.25));
        CHECK(next.getWidth() == 900);
        CHECK(scaleOf(next)->getButtonText() == "125 %");
    }
    CHECK(Preferences().scalePercent() == 125);
}

TEST_CASE("The host's scale and the user's multiply, in either order") {
    ScaledWindow shown;
    shown.window.setScaleFactor(2);
    shown.window.setScale(125);
    CHECK(shown.window.getTransform().mat00 == Approx(2.5));
    shown.window.setScaleFactor(1);
    CHECK(shown.window.getTransform().mat00 == Approx(1.25));
}

TEST_CASE("The limits of the size hold before scaling, and for a window around it after") {
    ScaledWindow shown;
    shown.window.setScale(200);
    shown.window.setBoundsConstrained({0, 0, 10, 10});
    CHECK(shown.window.getWidth() == WindowSize::minimumWidth);
    CHECK(shown.window.getHeight() == WindowSize::minimumHeight);

    auto* limits = shown.window.getConstrainer();
    REQUIRE(limits != nullptr);
    CHECK(limits->getMinimumWidth() == WindowSize::minimumWidth); // a VST3 host scales it
    juce::Rectangle<int> around(0, 0, 10, 10);
    limits->checkBounds(around, around, {0, 0, 9000, 9000}, false, false, false, true);
    CHECK(around.getWidth() == 2 * WindowSize::minimumWidth);
    CHECK(around.getHeight() == 2 * WindowSize::minimumHeight);
    shown.window.setScale(75);
    around = {0, 0, 10, 10};
    limits->checkBounds(around, around, {0, 0, 9000, 9000}, false, false, false, true);
    CHECK(around.getWidth() == WindowSize::minimumWidth * 3 / 4);
}

TEST_CASE("A size is limited to the screen at its scale, but not below the minimum") {
    const juce::Rectangle<int> screen(1920, 1040);
    CHECK(WindowSize::within(screen, {0, 0}, 1) ==
          juce::Point(WindowSize::firstWidth, WindowSize::firstHeight));
    CHECK(WindowSize::within(screen, {1800, 900}, 1.5f) == juce::Point(1280, 693));
    CHECK(WindowSize::within(screen, {1800, 1000}, 0.75f) == juce::Point(1800, 1000));
    CHECK(WindowSize::within(screen, {10, 10}, 4) ==
          juce::Point(WindowSize::minimumWidth, WindowSize::minimumHeight));
}

TEST_CASE("Only scales whose smallest window fits the screen can be chosen") {
    ScaleButton button;
    button.show(125);
    std::vector<int> enabled;
    auto menu = button.menu({1366, 740});
    for (juce::PopupMenu::MenuItemIterator item(menu); item.next();) {
        const auto& now = item.getItem();
        CHECK(now.isTicked == (now.text == "125 %"));
        if (now.isEnabled)
            enabled.push_back(now.text.getIntValue());
    }
    CHECK(enabled == std::vector{75, 100, 125});
    int chosen = 0;
    button.onScale = [&](int percent) { chosen = percent; };
    for (juce::PopupMenu::MenuItemIterator item(menu); item.next();)
        if (item.getItem().text == "75 %")
            item.getItem().action();
    CHECK(chosen == 75);
    CHECK(ScaleButton::fitting(200, {1366, 740}) == 125);
    CHECK(ScaleButton::fitting(110, {4000, 3000}) == 100);
    CHECK(ScaleButton::fitting(100, {100, 100}) == 75);
}
