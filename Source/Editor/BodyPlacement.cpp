#include "Editor/BodyPlacement.h"

#include <Eigen/Geometry>

namespace idiophone {
namespace {

using Vector = Eigen::Vector3f;

Eigen::Isometry3f poseOf(const BodyNow& body) {
    return Eigen::Translation3f(Vector(body.originMetres.data())) *
           Eigen::Quaternionf(body.turn.data());
}

ScenePlace asPlace(const Vector& vector) {
    return {vector.x(), vector.y(), vector.z()};
}

} // namespace

std::array<float, 16> matrixOf(const BodyNow& body) {
    std::array<float, 16> matrix{};
    Eigen::Map<Eigen::Matrix4f>(matrix.data()) = poseOf(body).matrix();
    return matrix;
}

ScenePlace turnedBack(const BodyNow& body, const ScenePlace& direction) {
    return asPlace(poseOf(body).linear().transpose() * Vector(direction.data()));
}

ScenePlace onStage(const BodyNow& body, const ScenePlace& own) {
    return asPlace(poseOf(body) * Vector(own.data()));
}

ScenePlace onBody(const BodyNow& body, const ScenePlace& place) {
    return asPlace(poseOf(body).inverse() * Vector(place.data()));
}

} // namespace idiophone
