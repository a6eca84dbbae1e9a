#include "Editor/SlowMotion.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace idiophone {
namespace {

/// Motion this far below the largest strike is invisible. In between, the visible displacement is
/// linear in decibels.
constexpr double visibleDecibels = 60;
/// Swing rate of the lowest mode, and maximum. Others scale with the square root of the frequency
/// ratio, which keeps them distinct and slow enough for 30 pictures a second.
constexpr double lowestSwingHz = 1.6, fastestSwingHz = 9;
/// The reference falls by this factor per frame, so that soft strikes after loud ones are visible.
constexpr double forgetting = 0.995;

} // namespace

void SlowMotion::follow(std::span<const ModeNow> modes) {
    std::vector<Shown> next;
    double whole = 0;
    for (std::size_t mode = 0; mode < modes.size(); ++mode) {
        const auto& now = modes[mode];
        if (now.standing != ModeStanding::sounding || now.amplitude <= 0 || now.frequencyHz <= 0)
            continue;
        const double displacement =
            double(now.amplitude) / (2 * std::numbers::pi * double(now.frequencyHz));
        whole += displacement;
        next.push_back({.mode = mode,
                        .extent = displacement,
                        .frequencyHz = double(now.frequencyHz),
                        .phase = 0});
    }
    largestDisplacement = std::max(whole, forgetting * largestDisplacement);
    visible = whole > 0
                  ? std::clamp(1 + 20 * std::log10(whole / largestDisplacement) / visibleDecibels,
                               0.0, 1.0)
                  : 0;
    if (visible <= 0)
        next.clear();
    if (next.size() > maximumModes) {
        std::ranges::partial_sort(next, next.begin() + maximumModes, std::greater{},
                                  &Shown::extent);
        next.resize(maximumModes);
        std::ranges::sort(next, {}, &Shown::mode);
    }
    for (auto& mode : next) {
        const auto before = std::ranges::find(shown, mode.mode, &Shown::mode);
        mode.phase = before == shown.end() ? std::numbers::pi / 2 : before->phase;
        mode.extent /= whole;
    }
    shown = std::move(next);
}

void SlowMotion::advance(double seconds) {
    if (shown.empty())
        return;
    const double lowest = std::ranges::min(shown, {}, &Shown::frequencyHz).frequencyHz;
    for (auto& mode : shown) {
        const double swingHz =
            std::min(lowestSwingHz * std::sqrt(mode.frequencyHz / lowest), fastestSwingHz);
        mode.phase = std::remainder(mode.phase + 2 * std::numbers::pi * swingHz * seconds,
                                    2 * std::numbers::pi);
    }
}

std::vector<SlowMotion::Swing> SlowMotion::swings() const {
    std::vector<Swing> result;
    for (const auto& mode : shown)
        result.push_back(
            {.mode = mode.mode,
             .displacement = static_cast<float>(visible * mode.extent * std::sin(mode.phase))});
    return result;
}

void SlowMotion::reset() {
    *this = {};
}

} // namespace idiophone
