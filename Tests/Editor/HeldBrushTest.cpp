// Tests of painting where an object is held, in a picture without OpenGL.
#include "Editor/HeldBrush.h"

#include "Editor/Mouse.h"
#include "Editor/ObjectPane.h"
#include "Editor/WindowParts.h"
#include "Support/ImportedFiles.h"
#include "Support/PresetNumber.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Kind = HeldSettings::Kind;

namespace {

struct Painting {
    Painting() {
        pane.setLookAndFeel(&look);
        pane.setBounds(0, 0, 600, 400);
        play("Steel Plate");
    }
    ~Painting() { pane.setLookAndFeel(nullptr); }

    void play(const char* preset) {
        processor.setCurrentProgram(presetNumber(preset));
        pane.refresh();
    }
    void openPlate() {
        processor.view().workshop.openFile(meshFile("plate.obj", sheetMesh(0.02, 0.012, 60)));
        finish(processor);
        pane.refresh();
    }
    HeldSettings held() { return processor.view().workshop.importStatus().settings.held; }
    void choose(Kind kind) {
        auto settings = processor.view().workshop.importStatus().settings;
        settings.held.kind = kind;
        processor.view().workshop.setImportSettings(settings);
        pane.refresh();
    }
    const ModalObject& object() {
        return *processor.view().instrument.playedObjects().front().object;
    }
    void drag(float fromX, float toX, int keys = 0) {
        auto& picture = pane.picture();
        const auto at = [&](float x) {
            return mouseAt(picture, {x, middle()}, {fromX, middle()},
                           juce::ModifierKeys::leftButtonModifier | keys);
        };
        picture.mouseDown(at(fromX));
        for (int step = 1; step <= 8; ++step)
            picture.mouseDrag(at(fromX + (toX - fromX) * static_cast<float>(step) / 8));
        picture.mouseUp(at(toX));
    }
    float middle() { return static_cast<float>(pane.picture().getHeight()) / 2; }
    juce::Image picture() {
        return pane.picture().createComponentSnapshot(pane.picture().getLocalBounds(), true, 1);
    }
    /// The pixels of about the colour in which held parts are drawn.
    int heldPixels() {
        const auto image = picture();
        const auto colour = colourOf(pane, LookColour::held);
        int count = 0;
        for (int y = 0; y < image.getHeight(); ++y)
            for (int x = 0; x < image.getWidth(); ++x)
                count += std::abs(image.getPixelAt(x, y).getHue() - colour.getHue()) < 0.03f &&
                         image.getPixelAt(x, y).getSaturation() > 0.3f;
        return count;
    }

    Look look;
    Processor processor;
    ObjectPane pane{processor.view()};
};

} // namespace

TEST_CASE("The choice of a painted region takes up the brush") {
    Painting painting;
    auto& shown = *find<juce::Button>(painting.pane, "Held");
    CHECK_FALSE(shown.getToggleState());
    painting.choose(Kind::places);
    CHECK(shown.getToggleState());
    CHECK(painting.pane.picture().getTooltip().contains("hold it there"));
    painting.choose(Kind::free);
    CHECK_FALSE(painting.pane.picture().getTooltip().contains("hold it there"));
}

TEST_CASE("A drag over the object holds it there and analyses it, a drag with Shift frees it") {
    Painting painting;
    painting.openPlate();
    painting.choose(Kind::places);
    CHECK_FALSE(painting.processor.view().workshop.importStatus().isWorking()); // nothing is held
    const int before = painting.heldPixels();
    painting.drag(250, 350);
    CHECK(painting.held().places.size() > 2);
    CHECK(painting.processor.view().workshop.importStatus().isWorking());
    CHECK(painting.heldPixels() > before + 50);
    painting.drag(240, 370, juce::ModifierKeys::shiftModifier);
    CHECK(painting.held().places.empty());
    CHECK(painting.held().kind == Kind::places);

    painting.drag(250, 300);
    const auto few = painting.held().places.size();
    painting.drag(290, 350); // adds to what is painted
    const auto held = painting.held();
    CHECK(held.places.size() > few);
    for (const auto& place : held.places) {
        CHECK(place[0] > 0.2);
        CHECK(place[0] < 0.8);
        CHECK(std::abs(place[2]) < 0.06); // half the thickness
    }
    finish(painting.processor);
    painting.pane.refresh();
    CHECK_FALSE(painting.object().clampedVertices.empty());
    CHECK(painting.held() == held);
    CHECK(painting.heldPixels() > before + 50);
}

TEST_CASE("Without a painted region, or with the layer switched off, a drag scrapes") {
    Painting painting;
    painting.drag(250, 350);
    CHECK(painting.held().places.empty());
    painting.choose(Kind::places);
    auto& shown = *find<juce::Button>(painting.pane, "Held");
    shown.setToggleState(false, juce::dontSendNotification);
    shown.onClick();
    painting.drag(250, 350);
    CHECK(painting.held().places.empty());
}

TEST_CASE("A stroke while another sound is loaded holds nothing") {
    Painting painting;
    painting.choose(Kind::places);
    auto& picture = painting.pane.picture();
    const juce::Point<float> middle{300, painting.middle()};
    picture.mouseDown(mouseAt(picture, middle, middle));
    painting.play("Wok");
    picture.mouseUp(mouseAt(picture, middle, middle));
    CHECK(painting.held().isFree());
    CHECK_FALSE(painting.processor.view().workshop.importStatus().isWorking());
}

TEST_CASE("An object of a preset is painted and analysed again") {
    Painting painting;
    painting.choose(Kind::places);
    painting.drag(280, 320);
    CHECK_FALSE(painting.held().places.empty());
    CHECK(painting.processor.view().workshop.importStatus().isWorking());
    painting.processor.view().workshop.cancelImport();
}

TEST_CASE("The layer shows where tines are held") {
    Painting painting;
    painting.play("Kalimba");
    const int before = painting.heldPixels();
    auto& picture = painting.pane.picture();
    picture.setLayers({.held = true});
    CHECK(painting.heldPixels() > before + 20);
}
