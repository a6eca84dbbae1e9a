// Tests of what the picture shows after a new preset, of the ways to reset the view, and of its
// hint.
#include "Editor/ObjectPane.h"
#include "Editor/WindowParts.h"
#include "Plugin/Processor.h"
#include "Support/PresetNumber.h"

#include <catch2/catch_test_macros.hpp>
#include <memory>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// A view of a preset, with a mouse that turns it.
struct TurnedView {
    Processor processor;
    std::unique_ptr<ObjectView> view;

    explicit TurnedView(const char* preset) {
        processor.setCurrentProgram(presetNumber(preset));
        view = std::make_unique<ObjectView>(processor.view());
        view->setBounds(0, 0, 900, 300);
    }
    juce::MouseEvent at(juce::Point<float> place, juce::ModifierKeys keys) {
        return {juce::Desktop::getInstance().getMainMouseSource(),
                place,
                keys,
                0,
                0,
                0,
                0,
                0,
                view.get(),
                view.get(),
                {},
                {450, 150},
                {},
                1,
                true};
    }
    void turn() {
        view->mouseDown(at({450, 150}, juce::ModifierKeys::rightButtonModifier));
        view->mouseDrag(at({600, 190}, juce::ModifierKeys::rightButtonModifier));
        view->mouseUp(at({600, 190}, juce::ModifierKeys::rightButtonModifier));
        view->mouseWheelMove(at({450, 150}, {}), {0, 0.3f, false, false, false});
    }
    /// The place of the instrument in the middle of the picture.
    ScenePlace middle() {
        view->refresh();
        const auto pick = view->strikeAt({450, 150});
        view->lift();
        REQUIRE(pick);
        return pick->place;
    }
};

} // namespace

TEST_CASE("A new preset is framed from the usual direction; another path keeps the turned view") {
    TurnedView turned("Steel Plate");
    const auto usual = turned.middle();
    turned.turn();
    const auto own = turned.middle();
    CHECK_FALSE(own == usual);
    const int before = turned.processor.view().instrument.instrumentNumber();
    turned.processor.view().workshop.setStrikePath(0, {{0, 0, 0}, {0.05, 0, 0}});
    CHECK(turned.processor.view().instrument.instrumentNumber() != before);
    CHECK(turned.middle() == own);
    turned.processor.setCurrentProgram(presetNumber("Wok"));
    turned.middle();
    turned.processor.setCurrentProgram(presetNumber("Steel Plate"));
    CHECK(turned.middle() == usual);
}

TEST_CASE("The Frame button and a double click beside the instrument reset the view") {
    Processor processor;
    processor.setCurrentProgram(presetNumber("Steel Plate"));
    ObjectPane pane(processor.view());
    pane.setBounds(0, 0, 900, 330);
    auto* frame = find<juce::Button>(pane, "Frame");
    REQUIRE(frame != nullptr);
    TurnedView turned("Steel Plate");
    const auto usual = turned.middle();
    turned.turn();
    turned.view->mouseDoubleClick(turned.at({2, 2}, {}));
    CHECK(turned.middle() == usual);

    auto& picture = pane.picture();
    const auto middle = picture.getLocalBounds().getCentre().toFloat();
    const auto inMiddle = [&] {
        const auto pick = picture.strikeAt(middle);
        picture.lift();
        REQUIRE(pick);
        return pick->place;
    };
    const auto framed = inMiddle();
    picture.mouseWheelMove(turned.at(middle, {}), {0, 0.5f, false, false, false});
    picture.mouseDown(turned.at({450, 150}, juce::ModifierKeys::rightButtonModifier));
    picture.mouseDrag(turned.at({600, 190}, juce::ModifierKeys::rightButtonModifier));
    picture.mouseUp(turned.at({600, 190}, juce::ModifierKeys::rightButtonModifier));
    CHECK_FALSE(inMiddle() == framed);
    frame->onClick();
    CHECK(inMiddle() == framed);
}

TEST_CASE("The picture's hint says what the mouse does there now") {
    TurnedView shown("Steel Plate");
    CHECK(shown.view->getTooltip().startsWith("Click to strike"));
    shown.view->setLayers({.drawsPath = true});
    CHECK(shown.view->getTooltip().contains("draw"));
    shown.processor.setCurrentProgram(presetNumber("Dice on Rosewood"));
    shown.view->refresh();
    REQUIRE(shown.view->isOnStage());
    CHECK(shown.view->getTooltip().contains("bodies"));
}
