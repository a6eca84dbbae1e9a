#include "Editor/InstrumentFurniture.h"

#include "Editor/KeyboardFurniture.h"
#include "Editor/ObjectStand.h"

#include <algorithm>
#include <array>
#include <limits>

namespace idiophone {
namespace {

/// Speed of sound in air over four: a closed tube is a quarter of a wave long.
constexpr double quarterWaveMetresPerSecond = 343.0 / 4;
constexpr float endCorrection = 0.61f; // of the radius, at the open end (Levine & Schwinger 1948)
constexpr float tubeShare = 0.86f;     // of the bar's width

/// The length in metres of the tube that shares a mode with the bar; 0 if there is none.
float tubeMetresOf(const InstrumentView::PlayedObject& played, float radius) {
    const auto& object = *played.object;
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        if (object.isShared(mode))
            return std::max(static_cast<float>(quarterWaveMetresPerSecond * played.sizeRatio /
                                               object.dampedFrequencyHz(mode)) -
                                endCorrection * radius,
                            radius);
    return 0;
}

/// Whether an object is long, round and upright, as a chime that hangs.
bool isTube(const SceneObject& object) {
    constexpr float slenderness = 5;
    return object.form == Form::turned && object.halfExtent[2] > slenderness * object.halfExtent[0];
}

/// Returns the box of the vertices of a single object that are held; empty if it is free.
Eigen::AlignedBox3f clampOf(const ModalObject& object, const ObjectScene& scene) {
    Eigen::AlignedBox3f box;
    for (const auto vertex : object.clampedVertices) {
        const float* at = &object.vertices[3 * static_cast<std::size_t>(vertex)];
        box.extend(
            vectorOf(scene.placeOf(0, {static_cast<double>(at[0]), static_cast<double>(at[1]),
                                       static_cast<double>(at[2])})));
    }
    return box;
}

/// Returns the bars that lie along y on a stage, from left to right.
std::vector<KeyboardBar> barsOf(const std::vector<InstrumentView::PlayedObject>& played,
                                const ObjectScene& scene,
                                std::span<const BodyNow> bodies) {
    constexpr float minimumRatio = 2; // of length to width; the width exceeds the height
    std::vector<KeyboardBar> bars;
    for (const auto& body : bodies) {
        const auto index = static_cast<std::size_t>(body.object);
        Eigen::AlignedBox3f box;
        for (const auto& corner : scene.outline(std::span(&body, 1)))
            box.extend(vectorOf(corner));
        if (box.isEmpty())
            continue;
        const Eigen::Vector3f half = box.sizes() / 2;
        if (half.y() > minimumRatio * half.x() && half.x() > half.z())
            bars.push_back({.middle = box.center(),
                            .half = half,
                            .finish = appearanceOf(played[index].object->material).finish});
    }
    std::ranges::sort(bars, {}, [](const KeyboardBar& bar) { return bar.middle.x(); });
    return bars;
}

} // namespace

InstrumentFurniture::InstrumentFurniture(const std::vector<InstrumentView::PlayedObject>& played,
                                         const ObjectScene& scene,
                                         bool onStage,
                                         std::span<const BodyNow> bodies)
    : built(scene.vertices().size()) {
    const auto objects = scene.objects();
    if (onStage)
        addForStage(played, scene, bodies);
    else if (scene.isShelf())
        floor = 0;
    else if (objects.size() > 1)
        addForKeyboard(played, scene);
    else if (!scene.empty() && isTube(objects.front()))
        floor = addChimeFrame(
            built, std::array{KeyboardBar{.middle = vectorOf(objects.front().middle),
                                          .half = vectorOf(objects.front().halfExtent)}});
    else if (!scene.empty())
        floor = addStand(built, objects.front(), scene.vertices(),
                         appearanceOf(played.front().object->material).finish,
                         clampOf(*played.front().object, scene));
    addMallet();
}

void InstrumentFurniture::addMallet() {
    constexpr int sides = 24;
    constexpr Appearance birch{Finish::wood, {0.80f, 0.66f, 0.46f}};
    using Vector = FurnitureParts::Vector;
    built.addBall(Vector::Zero(), 1, sides);
    malletParts.first = built.finish({});
    built.addRod(Vector::Zero(), Vector::UnitZ(), 1, 1, sides / 2);
    malletParts.second = built.finish(birch);
    built.parts.resize(built.parts.size() - 2);
}

void InstrumentFurniture::addForKeyboard(const std::vector<InstrumentView::PlayedObject>& played,
                                         const ObjectScene& scene) {
    std::vector<KeyboardBar> bars;
    float front = std::numeric_limits<float>::max();
    for (const auto& object : scene.objects())
        front = std::min(front, object.middle[1]);
    for (std::size_t i = 0; i < played.size(); ++i) {
        const auto& object = scene.objects()[i];
        if (object.vertexCount == 0)
            continue;
        const auto half = vectorOf(object.halfExtent);
        const float tubeRadius = tubeShare * half.x();
        bars.push_back({.middle = vectorOf(object.middle),
                        .half = half,
                        .tubeRadius = tubeRadius,
                        .tubeMetres = tubeMetresOf(played[i], tubeRadius),
                        .isBehind = scene.isBehind(i),
                        .finish = appearanceOf(played[i].object->material).finish});
    }
    if (bars.empty())
        return;
    if (!played.front().object->clampedVertices.empty())
        floor = addTineBoard(built, bars);
    else if (bars.front().half.z() > bars.front().half.y())
        floor = addChimeFrame(built, bars);
    else
        floor = addKeyboardFrame(built, bars);
}

void InstrumentFurniture::addForStage(const std::vector<InstrumentView::PlayedObject>& played,
                                      const ObjectScene& scene,
                                      std::span<const BodyNow> bodies) {
    std::vector<bool> isDone(scene.objects().size());
    floor = std::numeric_limits<float>::max();
    for (const auto& body : bodies) {
        const auto index = static_cast<std::size_t>(body.object);
        if (index >= isDone.size() || scene.objects()[index].vertexCount == 0)
            continue;
        const auto& object = scene.objects()[index];
        for (const auto& corner : scene.outline(std::span(&body, 1)))
            floor = std::min(floor, corner[2]);
        if (isDone[index])
            continue;
        isDone[index] = true;
        if (isTableTop(object)) {
            const float below = addLegs(built, object);
            built.parts.back().object = index;
            floor = std::min(floor, body.originMetres[2] + below);
        }
    }
    for (std::size_t i = 0; i < isDone.size(); ++i)
        if (isDie(scene.objects()[i])) {
            addPips(built, scene.objects()[i]);
            built.parts.back().object = i;
        }
    constexpr std::size_t fewestBars = 5; // of an instrument
    if (const auto bars = barsOf(played, scene, bodies); bars.size() >= fewestBars)
        floor = std::min(floor, addKeyboardFrame(built, bars));
    if (bodies.empty())
        floor = 0;
}

} // namespace idiophone
