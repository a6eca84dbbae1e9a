// Tests of the 3D view that need no screen: layout, camera, picking.
#include "Editor/ObjectView.h"
#include "Editor/PixelProjection.h"

#include "Editor/WindowParts.h"
#include "Support/TestSound.h"

#include "Instrument/FactoryContent.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

int presetNumber(const char* name) {
    const auto presets = factoryPresets();
    const auto found = std::ranges::find(presets, name, &Preset::name);
    return static_cast<int>(found - presets.begin());
}

std::vector<InstrumentView::PlayedObject> objectsOf(Processor& processor, const char* preset) {
    processor.setCurrentProgram(presetNumber(preset));
    return processor.view().instrument.playedObjects();
}

/// A point 1 m above the middle of an object's upward faces.
ScenePlace above(const ObjectScene& scene, std::size_t object) {
    const auto& run = scene.objects()[object];
    ScenePlace sum{};
    float count = 0;
    for (const auto& vertex : scene.vertices().subspan(run.firstVertex, run.vertexCount))
        if (vertex.normal[2] > 0.9f) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] += vertex.place[axis];
            ++count;
        }
    for (float& component : sum)
        component /= count;
    return {sum[0], sum[1], sum[2] + 1};
}

} // namespace

TEST_CASE("Bars are laid out from left to right, with accidentals behind the naturals") {
    Processor processor;
    const auto played = objectsOf(processor, "Rosewood Xylophone");
    REQUIRE(played.size() == 44);
    CHECK(played.front().lowestNote == 65);
    CHECK(played.front().highestNote == 65);
    const ObjectScene scene(played);
    const std::set accidentals{1, 3, 6, 8, 10};
    float lastNatural = -1, lastBehind = -1;
    for (std::size_t i = 0; i < played.size(); ++i) {
        const auto place = above(scene, i);
        const auto hit = scene.pick(place, {0, 0, -1});
        REQUIRE(hit);
        INFO("note " << played[i].lowestNote);
        CHECK(hit->object == i);
        const bool behind = accidentals.contains(played[i].lowestNote % 12);
        CHECK((place[1] > 0.05f) == behind);
        float& last = behind ? lastBehind : lastNatural;
        CHECK(place[0] > last);
        last = place[0];
    }
}

TEST_CASE("Chimes hang side by side with level upper ends") {
    Processor processor;
    const auto played = objectsOf(processor, "Tubular Bells");
    REQUIRE(played.size() == 18);
    const ObjectScene scene(played);
    CHECK(
        std::ranges::all_of(scene.outline(), [](const auto& corner) { return corner[1] < 0.1f; }));
    for (std::size_t i = 0; i < played.size(); ++i) {
        const auto& run = scene.objects()[i];
        float top = -1;
        for (const auto& vertex : scene.vertices().subspan(run.firstVertex, run.vertexCount))
            top = std::max(top, vertex.place[2]);
        CHECK(top == Approx(0).margin(1e-4));
    }
}

TEST_CASE("A pick returns a point on the object's mesh; its strength rises towards the player") {
    Processor processor;
    const auto played = objectsOf(processor, "Rosewood Xylophone");
    const ObjectScene scene(played);
    for (const std::size_t i : {0u, 1u, 20u}) {
        const auto& vertices = played[i].object->vertices;
        float top = vertices[2], end = vertices[0];
        for (std::size_t k = 0; k < vertices.size(); k += 3) {
            top = std::max(top, vertices[k + 2]);
            end = std::max(end, vertices[k]);
        }
        auto from = above(scene, i);
        const auto middle = scene.pick(from, {0, 0, -1});
        REQUIRE(middle);
        CHECK(middle->pointMetres[2] == Approx(top).margin(1e-6));
        CHECK(std::abs(middle->pointMetres[0]) < 0.05 * double(end));
        CHECK(middle->towardsPlayer == Approx(0.5).margin(0.05));
        from[1] -= 0.8f * end;
        const auto near = scene.pick(from, {0, 0, -1});
        REQUIRE(near);
        CHECK(near->towardsPlayer == Approx(0.9).margin(0.05));
        CHECK(near->pointMetres[0] == Approx(-0.8 * double(end)).epsilon(0.06));
    }
}

TEST_CASE("A ray beside all objects hits nothing, and so does any ray in an empty scene") {
    Processor processor;
    const ObjectScene scene(objectsOf(processor, "Handbell"));
    CHECK(scene.objects().size() == 1);
    CHECK_FALSE(scene.pick({10, 0, 1}, {0, 0, -1}));
    const ObjectScene empty({});
    CHECK(empty.empty());
    CHECK_FALSE(empty.pick({0, 0, 1}, {0, 0, -1}));
}

TEST_CASE("The camera shows the whole scene at any aspect ratio, and its rays match the picture") {
    OrbitCamera camera;
    const ScenePlace lowest{-0.4f, -0.2f, 0.1f}, highest{0.9f, 0.3f, 0.15f};
    std::vector<ScenePlace> box;
    for (unsigned corner = 0; corner < 8; ++corner)
        box.push_back({corner & 1 ? lowest[0] : highest[0], corner & 2 ? lowest[1] : highest[1],
                       corner & 4 ? lowest[2] : highest[2]});
    camera.lookAt(box);
    for (const auto& [around, up] : {std::pair(0.0f, 0.0f), {1.3f, 0.5f}, {-2.5f, -2.0f}}) {
        camera.turnBy(around, up);
        for (const float aspect : {0.4f, 1.0f, 3.0f}) {
            const PixelProjection projection(camera.viewProjection(aspect), {-1, -1, 2, 2});
            float widest = 0;
            for (const auto& place : box) {
                const auto seen = projection.pixelOf(vectorOf(place)).value();
                CHECK(std::abs(seen.x) <= 1);
                CHECK(std::abs(seen.y) <= 1);
                widest = std::max({widest, std::abs(seen.x), std::abs(seen.y)});
                const auto [origin, direction] = camera.rayThrough(seen.x, -seen.y, aspect);
                const float along = direction[0] * (place[0] - origin[0]) +
                                    direction[1] * (place[1] - origin[1]) +
                                    direction[2] * (place[2] - origin[2]);
                const float square = direction[0] * direction[0] + direction[1] * direction[1] +
                                     direction[2] * direction[2];
                for (std::size_t axis = 0; axis < 3; ++axis)
                    CHECK(std::abs(origin[axis] + along / square * direction[axis] - place[axis]) <
                          1e-4f);
            }
            CHECK(widest > 0.9f);
        }
    }
}

TEST_CASE("A click on a bar plays it; a click beside the bars is silent") {
    Processor processor;
    processor.setCurrentProgram(presetNumber("Marimba"));
    processor.prepareToPlay(48000, 480);
    ObjectView view(processor.view());
    view.setBounds(0, 0, 900, 300);
    juce::AudioBuffer<float> sound(2, 4800);
    juce::MidiBuffer midi;
    const auto level = [&] {
        sound.clear();
        processor.processBlock(sound, midi);
        return sound.getMagnitude(0, sound.getNumSamples());
    };
    CHECK_FALSE(view.strikeAt({2, 2}));
    CHECK(level() == 0);
    // Down the middle, past the gap between the rows of bars.
    std::optional<ScenePick> pick;
    for (float y = 100; y < 250 && !pick; y += 10)
        pick = view.strikeAt({450, y});
    REQUIRE(pick);
    CHECK(pick->object < processor.view().instrument.playedObjects().size());
    CHECK(level() > 1e-4f);
    view.lift();
}

TEST_CASE("Showing or hiding the strike path repaints the view") {
    Processor processor;
    ObjectView view(processor.view());
    view.setBounds(0, 0, 900, 300);
    view.setVisible(true);
    int repaints = 0;
    view.setCachedComponentImage(new RepaintCount(repaints)); // the component owns it
    for (const bool shows : {true, false}) {
        const int before = repaints;
        view.setLayers({.path = shows});
        CHECK(repaints > before);
    }
}

TEST_CASE("A path being drawn while another sound is loaded changes neither sound") {
    Processor processor;
    processor.setCurrentProgram(presetNumber("Steel Plate"));
    ObjectView view(processor.view());
    view.setBounds(0, 0, 900, 300);
    view.setLayers({.drawsPath = true});
    const auto at = [&](float x) {
        return juce::MouseEvent(juce::Desktop::getInstance().getMainMouseSource(), {x, 150},
                                juce::ModifierKeys::leftButtonModifier, 0, 0, 0, 0, 0, &view, &view,
                                {}, {450, 150}, {}, 1, x != 450);
    };
    const auto draw = [&](auto&& meanwhile) {
        view.mouseDown(at(450));
        view.mouseDrag(at(440));
        view.mouseDrag(at(430));
        meanwhile();
        view.mouseDrag(at(420));
        view.mouseUp(at(420));
    };
    const auto path = [&] { return processor.soundSession().instrument()->keyMap().strikePath; };
    const auto before = path();
    draw([] {});
    CHECK(path() != before); // the drag sets a path
    view.refresh();
    draw([&] {
        processor.setCurrentProgram(presetNumber("Wok"));
        view.refresh();
    });
    CHECK(path() ==
          factoryPresets()[static_cast<std::size_t>(presetNumber("Wok"))].keyMap.strikePath);
    CHECK(processor.soundSession().loadedSound().preset.name == "Wok");
}

TEST_CASE("Closing the 3D view releases the object that it holds") {
    Processor processor;
    processor.setCurrentProgram(presetNumber("Steel Plate"));
    processor.prepareToPlay(48000, 480);
    processor.view().parameters.change(ParameterId::letRing, 0);
    processor.view().parameters.change(ParameterId::releaseTime, 0.02);
    {
        ObjectView view(processor.view());
        view.setBounds(0, 0, 900, 300);
        REQUIRE(view.strikeAt({450, 150}));
        CHECK(loudest(render(processor, 4800, 480, {})) > 1e-4f);
    }
    render(processor, 48000, 480, {});
    CHECK(loudest(render(processor, 480, 480, {})) < 1e-6f);
}

TEST_CASE("Objects beyond the face limit are boxes of the same size and can be struck") {
    auto object = syntheticObject({440});
    object.body = BodyKind::solid; // drawn without a thickness of its own
    object.vertices = {0, 0, 0, 0.2f, 0, 0, 0, 0.1f, 0.01f};
    const auto withFaces = [&](std::size_t count) {
        object.faces.clear();
        for (std::size_t face = 0; face < count; ++face)
            object.faces.insert(object.faces.end(), {0, 1, 2});
        return std::make_shared<const ModalObject>(object);
    };
    const auto many = withFaces(ObjectScene::maximumFaces + 1), few = withFaces(1000);
    const ObjectScene scene({{.object = many, .lowestNote = 60, .highestNote = 60},
                             {.object = few, .lowestNote = 62, .highestNote = 62}});
    REQUIRE(scene.objects().size() == 2);
    CHECK(scene.objects()[0].isBox);
    CHECK(scene.objects()[0].vertexCount == 36);
    CHECK_FALSE(scene.objects()[1].isBox);
    CHECK(scene.objects()[1].vertexCount == 3000);
    CHECK(scene.objects()[0].radius == Approx(scene.objects()[1].radius));
    for (const auto& vertex : scene.vertices().first(36)) { // normals point outward
        float outward = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            outward +=
                vertex.normal[axis] *
                (vertex.place[axis] - (scene.outline()[0][axis] + scene.outline()[7][axis]) / 2);
        CHECK(outward > 0);
    }
    const std::vector<float> displacements(object.vertices.size(), 1);
    for (const auto& offset : scene.offsetsOf(0, displacements))
        CHECK(offset == ScenePlace{});
    const auto from = above(scene, 0);
    const auto hit = scene.pick(from, {0, 0, -1});
    REQUIRE(hit);
    CHECK(hit->object == 0);
    CHECK(hit->pointMetres[2] == Approx(0.01).margin(1e-6));
}

TEST_CASE("An object without faces does not change another body's outline") {
    auto bare = syntheticObject({440});
    bare.faces.clear();
    auto plain = syntheticObject({440});
    plain.vertices = {0, 0, 0, 0.2f, 0, 0, 0, 0.1f, 0};
    plain.faces = {0, 1, 2};
    const ObjectScene scene({{.object = std::make_shared<const ModalObject>(bare)},
                             {.object = std::make_shared<const ModalObject>(plain)}},
                            ObjectScene::Layout::stage);
    BodyNow first, second;
    first.object = 0;
    second.object = 1;
    second.originMetres = {1, 0, 0};
    CHECK(scene.outline(std::vector{first}).empty());
    const auto seen = scene.outline(std::vector{first, second});
    REQUIRE(seen.size() == 8);
    for (const auto& place : seen)
        CHECK(place[0] > 0.9f);
}
