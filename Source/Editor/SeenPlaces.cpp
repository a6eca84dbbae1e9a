#include "Editor/SeenPlaces.h"

#include <algorithm>

namespace idiophone {
namespace {

float aspectOf(juce::Rectangle<float> area) {
    return area.getWidth() / std::max(area.getHeight(), 1.0f);
}

bool isHidden(const ObjectScene& scene,
              const ScenePlace& eye,
              const ScenePlace& place,
              float depthMetres) {
    const Eigen::Vector3f from = vectorOf(eye), sight = vectorOf(place) - from;
    const auto hit = scene.pick(eye, scenePlace(sight));
    return hit && (vectorOf(hit->place) - from).norm() <
                      sight.norm() - 0.01f * scene.radius() - depthMetres;
}

} // namespace

SeenPlaces::SeenPlaces(const ObjectScene& shownScene,
                       const OrbitCamera& camera,
                       juce::Rectangle<float> area)
    : scene(shownScene), eye(camera.eye(aspectOf(area))),
      projection(camera.viewProjection(aspectOf(area)), area) {}

std::vector<SeenPlace> SeenPlaces::of(std::span<const ScenePlace> places, float depthMetres) const {
    std::vector<SeenPlace> seen;
    for (const auto& place : places)
        if (const auto pixel = projection.pixelOf(vectorOf(place)))
            seen.push_back({.at = *pixel, .isHidden = isHidden(scene, eye, place, depthMetres)});
    return seen;
}

float SeenPlaces::pixelsOfBall(const ScenePlace& centre, float radiusMetres) const {
    const auto middle = projection.pixelOf(vectorOf(centre));
    float pixels = 0;
    for (int axis = 0; middle && axis < 3; ++axis)
        if (const auto rim =
                projection.pixelOf(vectorOf(centre) + radiusMetres * Eigen::Vector3f::Unit(axis)))
            pixels = std::max(pixels, rim->getDistanceFrom(*middle));
    return pixels;
}

} // namespace idiophone
