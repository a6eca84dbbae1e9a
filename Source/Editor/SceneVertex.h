// Places and vertices of the picture.
#pragma once

#include <Eigen/Core>
#include <array>

namespace idiophone {

/// Metres; x points right, y away from the player, z up.
using ScenePlace = std::array<float, 3>;

template <class Vector>
ScenePlace scenePlace(const Eigen::MatrixBase<Vector>& vector) {
    const Eigen::Vector3f place = vector.template cast<float>();
    return {place.x(), place.y(), place.z()};
}

inline Eigen::Vector3f vectorOf(const ScenePlace& place) {
    return Eigen::Vector3f(place.data());
}

struct SceneVertex {
    ScenePlace place;
    std::array<float, 3> normal; ///< unit, or zero
};

} // namespace idiophone
