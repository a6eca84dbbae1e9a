// Tests of the outline under the mouse, in pictures of a view without OpenGL.
#include "Editor/Mouse.h"
#include "Editor/ObjectView.h"
#include "Instrument/FactoryContent.h"
#include "Plugin/Processor.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

bool isEqual(const juce::Image& first, const juce::Image& second) {
    for (int y = 0; y < first.getHeight(); ++y)
        for (int x = 0; x < first.getWidth(); ++x)
            if (first.getPixelAt(x, y) != second.getPixelAt(x, y))
                return false;
    return true;
}

/// A view of a preset with a mouse over it.
struct Hovering {
    explicit Hovering(const char* preset) {
        const auto presets = factoryPresets();
        const auto found = std::ranges::find(presets, preset, &Preset::name);
        processor.setCurrentProgram(static_cast<int>(found - presets.begin()));
        view.refresh();
        view.setBounds(0, 0, 600, 300);
    }

    juce::Image picture() { return view.createComponentSnapshot(view.getLocalBounds(), true, 1); }
    juce::MouseEvent at(juce::Point<float> place, int buttons = 0) {
        return mouseAt(view, place, place, buttons);
    }
    void moveTo(juce::Point<float> place) { view.mouseMove(at(place)); }
    void zoom() { view.mouseWheelMove(at(middle), {0, 0.3f, false, false, false}); }
    /// Then takes the mouse away.
    bool isOutlined() {
        const auto before = picture();
        view.mouseExit(at({}));
        return !isEqual(before, picture());
    }

    static constexpr juce::Point<float> middle{300, 150};
    Processor processor;
    ObjectView view{processor.view()};
};

} // namespace

TEST_CASE("The object under the mouse is outlined, and the background is not") {
    Hovering mouse("Steel Plate");
    mouse.moveTo({2, 2});
    CHECK_FALSE(mouse.isOutlined());
    mouse.moveTo(mouse.middle);
    CHECK(mouse.isOutlined());
}

TEST_CASE("The outline is hidden when a drag turns the view") {
    Hovering mouse("Steel Plate");
    mouse.moveTo(mouse.middle);
    mouse.view.mouseDown(mouse.at(mouse.middle, juce::ModifierKeys::rightButtonModifier));
    CHECK_FALSE(mouse.isOutlined());
}

TEST_CASE("The outline follows a zoom") {
    Hovering follows("Steel Plate"), comesLater("Steel Plate");
    follows.moveTo(follows.middle);
    const auto before = follows.picture();
    follows.zoom();
    comesLater.zoom();
    comesLater.moveTo(comesLater.middle);
    const auto after = follows.picture();
    CHECK_FALSE(isEqual(after, before));
    CHECK(isEqual(after, comesLater.picture()));
}

TEST_CASE("The outline in a new scene is of its own object, also under the same camera") {
    Hovering plate("Steel Plate"), wok("Wok");
    const auto sceneOf = [](Hovering& mouse) {
        return ObjectScene(mouse.processor.view().instrument.playedObjects());
    };
    const auto first = sceneOf(plate), second = sceneOf(wok);
    OrbitCamera camera;
    camera.lookAt(first.outline());
    const auto painted = [&](HoverOutline& outline, const ObjectScene& scene) {
        juce::Image image(juce::Image::ARGB, 600, 300, true);
        juce::Graphics g(image);
        outline.show(HoverOutline::Hover{.velocity = 100});
        outline.paint(g, plate.view, scene, camera);
        outline.show(std::nullopt);
        return image;
    };
    HoverOutline used, fresh;
    const auto ofPlate = painted(used, first), ofWok = painted(used, second);
    CHECK_FALSE(isEqual(ofWok, ofPlate));
    CHECK(isEqual(ofWok, painted(fresh, second)));
}

TEST_CASE("A body on a stage is outlined while it rests") {
    Hovering mouse("Dice on Rosewood");
    juce::Point<float> onBar{300, 0};
    for (bool found = false; !found;) {
        onBar.y += 10;
        REQUIRE(onBar.y < 300);
        mouse.moveTo(onBar);
        found = mouse.isOutlined();
    }
    const auto view = mouse.processor.view();
    SoundFrame frame;
    frame.instrumentNumber = view.instrument.instrumentNumber();
    frame.bodies = view.stage.stageBodies();
    const auto showFrame = [&] { mouse.view.showSound(frame); };

    mouse.moveTo(onBar);
    showFrame();
    CHECK(mouse.isOutlined());
    mouse.moveTo(onBar);
    for (auto& body : frame.bodies)
        body.originMetres[2] += 0.001f;
    showFrame();
    CHECK_FALSE(mouse.isOutlined());
    mouse.moveTo(onBar); // it still moves
    CHECK_FALSE(mouse.isOutlined());
    showFrame();
    mouse.moveTo(onBar);
    CHECK(mouse.isOutlined());
}
