#include "Editor/MalletSwings.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using Eigen::Vector3f;

/// The height of the head above the surface, as a share of the stick: up after the contact, at rest
/// above it, then away.
float heightAt(double age, float strength) {
    constexpr double riseSeconds = 0.09, leaveSeconds = 0.55;
    const double risen =
        1 - std::exp(-std::max(age - MalletSwings::contactSeconds, 0.0) / riseSeconds);
    const double leaving =
        std::max(age - leaveSeconds, 0.0) / (MalletSwings::swingSeconds - leaveSeconds);
    return static_cast<float>((0.10 + 0.16 * double(strength)) * risen + 1.6 * leaving * leaving);
}

} // namespace

void MalletSwings::strike(const ScenePlace& place, const ScenePlace& normal, float strength) {
    constexpr double backSeconds = 0.25; // until a mallet may strike again
    if (!swings.empty() && (swings.front().age > backSeconds || swings.size() >= maximumMallets)) {
        nextSide = swings.front().side;
        swings.erase(swings.begin());
    }
    swings.push_back({vectorOf(place), vectorOf(normal), strength, nextSide, 0});
    nextSide = -nextSide;
}

void MalletSwings::advance(double seconds) {
    for (auto& swing : swings)
        swing.age += seconds;
    std::erase_if(swings, [](const Swing& swing) { return swing.age >= swingSeconds; });
}

std::vector<DrawnMallet> MalletSwings::mallets(float headMetres, float stickMetres) const {
    std::vector<DrawnMallet> result;
    for (const auto& [place, normal, strength, side, age] : swings) {
        // The hand is on the player's side, above the surface, and rises less than the head.
        Vector3f reach = Vector3f(0.26f * side, -0.92f, 0.06f) + 0.16f * normal;
        constexpr float flattest = 0.3f;
        reach += std::max(flattest - reach.dot(normal), 0.0f) * normal;
        const float height = stickMetres * heightAt(age, strength);
        const Vector3f touching = place + headMetres * normal;
        const Vector3f hand = touching + stickMetres * reach.normalized() + 0.3f * height * normal;
        const Vector3f head = touching + height * normal;
        result.push_back({.head = scenePlace(head),
                          .stick = scenePlace((hand - head).normalized()),
                          .headMetres = headMetres,
                          .stickMetres = stickMetres});
    }
    return result;
}

} // namespace idiophone
