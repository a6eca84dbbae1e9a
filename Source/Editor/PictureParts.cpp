#include "Editor/PictureParts.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace idiophone {
namespace {

using Eigen::Matrix4f, Eigen::Vector3f;

void addFurniture(const SceneFrame& frame,
                  std::optional<std::size_t> object,
                  const Matrix4f& pose,
                  std::vector<PicturePart>& parts) {
    for (const auto& part : frame.furniture->parts()) {
        if (part.object != object)
            continue;
        Matrix4f turned = pose;
        if (part.turnsAbout) {
            const Vector3f axis = vectorOf(*part.turnsAbout);
            turned = (Eigen::Translation3f(axis) *
                      Eigen::AngleAxisf(frame.discRadians, Vector3f::UnitX()) *
                      Eigen::Translation3f(-axis))
                         .matrix();
        }
        parts.push_back({part.shape, part.look, turned, std::nullopt, parts.size()});
    }
}

void addObjects(const SceneFrame& frame, std::vector<PicturePart>& parts) {
    const auto objects = frame.scene->objects();
    const auto add = [&](std::size_t object, const Matrix4f& pose) {
        if (object < std::min(objects.size(), frame.appearances.size()))
            parts.push_back({objects[object], frame.appearances[object], pose, object, object});
    };
    if (!frame.bodies) {
        for (std::size_t object = 0; object < objects.size(); ++object)
            add(object, Matrix4f::Identity());
    } else
        for (const auto& body : *frame.bodies) {
            const Matrix4f pose = Eigen::Map<const Matrix4f>(body.pose.data());
            add(body.object, pose);
            addFurniture(frame, body.object, pose, parts);
        }
    addFurniture(frame, std::nullopt, Matrix4f::Identity(), parts);
}

/// The furniture's mallet lies along z, with a head of radius 1 and a stick of length 1.
void addMallet(const SceneFrame& frame,
               const DrawnMallet& mallet,
               std::vector<PicturePart>& parts) {
    constexpr float stickRadius = 0.0042f;
    const auto turn = Eigen::Quaternionf::FromTwoVectors(Vector3f::UnitZ(), vectorOf(mallet.stick));
    const auto add = [&](const FurniturePart& part, const Appearance& look, const Vector3f& scale) {
        const auto pose =
            Eigen::Translation3f(vectorOf(mallet.head)) * turn * Eigen::Scaling(scale);
        parts.push_back({part.shape, look, pose.matrix(), std::nullopt, 0});
    };
    const auto& [head, stick] = frame.furniture->mallet();
    add(head, frame.malletHead, Vector3f::Constant(mallet.headMetres));
    add(stick, stick.look, {stickRadius, stickRadius, mallet.stickMetres});
}

} // namespace

std::vector<PicturePart> partsOf(const SceneFrame& frame) {
    std::vector<PicturePart> parts;
    addObjects(frame, parts);
    for (const auto& mallet : frame.mallets)
        addMallet(frame, mallet, parts);
    return parts;
}

std::vector<bool> shadowCasters(std::span<const PicturePart> parts) {
    std::vector<bool> casters;
    for (const auto& part : parts)
        casters.push_back(part.look.finish != Finish::glass);
    return casters;
}

std::vector<SceneVertex> placedVertices(const SceneFrame& frame) {
    std::vector<PicturePart> parts;
    addObjects(frame, parts);
    std::ranges::sort(parts, {}, [](const auto& part) { return part.shape.firstVertex; });
    const auto objects = frame.scene->vertices();
    const std::span furniture = frame.furniture->vertices();
    std::vector<SceneVertex> placed;
    for (const auto& [shape, look, pose, object, number] : parts) {
        const auto vertices =
            shape.firstVertex < objects.size()
                ? objects.subspan(shape.firstVertex, shape.vertexCount)
                : furniture.subspan(shape.firstVertex - objects.size(), shape.vertexCount);
        for (const auto& vertex : vertices) {
            const Vector3f place = (pose * vectorOf(vertex.place).homogeneous()).head<3>();
            const Vector3f normal = pose.topLeftCorner<3, 3>() * vectorOf(vertex.normal);
            placed.push_back({scenePlace(place), scenePlace(normal)});
        }
    }
    return placed;
}

} // namespace idiophone
