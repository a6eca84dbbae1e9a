#include "Editor/ObjectScene.h"

#include "Editor/ObjectShelf.h"

#include <algorithm>
#include <cstdint>
#include <juce_audio_basics/juce_audio_basics.h>
#include <limits>

namespace idiophone {
namespace {

using Eigen::Vector3d;

/// Strength of a click on a stage, where bodies have no near end: half way from soft to hard.
constexpr double stageStrength = 0.5;

/// Faces that round objects may be divided into, of all objects together.
constexpr std::size_t maximumFineFaces = 24'000;

constexpr std::int64_t boxesForStage = 5'000'000; // limit per click, about 0.1 s

Eigen::AlignedBox3d boxOf(const ModalObject& object) {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i + 2 < object.vertices.size(); i += 3)
        box.extend(Eigen::Vector3f(&object.vertices[i]).cast<double>());
    return box;
}

} // namespace

/// Lays the bars out as on a mallet instrument. They lie along y, with naturals in a row and
/// accidentals behind and above them in the gaps. An object that is higher than long, such as a
/// chime, hangs by its upper end. Tines, which are held, form one row like the teeth of a comb,
/// with their far ends at y = 0.
std::vector<ObjectScene::Placement>
ObjectScene::keyboardOf(const std::vector<InstrumentView::PlayedObject>& played) {
    constexpr double gapMetres = 0.006, overlap = 0.9, combColumn = 3.2; // in widths of a tine
    // Turn the bar's x axis to the scene's y.
    const Eigen::Matrix3d turned{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    std::vector<Eigen::AlignedBox3d> boxes;
    double widest = 0, tallest = 0;
    for (const auto& [object, sizeRatio, lowestNote, highestNote] : played) {
        boxes.push_back(boxOf(*object));
        widest = std::max(widest, sizeRatio * boxes.back().sizes().y());
        tallest = std::max(tallest, sizeRatio * boxes.back().sizes().z());
    }
    std::vector<Placement> result;
    const bool isComb = std::ranges::all_of(
        played, [](const auto& one) { return !one.object->clampedVertices.empty(); });
    const double column = isComb ? combColumn * widest : widest + gapMetres;
    double x = 0, naturalLength = 0;
    for (std::size_t i = 0; i < played.size(); ++i) {
        const double length = played[i].sizeRatio * boxes[i].sizes().x();
        const double height = played[i].sizeRatio * boxes[i].sizes().z();
        const bool behind = juce::MidiMessage::isMidiNoteBlack(played[i].lowestNote);
        Placement placement{.pivot = boxes[i].center(),
                            .axes = turned,
                            .scale = played[i].sizeRatio,
                            .isBehind = behind && !isComb};
        const double across = behind ? x - column / 2 : x;
        if (height > length) {
            placement.origin << across, (behind ? column : 0), -height / 2;
        } else if (isComb) {
            placement.origin << across, -length / 2, 0;
        } else if (behind) {
            placement.origin << across, overlap * (naturalLength + length) / 2, 1.5 * tallest;
        } else {
            placement.origin << across, 0, 0;
            naturalLength = length;
        }
        x += behind ? 0 : column;
        placement.nearest = placement.origin.y() - length / 2;
        placement.farthest = placement.origin.y() + length / 2;
        result.push_back(placement);
    }
    return result;
}

std::vector<ObjectScene::Placement>
ObjectScene::shelfOf(const std::vector<InstrumentView::PlayedObject>& played) {
    std::vector<Vector3d> middles, sizes;
    std::vector<KeyboardForm> forms;
    for (const auto& one : played) {
        const auto box = boxOf(*one.object);
        middles.push_back(box.center());
        sizes.push_back(one.sizeRatio * box.sizes());
        forms.push_back(keyboardForm(sizes.back(), !one.object->clampedVertices.empty()));
    }
    std::vector<Placement> result;
    if (!standOnShelf(forms))
        return result;
    for (const auto& [middle, scale] : shelfPlaces(sizes)) {
        const auto i = result.size();
        const double depth = scale * sizes[i].y();
        result.push_back({.pivot = middles[i],
                          .origin = middle,
                          .scale = scale * played[i].sizeRatio,
                          .nearest = middle.y() - depth / 2,
                          .farthest = middle.y() + depth / 2});
    }
    return result;
}

ObjectScene::ObjectScene(const std::vector<InstrumentView::PlayedObject>& played, Layout layout) {
    if (layout == Layout::stage) {
        for (const auto& object : played)
            placements.push_back({.scale = object.sizeRatio});
    } else if (played.size() > 1) {
        placements = shelfOf(played);
        onShelf = !placements.empty();
        if (!onShelf)
            placements = keyboardOf(played);
    } else if (!played.empty()) {
        const auto box = boxOf(*played.front().object);
        const double depth = played.front().sizeRatio * box.sizes().y();
        placements = {{.pivot = box.center(),
                       .scale = played.front().sizeRatio,
                       .nearest = -depth / 2,
                       .farthest = depth / 2}};
    }
    std::size_t facesLeft = maximumFaces;
    for (std::size_t i = 0; i < played.size(); ++i) {
        const auto& object = *played[i].object;
        const auto faces = object.faceCount();
        const bool isBox = faces > facesLeft;
        // Few objects are drawn finer than many.
        const auto finest = std::min(facesLeft, maximumFineFaces / played.size());
        addFaces(isBox ? boxMesh(boxOf(object)) : drawingMesh(object, finest), placements[i]);
        facesLeft -= std::min(facesLeft, runs.back().vertexCount / 3);
        runs.back().isBox = isBox;
        objectOfFace.resize(corners.size() / 3, i);
    }
    if (corners.empty())
        return;

    Eigen::AlignedBox3f box;
    for (const auto& corner : corners)
        box.extend(vectorOf(corner.place));
    reach = box.diagonal().norm() / 2;
    if (layout == Layout::stage)
        for (const auto& run : runs)
            surfaces.push_back(surfaceOf(run.firstVertex, run.vertexCount));
    else
        surface.emplace(surfaceOf(0, corners.size()));
}

void ObjectScene::addFaces(const DrawingMesh& mesh, const Placement& placement) {
    runs.push_back({.firstVertex = corners.size(),
                    .vertexCount = mesh.corners.size(),
                    .form = mesh.form,
                    .isClosed = mesh.isClosed});
    for (const auto& corner : mesh.corners) {
        corners.push_back({.place = scenePlace(placement.inScene(corner.place.cast<double>())),
                           .normal = scenePlace(placement.axes * corner.normal.cast<double>())});
        meshPlaces.push_back(corner.onMesh);
    }
    addBox(runs.back());
}

SurfaceQuery ObjectScene::surfaceOf(std::size_t firstVertex, std::size_t vertexCount) const {
    Mesh mesh{Eigen::MatrixXd(vertexCount, 3), Eigen::MatrixXi(vertexCount / 3, 3)};
    for (std::size_t i = 0; i < vertexCount; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        mesh.vertices.row(row) =
            vectorOf(corners[firstVertex + i].place).cast<double>().transpose();
        mesh.faces(row / 3, row % 3) = static_cast<int>(i);
    }
    return SurfaceQuery(std::move(mesh));
}

void ObjectScene::addBox(SceneObject& run) {
    firstBoxCorners.push_back(boxCorners.size());
    if (run.vertexCount == 0)
        return;
    Eigen::AlignedBox3f box;
    for (const auto& corner : std::span(corners).subspan(run.firstVertex, run.vertexCount))
        box.extend(vectorOf(corner.place));
    run.radius = box.diagonal().norm() / 2;
    run.middle = scenePlace(box.center());
    run.halfExtent = scenePlace(box.sizes() / 2);
    for (int index = 0; index < 8; ++index)
        boxCorners.push_back(
            scenePlace(box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(index))));
}

Vector3d ObjectScene::Placement::inScene(const Vector3d& own) const {
    return origin + axes * (own - pivot) * scale;
}

Vector3d ObjectScene::Placement::onMesh(const Vector3d& place) const {
    return pivot + axes.transpose() * (place - origin) / scale;
}

ScenePlace ObjectScene::placeOf(std::size_t object,
                                const std::array<double, 3>& pointMetres) const {
    return scenePlace(placements[object].inScene(Vector3d(pointMetres.data())));
}

std::vector<ScenePlace> ObjectScene::offsetsOf(std::size_t object,
                                               std::span<const float> displacements) const {
    const Eigen::Matrix3f axes = placements[object].axes.cast<float>();
    const auto& run = runs[object];
    std::vector<ScenePlace> offsets(run.vertexCount);
    for (std::size_t corner = 0; corner < run.vertexCount && !run.isBox; ++corner) {
        const auto& [vertices, weights] = meshPlaces[run.firstVertex + corner];
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        for (std::size_t i = 0; i < vertices.size(); ++i)
            sum += weights[i] *
                   Eigen::Vector3f(&displacements[3 * static_cast<std::size_t>(vertices[i])]);
        Eigen::Map<Eigen::Vector3f>(offsets[corner].data()) = axes * sum;
    }
    return offsets;
}

ScenePick ObjectScene::pickOf(std::size_t object, const SurfacePoint& hit) const {
    ScenePick pick{
        .object = object, .place = scenePlace(hit.pointMetres), .normal = scenePlace(hit.normal)};
    Eigen::Map<Vector3d>(pick.pointMetres.data()) = placements[object].onMesh(hit.pointMetres);
    return pick;
}

ScenePlace ObjectScene::normalAt(const ScenePlace& place) const {
    return surface ? scenePlace(surface->nearestPoint(vectorOf(place).cast<double>()).normal)
                   : ScenePlace{0, 0, 1};
}

std::optional<ScenePick> ObjectScene::pick(const ScenePlace& origin,
                                           const ScenePlace& direction) const {
    if (!surface)
        return std::nullopt;
    const auto hit =
        surface->firstHit(vectorOf(origin).cast<double>(), vectorOf(direction).cast<double>());
    if (!hit)
        return std::nullopt;
    auto pick = pickOf(objectOfFace[static_cast<std::size_t>(hit->face)], *hit);
    const auto& placement = placements[pick.object];
    const double depth = placement.farthest - placement.nearest;
    pick.towardsPlayer =
        depth > 0 ? std::clamp((placement.farthest - hit->pointMetres.y()) / depth, 0.0, 1.0) : 1;
    return pick;
}

std::vector<ScenePlace> ObjectScene::outline(std::span<const BodyNow> bodies) const {
    constexpr std::size_t boxSize = 8;
    std::vector<ScenePlace> places;
    for (const auto& body : bodies) {
        const auto object = static_cast<std::size_t>(body.object);
        if (object >= runs.size() || runs[object].vertexCount == 0)
            continue;
        for (const auto& corner : std::span(boxCorners).subspan(firstBoxCorners[object], boxSize))
            places.push_back(scenePlace(poseOf(body) * vectorOf(corner)));
    }
    return places;
}

std::optional<ScenePick> ObjectScene::pick(const ScenePlace& origin,
                                           const ScenePlace& direction,
                                           std::span<const BodyNow> bodies) const {
    std::optional<ScenePick> nearest;
    double nearestMetres = std::numeric_limits<double>::infinity();
    std::int64_t boxesLeft = boxesForStage;
    for (const auto& body : bodies) {
        const auto object = static_cast<std::size_t>(body.object);
        if (object >= surfaces.size())
            continue;
        const auto pose = poseOf(body), toBody = pose.inverse();
        const Vector3d start = (toBody * vectorOf(origin)).cast<double>();
        const Vector3d towards = (toBody.linear() * vectorOf(direction)).cast<double>();
        const auto hit = surfaces[object].firstHit(start, towards, boxesLeft);
        if (!hit || !((hit->pointMetres - start).norm() < nearestMetres))
            continue;
        nearestMetres = (hit->pointMetres - start).norm();
        nearest = pickOf(object, *hit);
        nearest->place = scenePlace(pose * vectorOf(nearest->place));
        nearest->towardsPlayer = stageStrength;
        nearest->body = body;
    }
    return nearest;
}

} // namespace idiophone
