#include "Instrument/ParameterGlide.h"

#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr std::array gliding{youngsModulus, density,      fluidDamping, viscoelasticDamping,
                             lossFactor,    size,         thickness,    tune,
                             concertPitch,  contactForce, contactSpeed, roughness,
                             rollCoupling,  releaseTime};

/// Of a parameter's way from end to end; less is not heard as a step.
constexpr double smallestStep = 2e-5;

} // namespace

ParameterGlide::ParameterGlide(double secondsPerCell)
    : share(-std::expm1(-secondsPerCell / glideSeconds)) {}

void ParameterGlide::setGoal(const ParameterValues& wanted) noexcept {
    if (wanted == goal && !isFresh)
        return;
    const auto before = now;
    now = goal = wanted;
    if (std::exchange(isFresh, false))
        return;
    const bool isOtherMaterial = before[material] != wanted[material];
    for (const auto parameter : gliding)
        if (!(isOtherMaterial &&
              std::ranges::find(materialFigures, parameter) != materialFigures.end()))
            now.set(parameter, before[parameter]);
    isMoving = now != goal;
}

void ParameterGlide::advance() noexcept {
    if (!isMoving)
        return;
    for (const auto parameter : gliding) {
        if (now[parameter] == goal[parameter])
            continue;
        const auto& info = parameterInfo(parameter);
        const double from = info.toNormalised(now[parameter]);
        const double way = info.toNormalised(goal[parameter]) - from;
        now.set(parameter, std::abs(way) > smallestStep ? info.fromNormalised(from + share * way)
                                                        : goal[parameter]);
    }
    isMoving = now != goal;
}

} // namespace idiophone
