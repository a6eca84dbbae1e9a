#include "Editor/ObjectScene.h"

#include "Editor/BodyPlacement.h"
#include "Editor/MaterialColour.h"
#include "Geometry/ObjectMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace idiophone {
namespace {

using Place = std::array<double, 3>;

/// Of a click on a stage, where no end of a body is the player's: half way from soft to hard.
constexpr double stageStrength = 0.5;

struct Box {
    Place lowest, highest;

    explicit Box(const ModalObject& object) {
        lowest.fill(std::numeric_limits<double>::infinity());
        highest.fill(-std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < object.vertices.size(); ++i) {
            const double value = static_cast<double>(object.vertices[i]);
            lowest[i % 3] = std::min(lowest[i % 3], value);
            highest[i % 3] = std::max(highest[i % 3], value);
        }
    }

    double size(std::size_t axis) const { return highest[axis] - lowest[axis]; }
    Place centre() const {
        return {(lowest[0] + highest[0]) / 2, (lowest[1] + highest[1]) / 2,
                (lowest[2] + highest[2]) / 2};
    }
};

bool isAccidental(int note) {
    switch (note % 12) {
    case 1:
    case 3:
    case 6:
    case 8:
    case 10:
        return true;
    default:
        return false;
    }
}

} // namespace

/// Bars lie along y, the naturals in a row, the accidentals behind and above them in the gaps, as
/// on every mallet instrument. Bars run along their own x and face up along z. What is higher than
/// long, as chimes are, hangs by its upper end, the accidentals behind.
std::vector<ObjectScene::Placement>
ObjectScene::keyboardOf(const std::vector<ProcessorView::PlayedObject>& played) {
    constexpr double gapMetres = 0.006, overlap = 0.9;
    std::vector<Box> boxes;
    double widest = 0, tallest = 0;
    for (const auto& [object, sizeRatio, lowestNote, highestNote] : played) {
        boxes.emplace_back(*object);
        widest = std::max(widest, sizeRatio * boxes.back().size(1));
        tallest = std::max(tallest, sizeRatio * boxes.back().size(2));
    }
    std::vector<Placement> result;
    const double column = widest + gapMetres;
    double x = 0, naturalLength = 0;
    for (std::size_t i = 0; i < played.size(); ++i) {
        const double length = played[i].sizeRatio * boxes[i].size(0);
        const double height = played[i].sizeRatio * boxes[i].size(2);
        const bool behind = isAccidental(played[i].lowestNote);
        Placement placement{.pivot = boxes[i].centre(),
                            .axes = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}},
                            .scale = played[i].sizeRatio};
        if (height > length) {
            placement.origin = {behind ? x - column / 2 : x, behind ? column : 0, -height / 2};
            x += behind ? 0 : column;
        } else if (behind) {
            placement.origin = {x - column / 2, overlap * (naturalLength + length) / 2,
                                1.5 * tallest};
        } else {
            placement.origin = {x, 0, 0};
            naturalLength = length;
            x += column;
        }
        placement.nearest = placement.origin[1] - length / 2;
        placement.farthest = placement.origin[1] + length / 2;
        result.push_back(placement);
    }
    return result;
}

ObjectScene::ObjectScene(const std::vector<ProcessorView::PlayedObject>& played, Layout layout) {
    if (layout == Layout::stage) {
        for (const auto& object : played)
            placements.push_back({.scale = object.sizeRatio});
    } else if (played.size() > 1) {
        placements = keyboardOf(played);
    } else if (!played.empty()) {
        const Box box(*played.front().object);
        placements = {{.pivot = box.centre(),
                       .scale = played.front().sizeRatio,
                       .nearest = -played.front().sizeRatio * box.size(1) / 2,
                       .farthest = played.front().sizeRatio * box.size(1) / 2}};
    }
    for (std::size_t i = 0; i < played.size(); ++i) {
        const auto mesh = objectMesh(*played[i].object);
        const auto normals = cornerNormals(mesh);
        const auto& placement = placements[i];
        runs.push_back({.firstVertex = corners.size(),
                        .vertexCount = static_cast<std::size_t>(3 * mesh.faceCount()),
                        .colour = colourOf(played[i].object->material)});
        for (Eigen::Index corner = 0; corner < 3 * mesh.faceCount(); ++corner) {
            const auto vertex = mesh.faces(corner / 3, corner % 3);
            SceneVertex placed{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                double place = placement.origin[axis], normal = 0;
                for (std::size_t own = 0; own < 3; ++own) {
                    const auto component = static_cast<Eigen::Index>(own);
                    place += placement.axes[own][axis] * placement.scale *
                             (mesh.vertices(vertex, component) - placement.pivot[own]);
                    normal += placement.axes[own][axis] * normals(corner, component);
                }
                placed.place[axis] = static_cast<float>(place);
                placed.normal[axis] = static_cast<float>(normal);
            }
            corners.push_back(placed);
            ownVertices.push_back(vertex);
        }
        addBox(runs.back());
        objectOfFace.insert(objectOfFace.end(), static_cast<std::size_t>(mesh.faceCount()), i);
    }
    if (corners.empty())
        return;

    lowest = highest = corners.front().place;
    for (const auto& corner : corners)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lowest[axis] = std::min(lowest[axis], corner.place[axis]);
            highest[axis] = std::max(highest[axis], corner.place[axis]);
        }
    if (layout == Layout::stage)
        for (const auto& run : runs)
            surfaces.push_back(surfaceOf(run.firstVertex, run.vertexCount));
    else
        surface.emplace(surfaceOf(0, corners.size()));
}

SurfaceQuery ObjectScene::surfaceOf(std::size_t firstVertex, std::size_t vertexCount) const {
    Mesh mesh{Eigen::MatrixXd(vertexCount, 3), Eigen::MatrixXi(vertexCount / 3, 3)};
    for (std::size_t i = 0; i < vertexCount; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        for (std::size_t axis = 0; axis < 3; ++axis)
            mesh.vertices(row, static_cast<Eigen::Index>(axis)) =
                static_cast<double>(corners[firstVertex + i].place[axis]);
        mesh.faces(row / 3, row % 3) = static_cast<int>(i);
    }
    return SurfaceQuery(std::move(mesh));
}

void ObjectScene::addBox(SceneObject& run) {
    if (run.vertexCount == 0)
        return;
    ScenePlace least = corners[run.firstVertex].place, most = least;
    for (const auto& corner : std::span(corners).subspan(run.firstVertex, run.vertexCount))
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], corner.place[axis]);
            most[axis] = std::max(most[axis], corner.place[axis]);
        }
    run.radius = std::hypot(most[0] - least[0], most[1] - least[1], most[2] - least[2]) / 2;
    for (unsigned index = 0; index < 8; ++index)
        boxCorners.push_back({index & 1 ? most[0] : least[0], index & 2 ? most[1] : least[1],
                              index & 4 ? most[2] : least[2]});
}

float ObjectScene::radius() const {
    return std::hypot(highest[0] - lowest[0], highest[1] - lowest[1], highest[2] - lowest[2]) / 2;
}

ScenePlace ObjectScene::placeOf(std::size_t object,
                                const std::array<double, 3>& pointMetres) const {
    const auto& placement = placements[object];
    ScenePlace result{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double place = placement.origin[axis];
        for (std::size_t own = 0; own < 3; ++own)
            place += placement.axes[own][axis] * placement.scale *
                     (pointMetres[own] - placement.pivot[own]);
        result[axis] = static_cast<float>(place);
    }
    return result;
}

std::vector<ScenePlace> ObjectScene::offsetsOf(std::size_t object,
                                               std::span<const float> displacements) const {
    const auto& placement = placements[object];
    const auto& run = runs[object];
    std::vector<ScenePlace> offsets(run.vertexCount);
    for (std::size_t corner = 0; corner < run.vertexCount; ++corner) {
        const auto vertex = static_cast<std::size_t>(ownVertices[run.firstVertex + corner]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double sum = 0;
            for (std::size_t own = 0; own < 3; ++own)
                sum += placement.axes[own][axis] * double(displacements[3 * vertex + own]);
            offsets[corner][axis] = static_cast<float>(sum);
        }
    }
    return offsets;
}

std::optional<ScenePick> ObjectScene::pick(const ScenePlace& origin,
                                           const ScenePlace& direction) const {
    if (!surface)
        return std::nullopt;
    const auto hit = surface->firstHit(Eigen::Vector3d(origin[0], origin[1], origin[2]),
                                       Eigen::Vector3d(direction[0], direction[1], direction[2]));
    if (!hit)
        return std::nullopt;
    ScenePick pick{.object = objectOfFace[static_cast<std::size_t>(hit->face)]};
    const auto& placement = placements[pick.object];
    for (std::size_t own = 0; own < 3; ++own) {
        double component = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            component +=
                placement.axes[own][axis] *
                (hit->pointMetres(static_cast<Eigen::Index>(axis)) - placement.origin[axis]);
        pick.pointMetres[own] = placement.pivot[own] + component / placement.scale;
        pick.place[own] = static_cast<float>(hit->pointMetres(static_cast<Eigen::Index>(own)));
    }
    const double depth = placement.farthest - placement.nearest;
    pick.towardsPlayer =
        depth > 0 ? std::clamp((placement.farthest - hit->pointMetres.y()) / depth, 0.0, 1.0) : 1;
    return pick;
}

std::vector<ScenePlace> ObjectScene::outline(std::span<const BodyNow> bodies) const {
    constexpr std::size_t boxSize = 8;
    std::vector<ScenePlace> places;
    for (const auto& body : bodies) {
        const auto first = boxSize * static_cast<std::size_t>(body.object);
        for (std::size_t corner = first; corner < first + boxSize && corner < boxCorners.size();
             ++corner)
            places.push_back(onStage(body, boxCorners[corner]));
    }
    return places;
}

std::optional<ScenePick> ObjectScene::pick(const ScenePlace& origin,
                                           const ScenePlace& direction,
                                           std::span<const BodyNow> bodies) const {
    std::optional<ScenePick> nearest;
    double nearestMetres = std::numeric_limits<double>::infinity();
    for (const auto& body : bodies) {
        const auto object = static_cast<std::size_t>(body.object);
        if (object >= surfaces.size())
            continue;
        const auto from = onBody(body, origin), along = turnedBack(body, direction);
        const Eigen::Vector3d start(from[0], from[1], from[2]);
        const auto hit =
            surfaces[object].firstHit(start, Eigen::Vector3d(along[0], along[1], along[2]));
        if (!hit || !((hit->pointMetres - start).norm() < nearestMetres))
            continue;
        nearestMetres = (hit->pointMetres - start).norm();
        ScenePlace own{};
        nearest = ScenePick{.object = object};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double component = hit->pointMetres(static_cast<Eigen::Index>(axis));
            own[axis] = static_cast<float>(component);
            nearest->pointMetres[axis] = component / placements[object].scale;
        }
        nearest->place = onStage(body, own);
        nearest->towardsPlayer = stageStrength;
    }
    return nearest;
}

} // namespace idiophone
