// Tests of texts for screen readers.
#include "Editor/StatusBar.h"

#include "Editor/ControlHint.h"
#include "Editor/EditorWindow.h"
#include "Editor/Look.h"
#include "Editor/QualityPage.h"
#include "Editor/WindowParts.h"
#include "Plugin/Processor.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

juce::String saidOf(juce::Component& component) {
    const auto handler = component.createAccessibilityHandler();
    auto* value = handler->getValueInterface();
    REQUIRE(value != nullptr);
    CHECK(value->isReadOnly());
    return value->getCurrentValueAsString();
}

} // namespace

TEST_CASE("A screen reader can read the status line, including errors") {
    StatusBar bar;
    CHECK(bar.getTitle() == "Status");
    StatusView::Status status;
    status.sentence = "A wok.";
    status.modesMixed = 1;
    bar.show(status);
    CHECK(saidOf(bar) == "A wok.; 1 mode");
    status.sentence = "The wok is missing.";
    status.isError = true;
    status.delaySeconds = 0.25;
    status.lateEvents = 2;
    bar.show(status);
    CHECK(saidOf(bar) == "The wok is missing.; heard 250 ms after the key, 2 late; 1 mode");
}

TEST_CASE("The status line marks a peak that reached the limiter until it is clicked") {
    StatusBar bar;
    StatusView::Status status;
    status.sentence = "A wok.";
    status.peak = 0.5f;
    bar.show(status);
    CHECK(saidOf(bar) == "A wok.; 0 modes");
    status.peak = 0.95f;
    bar.show(status);
    status.peak = 0;
    bar.show(status);
    CHECK(saidOf(bar) == "A wok.; 0 modes; peaked");
    bar.mouseDown(juce::MouseEvent(juce::Desktop::getInstance().getMainMouseSource(), {}, {}, 0, 0,
                                   0, 0, 0, &bar, &bar, {}, {}, {}, 1, false));
    CHECK(saidOf(bar) == "A wok.; 0 modes");
}

TEST_CASE("A hint replaces the sentence while it lasts, but not a new sentence or an error") {
    StatusBar bar;
    StatusView::Status status;
    const auto updatesUntilHint = [&] {
        int updates = 0;
        while (bar.line() != "Show the Play page" && updates < 1000) {
            bar.show(status);
            ++updates;
        }
        return updates;
    };
    status.sentence = "A wok.";
    bar.show(status);
    bar.showHint("Show the Play page");
    CHECK(bar.line() == "A wok.");
    const int afterSentence = updatesUntilHint();
    CHECK(afterSentence > 10);
    bar.showHint({});
    CHECK(bar.line() == "A wok.");
    bar.showHint("Show the Play page");
    CHECK(bar.line() == "Show the Play page");
    CHECK(saidOf(bar) == "A wok.; 0 modes");

    status.sentence = "The wok is missing.";
    status.isError = true;
    bar.show(status);
    CHECK(bar.line() == "The wok is missing.");
    const int afterError = updatesUntilHint();
    CHECK(afterError > afterSentence);
    CHECK(afterError < 1000);
    bar.showHint({});
    CHECK(bar.line() == "The wok is missing.");
}

TEST_CASE(
    "The hint is the tooltip of the part under the mouse or with the focus, the last of both") {
    juce::Component window, plain, elsewhere;
    juce::TextButton outer("outer", "Outer.\n0 to 1"), button("button", "Button");
    juce::Component inner;
    window.addAndMakeVisible(outer);
    window.addAndMakeVisible(button);
    window.addAndMakeVisible(plain);
    outer.addAndMakeVisible(inner);
    ControlHint hint;
    CHECK(hint.find(window, nullptr, nullptr) == "");
    CHECK(hint.find(window, &elsewhere, nullptr) == "");
    CHECK(hint.find(window, &inner, nullptr) == "Outer.; 0 to 1");
    CHECK(hint.find(window, &inner, &button) == "Button"); // Tab came last
    CHECK(hint.find(window, &plain, &button) == "Button"); // no hint there
    CHECK(hint.find(window, &outer, &button) == "Outer.; 0 to 1");
    CHECK(hint.find(window, &outer, nullptr) == "Outer.; 0 to 1");
    CHECK(hint.find(window, nullptr, nullptr) == "");
}

TEST_CASE("A screen reader can read the counts of the quality page") {
    Processor processor;
    Look look;
    QualityPage page(processor.view());
    page.setLookAndFeel(&look);
    SoundFrame frame;
    frame.modesMixed = 12;
    frame.modesDropped = 3;
    frame.modesMerged = 4;
    frame.modesBeyond = 5;
    page.showSound(frame);
    auto* counts = find<juce::Component>(page, "Modes");
    REQUIRE(counts != nullptr);
    CHECK(saidOf(*counts) == "12 sounding, 3 dropped, 4 merged, 5 over budget");
    page.setLookAndFeel(nullptr);
}

TEST_CASE("The status line draws only the visible part of a very long sentence") {
    Look look;
    StatusBar bar;
    bar.setLookAndFeel(&look);
    bar.setSize(900, 24);
    const auto drawn = [&](const std::string& sentence) {
        StatusView::Status status;
        status.sentence = sentence;
        bar.show(status);
        return bar.createComponentSnapshot(bar.getLocalBounds());
    };
    const auto same = [](const juce::Image& one, const juce::Image& other) {
        for (int y = 0; y < one.getHeight(); ++y)
            for (int x = 0; x < one.getWidth(); ++x)
                if (one.getPixelAt(x, y) != other.getPixelAt(x, y))
                    return false;
        return true;
    };
    CHECK_FALSE(same(drawn("A wok."), drawn("Another wok.")));
    std::string text;
    while (text.size() < 50'000'000)
        text += "a wok and ";
    CHECK(same(drawn(text), drawn(text.substr(0, 10'000))));
    bar.setLookAndFeel(nullptr);
}

TEST_CASE("The status line shows the whole hint of every control in the smallest window") {
    Processor processor;
    ControllerAssignments assignments; // each hint also names a controller
    for (const auto& info : parameterTable())
        assignments[info.parameter] = 119;
    processor.windowSession().controllers.assign(assignments);
    EditorWindow window(processor, processor.view());
    window.setSize(WindowSize::minimumWidth, WindowSize::minimumHeight);
    auto& bar = *find<StatusBar>(window, "Status");
    auto& deck = *find<PageDeck>(window, "Pages");
    for (int page = 0; page < deck.pageCount(); ++page) {
        deck.show(page);
        deck.refresh();
        visit(window, [&](juce::Component& part) {
            const auto hint = ControlHint().find(window, &part, nullptr);
            if (hint.isEmpty())
                return;
            auto shown = bar.fitted(hint);
            INFO(hint);
            REQUIRE(shown.getNumGlyphs() > 0);
            CHECK(shown.getGlyph(shown.getNumGlyphs() - 1).getCharacter() ==
                  hint.getLastCharacter());
        });
    }
}
