#include "Scene/TouchTracker.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr double smoothingSeconds = 0.004;   // of force and speeds, which jitter from step to step
constexpr double longestPauseSeconds = 0.03; // a pair keeps its voice during a shorter hop
constexpr double spacingMetres = 0.002;      // a contact point that moved further is computed again
constexpr double slowestMetresPerSecond = 1e-3;

/// Compares the loudness of contacts by the force of sliding or rolling.
double loudness(const Touch& touch) {
    return touch.forceNewtons * std::max(touch.slideMetresPerSecond, touch.rollMetresPerSecond);
}

} // namespace

TouchTracker::TouchTracker(std::shared_ptr<const SceneAssets> playedAssets, double stepSeconds)
    : assets(std::move(playedAssets)), share(-std::expm1(-stepSeconds / smoothingSeconds)),
      longestPauseSteps(longestPauseSeconds / stepSeconds) {}

/// Returns the voice of the pair, or a free one, or `touchVoices`.
std::size_t TouchTracker::voiceFor(const Touch& touch) {
    for (std::size_t k = 0; k < touchVoices; ++k)
        if (voices[k].fadeSteps > 0 && voices[k].bodies == touch.bodies)
            return k;
    for (std::size_t k = 0; k < touchVoices; ++k)
        if (!(voices[k].fadeSteps > 0)) {
            voices[k].bodies = touch.bodies;
            voices[k].isPlaced = false;
            now[k] = {.pair = ++pairCount};
            return k;
        }
    return touchVoices;
}

void TouchTracker::follow(std::span<const Touch> touches,
                          std::span<const std::size_t> roles,
                          std::span<const std::size_t> slots) {
    loudest.clear();
    for (const Touch& touch : touches)
        if (std::max(touch.slideMetresPerSecond, touch.rollMetresPerSecond) >
            slowestMetresPerSecond)
            loudest.push_back(&touch);
    std::ranges::stable_sort(loudest, [](const Touch* one, const Touch* other) {
        return loudness(*one) > loudness(*other);
    });

    std::array<const Touch*, touchVoices> touching{};
    for (const Touch* touch : loudest) {
        const auto voice = voiceFor(*touch);
        if (voice == touchVoices)
            continue;
        voices[voice].fadeSteps = longestPauseSteps;
        touching[voice] = touch;
        for (std::size_t side = 0; side < 2; ++side)
            now[voice].slots[side] = slots[touch->bodies[side]];
        move(voice, *touch, roles);
    }
    for (std::size_t k = 0; k < touchVoices; ++k) {
        const Touch* touch = touching[k];
        const auto approach = [this](double& value, double goal) {
            value += share * (goal - value);
        };
        approach(now[k].forceNewtons, touch != nullptr ? touch->forceNewtons : 0);
        if (touch == nullptr) {
            voices[k].fadeSteps -= 1;
            continue;
        }
        approach(now[k].slideMetresPerSecond, touch->slideMetresPerSecond);
        approach(now[k].rollMetresPerSecond, touch->rollMetresPerSecond);
    }
}

void TouchTracker::move(std::size_t voice, const Touch& touch, std::span<const std::size_t> roles) {
    auto& state = now[voice];
    const auto role = [&](std::size_t side) { return roles[touch.bodies[side]]; };
    const auto& all = assets->roles();
    // The rougher surface sounds.
    const auto surface = [&](std::size_t side) { return all[role(side)].surfaceIndex; };
    const auto roughness = [&](std::size_t side) {
        return assets->surfaces()[surface(side)].roughness;
    };
    state.surface = surface(roughness(0) > roughness(1) ? 0 : 1);
    for (std::size_t side = 0; side < 2; ++side) {
        auto& last = voices[voice].pointMetres[side];
        const Eigen::Vector3d& place = touch.pointMetres[side];
        if (voices[voice].isPlaced && (place - last).norm() < spacingMetres)
            continue;
        last = place;
        const auto& played = all[role(side)];
        if (!played.isHeard())
            continue;
        const Eigen::Vector3d own = place / played.kind.model->sizeRatio;
        state.points[side].point = played.surface->nearest({own.x(), own.y(), own.z()});
        for (int axis = 0; axis < 3; ++axis)
            state.points[side].direction[static_cast<std::size_t>(axis)] =
                static_cast<float>(touch.inward[side](axis));
    }
    voices[voice].isPlaced = true;
}

} // namespace idiophone
