#include "Scene/RecordedHand.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

Eigen::Vector3d RecordedHand::inwardAt(const Eigen::Vector3d& pointMetres) const {
    const Eigen::Vector3d own = pointMetres / object.kind.model->sizeRatio;
    const auto normal = object.surface->nearest({own.x(), own.y(), own.z()}).normal;
    return -Eigen::Vector3f(normal.data()).cast<double>();
}

std::optional<Touch>
RecordedHand::touchAt(double seconds, std::size_t body, std::size_t handBody) const {
    const auto next = std::ranges::upper_bound(recorded.path, seconds, {}, &Hand::Moment::seconds);
    if (next == recorded.path.begin() || next == recorded.path.end())
        return std::nullopt;
    const auto &from = *std::prev(next), &to = *next;
    const double duration = to.seconds - from.seconds;
    const double share = (seconds - from.seconds) / duration;
    const double newtons = std::lerp(from.newtons, to.newtons, share);
    if (!(newtons > 0))
        return std::nullopt;
    const Eigen::Vector3d way = to.pointMetres - from.pointMetres;
    const Eigen::Vector3d point = from.pointMetres + share * way;
    const Eigen::Vector3d inward = inwardAt(point);
    return Touch{.bodies = {body, handBody},
                 .pointMetres = {point, Eigen::Vector3d::Zero()},
                 .inward = {inward, -inward},
                 .forceNewtons = newtons,
                 .slideMetresPerSecond = way.norm() / duration,
                 .rollMetresPerSecond = 0};
}

std::vector<Impact>
RecordedHand::tapsBetween(double from, double until, std::size_t body, std::size_t handBody) const {
    const auto &model = *object.kind.model, &tool = *head.kind.model;
    const double rebound = std::sqrt(model.restitution * tool.restitution);
    std::vector<Impact> impacts;
    for (auto tap = std::ranges::lower_bound(recorded.taps, from, {}, &Hand::Tap::seconds);
         tap != recorded.taps.end() && tap->seconds < until; ++tap)
        impacts.push_back(
            {.seconds = tap->seconds,
             .body = body,
             .other = handBody,
             .pointMetres = tap->pointMetres,
             .impulseNewtonSeconds =
                 (1 + rebound) * tool.massKg * tap->metresPerSecond * inwardAt(tap->pointMetres),
             .contactSeconds = contactSeconds(model, tool, tool.massKg, tap->metresPerSecond),
             .speedMetresPerSecond = tap->metresPerSecond});
    return impacts;
}

} // namespace idiophone
