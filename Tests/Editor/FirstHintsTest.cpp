// Tests of the hints of the first start.
#include "Editor/FirstHints.h"

#include "Editor/OpenWindow.h"
#include "Editor/Preferences.h"
#include "Editor/WindowParts.h"
#include "Support/UserSettings.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

struct Picture {
    Look look;
    juce::Component parent;
    FirstHints hints;

    Picture() {
        parent.setLookAndFeel(&look);
        parent.setSize(900, 300);
        parent.addChildComponent(hints);
    }
    ~Picture() { parent.setLookAndFeel(nullptr); }

    /// Runs the timer until the current hint has gone.
    void fadeOut() {
        const auto before = hints.description();
        hints.fade();
        runTimersUntil([&] { return !hints.isRunning() || hints.description() != before; });
    }
};

} // namespace

TEST_CASE("The hints follow each other, each fades on a click, and none stays") {
    Picture picture;
    auto& hints = picture.hints;
    CHECK_FALSE(hints.isVisible());
    hints.start();
    for (const auto* text : FirstHints::texts) {
        CHECK(hints.isVisible());
        CHECK(hints.description() == text);
        picture.fadeOut();
    }
    CHECK_FALSE(hints.isVisible());
    CHECK_FALSE(hints.isRunning()); // no timer at rest
    hints.fade();
    CHECK_FALSE(hints.isRunning());
}

TEST_CASE("A hint lies inside the picture at any size and takes no clicks") {
    Picture picture;
    picture.hints.start();
    for (const int width : {300, 388, 900, 3000}) {
        picture.parent.setSize(width, 300);
        CHECK(picture.parent.getLocalBounds().contains(picture.hints.getBounds()));
        const auto middle = picture.hints.getBounds().getCentre();
        CHECK(picture.parent.getComponentAt(middle) != &picture.hints);
    }
}

TEST_CASE("A screen reader can read a hint, which fades visibly") {
    Picture picture;
    picture.hints.start();
    const auto handler = picture.hints.createAccessibilityHandler();
    REQUIRE(handler->getValueInterface() != nullptr);
    CHECK(handler->getValueInterface()->getCurrentValueAsString() == FirstHints::texts[0]);
    const auto opacity = [&] {
        const auto shot = picture.hints.createComponentSnapshot(picture.hints.getLocalBounds());
        return int(shot.getPixelAt(shot.getWidth() / 2, 4).getAlpha());
    };
    const int before = opacity();
    picture.hints.fade();
    CHECK(opacity() < before);
    CHECK(opacity() > 0);
}

TEST_CASE("The preferences remember that the hints were seen") {
    const UserSettings user;
    CHECK_FALSE(Preferences().areHintsSeen());
    Preferences().setHintsSeen();
    CHECK(Preferences().areHintsSeen());
}

TEST_CASE("A window that is not on a screen shows no hints") {
    const UserSettings user;
    Processor processor;
    const auto window = open(processor);
    auto& name = *find<juce::Button>(*window, "Preset");
    processor.setCurrentProgram(1);
    runTimersUntil([&] { return name.getButtonText() == processor.getProgramName(1); });
    FirstHints* hints = nullptr;
    visit(*window, [&](juce::Component& part) {
        if (auto* found = dynamic_cast<FirstHints*>(&part))
            hints = found;
    });
    REQUIRE(hints != nullptr);
    CHECK_FALSE(hints->isVisible());
    CHECK_FALSE(Preferences().areHintsSeen());
}
