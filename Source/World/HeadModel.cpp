// SPDX-License-Identifier: Apache-2.0
#include "World/HeadModel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

using std::numbers::pi;

constexpr double headRadiusMetres = 0.0875, soundMetresPerSecond = 343;
constexpr double headSeconds = headRadiusMetres / soundMetresPerSecond;
constexpr double earDegrees = 100; // from straight ahead: a little behind the middle
constexpr double minimumHighGain = 0.1, darkestDegrees = 150;
constexpr double airDecibelsAMetre = 0.16;

/// Delay around the far side of the sphere (Woodworth). 0 if the sound comes straight at the ear.
double delaySeconds(double incidenceRadians) {
    const double arrival =
        incidenceRadians < pi / 2 ? -std::cos(incidenceRadians) : incidenceRadians - pi / 2;
    return headSeconds * (1 + arrival);
}

double highFrequencyGain(double incidenceRadians) {
    return 1 + minimumHighGain / 2 +
           (1 - minimumHighGain / 2) * std::cos(incidenceRadians * 180 / darkestDegrees);
}

} // namespace

HeadShadow headShadow(double highFrequencyGain, double sampleRateHz) {
    const double warped = sampleRateHz * headSeconds;
    return {.direct = (1 + highFrequencyGain * warped) / (1 + warped),
            .previous = (1 - highFrequencyGain * warped) / (1 + warped),
            .feedback = (1 - warped) / (1 + warped)};
}

double HeadShadow::energy() const {
    return (direct * direct + previous * previous - 2 * feedback * direct * previous) /
           (1 - feedback * feedback);
}

HeadModel::HeadModel(const Listener& listener) : position(listener.positionMetres) {
    Eigen::Vector3d up = listener.up.normalized();
    if (!(up.squaredNorm() > 0))
        up = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d ahead = listener.towardsMetres - listener.positionMetres;
    ahead -= ahead.dot(up) * up;
    if (ahead.norm() < 1e-9) // the listener looks straight up or down
        ahead = std::abs(up.y()) < 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
    ahead = (ahead - ahead.dot(up) * up).normalized();
    axes << ahead, up.cross(ahead), up;
    for (std::size_t ear = 0; ear < 2; ++ear) {
        const double turn = (ear == 0 ? 1 : -1) * earDegrees * pi / 180;
        ears[ear] = Eigen::AngleAxisd(turn, up) * ahead;
    }
}

HeardPath HeadModel::path(const Eigen::Vector3d& placeMetres) const {
    const Eigen::Vector3d way = placeMetres - position;
    const double metres = std::max(way.norm(), nearestMetres);
    HeardPath path{.ears = {},
                   .direction = axes.transpose() * way,
                   .gain = 1 / metres,
                   .airGain = std::pow(10, -airDecibelsAMetre * metres / 20)};
    for (std::size_t ear = 0; ear < 2; ++ear) {
        const double incidenceRadians =
            std::acos(std::clamp(way.dot(ears[ear]) / metres, -1.0, 1.0));
        path.ears[ear] = {.delaySeconds = delaySeconds(incidenceRadians),
                          .highFrequencyGain = highFrequencyGain(incidenceRadians)};
    }
    return path;
}

} // namespace idiophone
