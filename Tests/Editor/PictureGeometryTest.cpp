// Tests of the drawn meshes, the furniture and the light, which need no screen.
#include "Editor/InstrumentFurniture.h"
#include "Editor/OrbitCamera.h"
#include "Editor/PictureParts.h"
#include "Editor/PixelProjection.h"
#include "Editor/PlainPicture.h"
#include "Editor/SceneLight.h"
#include "Editor/ShownInstrument.h"
#include "Support/PresetNumber.h"
#include "Support/TestSound.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

struct Picture {
    explicit Picture(const char* preset) {
        processor.setCurrentProgram(presetNumber(preset));
        const auto view = processor.view();
        played = view.instrument.playedObjects();
        bodies = view.stage.stageBodies();
        const bool onStage = view.stage.hasStage();
        scene = std::make_shared<const ObjectScene>(
            played, onStage ? ObjectScene::Layout::stage : ObjectScene::Layout::keyboard);
        furniture = std::make_shared<const InstrumentFurniture>(played, *scene, onStage, bodies);
    }

    Processor processor;
    std::vector<InstrumentView::PlayedObject> played;
    std::vector<BodyNow> bodies;
    std::shared_ptr<const ObjectScene> scene;
    std::shared_ptr<const InstrumentFurniture> furniture;
};

ModalObject flatSheet() {
    auto sheet = syntheticObject({440});
    sheet.body = BodyKind::shell;
    sheet.thicknessMetres = 0.02;
    sheet.vertices = {0, 0, 0, 0.4f, 0, 0, 0.4f, 0.3f, 0, 0, 0.3f, 0};
    sheet.faces = {0, 1, 2, 0, 2, 3};
    return sheet;
}

/// A level square with its upper side towards the sky.
std::vector<SceneVertex> square(float halfSide, float height) {
    std::vector<SceneVertex> vertices;
    const float places[6][2]{{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    for (const auto& [x, y] : places)
        vertices.push_back({{x * halfSide, y * halfSide, height}, {0, 0, 1}});
    return vertices;
}

} // namespace

TEST_CASE("An open sheet is drawn with its thickness and closed edges") {
    const auto mesh = drawingMesh(flatSheet(), 1000);
    CHECK(mesh.corners.size() == 3 * (2 + 2 + 8)); // both sides, and two faces for each edge
    CHECK(mesh.form == Form::box);
    CHECK(mesh.isClosed);
    for (const auto& corner : mesh.corners) {
        CHECK(std::abs(corner.place.z()) == Approx(0.01));
        // Normals look outward.
        const Eigen::Vector3f outward = corner.place - Eigen::Vector3f(0.2f, 0.15f, 0);
        CHECK(corner.normal.dot(outward) > 0);
    }
}

TEST_CASE("Round objects are drawn rounder than their mesh and move with it") {
    const Picture picture("Handbell");
    const auto& object = *picture.played.front().object;
    const auto coarse = drawingMesh(object, object.faceCount());
    const auto fine = drawingMesh(object, 4 * object.faceCount());
    CHECK(coarse.form == Form::turned);
    CHECK(coarse.corners.size() == 3 * object.faceCount());
    REQUIRE(fine.corners.size() == 4 * coarse.corners.size());
    for (const auto& corner : fine.corners) {
        Eigen::Vector3f onMesh = Eigen::Vector3f::Zero();
        float sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto vertex = static_cast<std::size_t>(corner.onMesh.vertices[i]);
            onMesh += corner.onMesh.weights[i] * Eigen::Vector3f(&object.vertices[3 * vertex]);
            sum += corner.onMesh.weights[i];
        }
        CHECK(sum == Approx(1));
        CHECK((corner.place - onMesh).norm() < 0.002f); // bent by less than 2 mm
    }
}

TEST_CASE("Bars share modes with tubes that are twice as long an octave lower") {
    const Picture picture("Vibraphone");
    std::vector<FurniturePart> tubes, discs;
    for (const auto& part : picture.furniture->parts())
        if (part.turnsAbout)
            discs.push_back(part);
    CHECK(discs.size() == picture.played.size());
    // The pipes are one part; the lowest reaches about a quarter of a wave below the bars.
    const auto& last = picture.furniture->parts().back().shape;
    const auto vertices = std::span(picture.furniture->vertices())
                              .first(last.firstVertex + last.vertexCount -
                                     picture.scene->vertices().size()); // without the mallet
    const auto deepestBelow = [&](std::size_t object) {
        const auto& bar = picture.scene->objects()[object];
        float lowest = 0;
        for (const auto& vertex : vertices) {
            const float x = vertex.place[0] - bar.middle[0], y = vertex.place[1] - bar.middle[1];
            if (std::hypot(x, y) < bar.halfExtent[0])
                lowest = std::min(lowest, vertex.place[2] - bar.middle[2]);
        }
        return -lowest;
    };
    CHECK(deepestBelow(0) == Approx(0.48).margin(0.04)); // F3: 343 m/s / (4 · 174.6 Hz) = 0.49 m
    CHECK(deepestBelow(12) == Approx(0.24).margin(0.04));
    CHECK(picture.furniture->floorHeight() < -deepestBelow(0));
}

TEST_CASE("Bars without tubes have rails and cords, but no pipes") {
    const Picture picture("Glockenspiel");
    CHECK_FALSE(picture.furniture->parts().empty());
    CHECK(std::ranges::none_of(picture.furniture->parts(),
                               [](const auto& part) { return part.turnsAbout.has_value(); }));
    CHECK(picture.furniture->floorHeight() > -0.2f);
}

TEST_CASE("A row of bars on a stage lies on rails above the floor") {
    const Picture picture("Dice on Rosewood");
    float lowestBar = std::numeric_limits<float>::max();
    for (const auto& corner : picture.scene->outline(picture.bodies))
        lowestBar = std::min(lowestBar, corner[2]);
    std::size_t fixedParts = 0;
    for (const auto& part : picture.furniture->parts())
        fixedParts += part.object ? 0 : 1; // pips belong to the die
    CHECK(fixedParts == 3);                // cords, pins, and rails with their ends
    CHECK(picture.furniture->floorHeight() < lowestBar - 0.02f);
}

TEST_CASE("The floor is below every object and all that carries it") {
    for (const char* preset : {"Rosewood Xylophone", "Tubular Bells", "Handbell", "Glass Bowls",
                               "Wok", "Steel Plate", "Steel Ring", "Wooden Table"}) {
        INFO(preset);
        const Picture picture(preset);
        const float floor = picture.furniture->floorHeight();
        float lowest = 1;
        for (const auto& vertex : picture.scene->vertices())
            lowest = std::min(lowest, vertex.place[2]);
        for (const auto& part : picture.furniture->parts())
            lowest = std::min(lowest, part.shape.middle[2] - part.shape.halfExtent[2]);
        CHECK(lowest > floor - 0.02f);
        CHECK(lowest < floor + 0.1f); // something stands on it
    }
}

TEST_CASE("A bell hangs below its frame, a gong lies and a bottle stands") {
    for (const auto& [preset, hangs] : {std::pair("Handbell", true), std::pair("Church Bell", true),
                                        std::pair("Gong", false), std::pair("Bottles", false)}) {
        INFO(preset);
        const Picture picture(preset);
        float top = -1, frameTop = -1;
        for (const auto& vertex : picture.scene->vertices())
            top = std::max(top, vertex.place[2]);
        for (const auto& part : picture.furniture->parts())
            frameTop = std::max(frameTop, part.shape.middle[2] + part.shape.halfExtent[2]);
        CHECK((frameTop > top) == hangs);
    }
}

TEST_CASE("Dice have 21 pips that follow their bodies") {
    const Picture picture("Dice on Rosewood");
    const auto part = std::ranges::find_if(picture.furniture->parts(), [&](const auto& candidate) {
        return candidate.object && picture.played[*candidate.object].object->name == "die";
    });
    REQUIRE(part != picture.furniture->parts().end());
    // A disc of 20 sides has a wall of 40 faces and two caps of 20.
    CHECK(part->shape.vertexCount == 21 * 3 * 80);
}

TEST_CASE("Tines stand in one row, with their far ends in a block on a board") {
    const Picture picture("Kalimba");
    const auto objects = picture.scene->objects();
    REQUIRE(objects.size() == picture.played.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto& tine = objects[i];
        CHECK(tine.middle[1] + tine.halfExtent[1] == Approx(0).margin(1e-6));
        CHECK(tine.middle[2] == Approx(0).margin(1e-6));
        CHECK_FALSE(picture.scene->isBehind(i));
        if (i > 0) // no tine touches the next
            CHECK(tine.middle[0] - tine.halfExtent[0] >
                  objects[i - 1].middle[0] + objects[i - 1].halfExtent[0]);
    }
    const auto& parts = picture.furniture->parts();
    REQUIRE(parts.size() == 2);
    for (const auto& part : parts) // block and board reach from the first tine to the last
        CHECK(part.shape.halfExtent[0] >
              (objects.back().middle[0] - objects.front().middle[0]) / 2);
    const auto& block = parts.front().shape;
    CHECK(std::abs(block.middle[1]) < block.halfExtent[1]);
    CHECK(std::abs(block.middle[2]) < block.halfExtent[2]);
    CHECK(picture.furniture->floorHeight() < block.middle[2] - block.halfExtent[2]);
}

TEST_CASE("A post holds a single object where it is clamped") {
    const Picture picture("Tuning Fork");
    const auto& fork = picture.scene->objects().front();
    const auto& post = picture.furniture->parts().front().shape;
    const float bottom = fork.middle[2] - fork.halfExtent[2];
    CHECK(post.middle[2] + post.halfExtent[2] > bottom);
    CHECK(post.middle[2] + post.halfExtent[2] < fork.middle[2]);
    CHECK(picture.furniture->floorHeight() < bottom);
    CHECK(std::abs(post.middle[0] - fork.middle[0]) < post.halfExtent[0]);
}

TEST_CASE("A single chime hangs from a beam above it") {
    const Picture picture("Wind Chimes");
    const auto& chime = picture.scene->objects().front();
    const float top = chime.middle[2] + chime.halfExtent[2];
    CHECK(std::ranges::any_of(picture.furniture->parts(), [&](const FurniturePart& part) {
        return part.shape.middle[2] - part.shape.halfExtent[2] > top;
    }));
    CHECK(picture.furniture->floorHeight() < chime.middle[2] - chime.halfExtent[2]);
}

TEST_CASE("Furniture cannot be struck") {
    Picture picture("Handbell");
    const auto shown = ShownInstrument::of(picture.processor.view());
    OrbitCamera camera;
    camera.lookAt(shown.outline());
    const auto pickAt = [&](const Eigen::Vector3f& place) {
        const auto eye = camera.eye(1);
        return shown.pick({.origin = eye, .direction = scenePlace(place - vectorOf(eye))});
    };
    CHECK(pickAt(vectorOf(shown.scene->objects().front().middle)));
    // The faces of its stand that lie farthest to the sides, where the bell is not in sight.
    std::vector<Eigen::Vector3f> faces;
    for (const auto& part : shown.furniture->parts()) {
        const auto first = part.shape.firstVertex - shown.scene->vertices().size();
        const auto corners =
            std::span(shown.furniture->vertices()).subspan(first, part.shape.vertexCount);
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            faces.emplace_back((vectorOf(corners[i].place) + vectorOf(corners[i + 1].place) +
                                vectorOf(corners[i + 2].place)) /
                               3);
    }
    const auto [left, right] =
        std::ranges::minmax_element(faces, {}, [](const auto& face) { return face.x(); });
    CHECK_FALSE(pickAt(*left));
    CHECK_FALSE(pickAt(*right));
}

TEST_CASE("A square above the floor shades what is under it, and not what is far away") {
    const auto vertices = square(0.5f, 0.2f);
    const FloorArea area{
        .left = -2, .front = -2, .width = 4, .depth = 4, .height = 0, .columns = 40, .rows = 40};
    const auto light = sceneLight(vertices, area).value();
    REQUIRE(light.floor.size() == 2 * 40 * 40);
    const auto at = [&](int column, int row) {
        const auto texel = 2 * static_cast<std::size_t>(40 * row + column);
        return std::pair<int, int>(light.floor[texel], light.floor[texel + 1]);
    };
    const auto [lampBelow, skyBelow] = at(20, 19);
    CHECK(lampBelow < 10);
    CHECK(skyBelow < 80);
    const auto [lampAway, skyAway] = at(1, 38);
    CHECK(lampAway == 255);
    CHECK(skyAway > 245);
    CHECK(light.sky == std::vector<std::uint8_t>(vertices.size(), 255)); // nothing is above it
}

TEST_CASE("A surface under another sees less of the sky") {
    auto vertices = square(0.1f, 0);
    const auto roof = square(1, 0.1f);
    vertices.insert(vertices.end(), roof.begin(), roof.end());
    const auto light = sceneLight(vertices, {.columns = 1, .rows = 1}).value();
    REQUIRE(light.sky.size() == 12);
    for (std::size_t vertex = 0; vertex < 12; ++vertex)
        CHECK((vertex < 6 ? light.sky[vertex] < 40 : light.sky[vertex] == 255));
}

TEST_CASE("A frame is drawn with its bodies, their furniture and its mallets") {
    const Picture picture("Dice on Rosewood");
    SceneFrame frame;
    frame.scene = picture.scene;
    frame.furniture = picture.furniture;
    frame.appearances.resize(picture.played.size());
    const auto die = static_cast<std::size_t>(
        std::ranges::find_if(picture.played,
                             [](const auto& each) { return each.object->name == "die"; }) -
        picture.played.begin());
    SceneBody body{.object = die};
    Eigen::Map<Eigen::Matrix4f>(body.pose.data()) =
        Eigen::Affine3f(Eigen::Translation3f(0, 0, 5)).matrix();
    frame.bodies = {body, body};
    frame.mallets.resize(1);
    const auto parts = partsOf(frame);
    const auto count = [&](auto&& condition) { return std::ranges::count_if(parts, condition); };
    CHECK(count([&](const auto& part) { return part.object == die; }) == 2);
    CHECK(count([](const auto& part) { return part.pose(2, 3) == 5; }) == 4); // with their pips
    // Also head and stick, and the cords, pins and rails of the bars.
    CHECK(parts.size() == 4 + 2 + 3);
}

TEST_CASE("The plain picture shows a bar in its colour, and the background beside it") {
    const Picture picture("Rosewood Xylophone");
    OrbitCamera camera;
    camera.lookAt(picture.scene->outline());
    SceneFrame frame;
    frame.scene = picture.scene;
    frame.furniture = picture.furniture;
    frame.appearances.assign(picture.played.size(), {Finish::wood, {0.8f, 0.4f, 0}});
    frame.viewProjection = camera.viewProjection(2);
    frame.eye = camera.eye(2);
    juce::Image image(juce::Image::ARGB, 400, 200, true);
    {
        juce::Graphics g(image);
        paintPlainPicture(g, {0, 0, 400, 200}, frame);
    }
    auto onTop = picture.scene->objects()[10].middle;
    onTop[2] += picture.scene->objects()[10].halfExtent[2];
    const auto seen = PixelProjection(frame.viewProjection, {0, 0, 400, 200})
                          .pixelOf(vectorOf(onTop))
                          .value()
                          .roundToInt();
    const auto bar = image.getPixelAt(seen.x, seen.y);
    CHECK(bar.getAlpha() > 200);
    CHECK(bar.getFloatRed() > 0.6f);
    CHECK(bar.getFloatGreen() == Approx(bar.getFloatRed() / 2).margin(0.02));
    CHECK(image.getPixelAt(1, 1).getAlpha() == 0);
}

TEST_CASE("Only parts of glass cast no shadow, also after a change of the material") {
    const Picture picture("Handbell");
    SceneFrame frame;
    frame.scene = picture.scene;
    frame.furniture = picture.furniture;
    frame.appearances = {{Finish::metal, {}}};
    const auto castersNow = [&] { return shadowCasters(partsOf(frame)); };
    const std::vector<bool> all(1 + picture.furniture->parts().size(), true);
    CHECK(castersNow() == all);
    frame.appearances = {{Finish::glass, {}}};
    auto withoutBell = all;
    withoutBell.front() = false;
    CHECK(castersNow() == withoutBell);
}

TEST_CASE("A place behind the eye or just before it has no pixel") {
    OrbitCamera camera;
    camera.lookAt({{-1, -1, 0}, {1, 1, 0.5f}});
    const PixelProjection projection(camera.viewProjection(1), {0, 0, 100, 100});
    const auto eye = vectorOf(camera.eye(1));
    const Eigen::Vector3f forward = Eigen::Vector3f(0, 0, 0.25f) - eye;
    CHECK(projection.pixelOf(eye + forward));
    CHECK_FALSE(projection.pixelOf(eye + 1e-4f * forward));
    CHECK_FALSE(projection.pixelOf(eye - forward));
}
