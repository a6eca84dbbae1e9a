#include "Instrument/ParameterGlide.h"

#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

/// Share of a parameter's range; a smaller step is not heard.
constexpr double smallestStep = 2e-5;

} // namespace

double ParameterGlide::fractionPerCell(double secondsPerCell) noexcept {
    return -std::expm1(-secondsPerCell / glideSeconds);
}

ParameterGlide::ParameterGlide(double secondsPerCell) : share(fractionPerCell(secondsPerCell)) {}

void ParameterGlide::setGoal(const ParameterValues& wanted) noexcept {
    if (wanted == goal && !isFresh)
        return;
    const auto before = now;
    now = goal = wanted;
    if (std::exchange(isFresh, false))
        return;
    const bool isOtherMaterial = before[material] != wanted[material];
    for (const auto& info : parameterTable()) {
        const bool isMaterialFigure =
            std::ranges::find(materialFigures, info.parameter) != materialFigures.end();
        if (info.glides && !(isOtherMaterial && isMaterialFigure))
            now.set(info.parameter, before[info.parameter]);
    }
    isMoving = now != goal;
}

void ParameterGlide::advance() noexcept {
    if (!isMoving)
        return;
    for (const auto& info : parameterTable()) {
        const double wanted = goal[info.parameter];
        if (now[info.parameter] == wanted)
            continue;
        const double from = info.toNormalised(now[info.parameter]);
        const double distance = info.toNormalised(wanted) - from;
        now.set(info.parameter, std::abs(distance) > smallestStep
                                    ? info.fromNormalised(from + share * distance)
                                    : wanted);
    }
    isMoving = now != goal;
}

} // namespace idiophone
