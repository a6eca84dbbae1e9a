// SPDX-License-Identifier: Apache-2.0
#include "World/World.h"

#include "World/ObjectSurface.h"
#include "World/WorldMixer.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace idiophone {
namespace {

std::array<float, 3> floats(const Eigen::Vector3d& vector) {
    return {static_cast<float>(vector.x()), static_cast<float>(vector.y()),
            static_cast<float>(vector.z())};
}

/// Returns the force at a place for each newton that presses: into the surface, and along the way
/// that the other surface drags it.
ForcePoint pressedAt(const StrikePoint& place, const Eigen::Vector3d& drag) {
    constexpr double friction = 0.3;
    Eigen::Vector3d direction = -Eigen::Vector3f(place.normal.data()).cast<double>();
    if (const double speed = drag.norm(); speed > 0)
        direction += friction / speed * drag;
    return {.point = place, .direction = floats(direction)};
}

constexpr double longestSeconds = 1e9;

bool isFinite(const Listener& listener) {
    return listener.positionMetres.allFinite() && listener.towardsMetres.allFinite() &&
           listener.up.allFinite();
}

} // namespace

Eigen::Vector3d World::Body::own(const Eigen::Vector3d& placeMetres) const {
    return pose.axes.transpose() * (placeMetres - pose.originMetres) / sizeRatio;
}

Eigen::Vector3d World::Body::middleMetres() const {
    const Eigen::Vector3d centre(object->mass.centreMetres.data());
    return pose.originMetres + pose.axes * (sizeRatio * centre);
}

Result<std::unique_ptr<World>> World::make(std::vector<SynthesiserSlot> bodies,
                                           const WorldSettings& settings) {
    if (bodies.empty())
        return failure("the world has no body");
    for (const auto& body : bodies) {
        if (body.object == nullptr || body.object->shapeVertices.empty())
            return failure("a body of the world has no object");
        if (!(body.sizeRatio >= 0.001 && body.sizeRatio <= 1000))
            return failure("a body's size is not between 0.001 and 1000");
    }
    if (!(settings.sampleRateHz >= 8000 && settings.sampleRateHz <= 384000))
        return failure("the sample rate is not between 8000 and 384000 Hz");
    if (settings.surfaces.empty())
        return failure("the world has no surface");
    for (const auto& surface : settings.surfaces)
        if (const auto valid = validated(surface); !valid)
            return tl::unexpected(valid.error());
    if (settings.eventCapacity < 16 || settings.eventCapacity > 1048576)
        return failure("the number of events is not between 16 and 1048576");
    if (corrected(settings.synthesis, {}) != settings.synthesis)
        return failure("a setting of the synthesis is out of range");
    if (settings.listener && !isFinite(*settings.listener))
        return failure("the listener's place is not finite");
    return std::unique_ptr<World>(new World(std::move(bodies), settings));
}

World::World(std::vector<SynthesiserSlot> slots, const WorldSettings& settings)
    : rateHz(settings.sampleRateHz), listener(settings.listener),
      surfaceCount(settings.surfaces.size()), touches(touchVoices),
      settingsNow(settings.synthesis) {
    std::map<const ModalObject*, std::shared_ptr<const ObjectSurface>> surfaces;
    std::vector<Eigen::Vector3d> middles;
    for (const auto& slot : slots) {
        auto& surface = surfaces[slot.object.get()];
        if (surface == nullptr)
            surface = std::make_shared<ObjectSurface>(*slot.object);
        bodies.push_back({slot.object, surface, slot.sizeRatio, {}});
        middles.push_back(bodies.back().middleMetres());
    }
    mixer = std::make_unique<WorldMixer>(std::move(slots), middles, settings);
}

World::~World() = default;

double World::seconds() const noexcept {
    return static_cast<double>(mixer->clockSamples()) / rateHz;
}

std::int64_t World::impactsLeftOut() const noexcept {
    return mixer->strikesLeftOut();
}

/// Returns the side of a body's object that faces the listener: see
/// StrikePoint::radiationDirection.
std::int32_t World::directionTowardsListener(const Body& body) const {
    if (!listener)
        return -1;
    const auto own =
        floats(body.pose.axes.transpose() * (listener->positionMetres - body.middleMetres()));
    const auto nearest = body.object->radiation.directionTowards(own);
    return nearest ? static_cast<std::int32_t>(*nearest) : -1;
}

template <class Event>
WorldAnswer World::say(const Event& event) {
    return mixer->say(event) ? Answer::done : Answer::busy;
}

WorldAnswer World::place(std::size_t number, const WorldPose& pose) {
    constexpr double tolerance = 1e-3;
    if (number >= bodies.size() || !pose.originMetres.allFinite() ||
        !pose.axes.isUnitary(tolerance))
        return Answer::invalid;
    auto moved = bodies[number];
    moved.pose = pose;
    const auto answer = say(WorldMixer::PlacedBody{number, moved.middleMetres()});
    if (answer == Answer::done)
        bodies[number].pose = pose;
    return answer;
}

WorldAnswer World::placeListener(const Listener& moved) {
    if (!listener || !isFinite(moved))
        return Answer::invalid;
    const auto answer = say(moved);
    if (answer == Answer::done)
        listener = moved;
    return answer;
}

WorldAnswer World::strike(const WorldImpact& impact) {
    if (impact.body >= bodies.size() || !(std::abs(impact.seconds) <= longestSeconds) ||
        !impact.pointMetres.allFinite() || !impact.impulseNewtonSeconds.allFinite() ||
        !(impact.contactSeconds >= 0 && impact.contactSeconds <= 1))
        return Answer::invalid;
    const auto& body = bodies[impact.body];
    const Eigen::Vector3d point = body.own(impact.pointMetres);
    const auto place = impact.vertex ? body.surface->atVertex(*impact.vertex)
                                     : body.surface->nearest({point.x(), point.y(), point.z()});
    if (!place)
        return Answer::invalid;
    Strike strike{.point = *place,
                  .impulseNewtonSeconds =
                      floats(body.pose.axes.transpose() * impact.impulseNewtonSeconds),
                  .durationSeconds = impact.contactSeconds};
    strike.point.radiationDirection = directionTowardsListener(body);
    return say(WorldMixer::TimedStrike{impact.body, impact.seconds, strike});
}

std::optional<std::size_t> World::beginTouch() {
    // The others may still fade.
    for (std::size_t k = 0; k < touches.size(); ++k) {
        const std::size_t number = (nextTouch + k) % touches.size();
        if (touches[number].isInUse)
            continue;
        touches[number] = {.isInUse = true, .pair = ++pairs};
        nextTouch = number + 1;
        return number;
    }
    return std::nullopt;
}

WorldAnswer World::touch(std::size_t number, const WorldTouch& touch) {
    if (number >= touches.size() || !touches[number].isInUse || touch.body >= bodies.size() ||
        touch.surface >= surfaceCount || !touch.pointMetres.allFinite() ||
        !touch.slideMetresPerSecond.allFinite() || !std::isfinite(touch.forceNewtons) ||
        !std::isfinite(touch.rollMetresPerSecond) || (touch.other && *touch.other >= bodies.size()))
        return Answer::invalid;
    TouchState state{.pair = touches[number].pair,
                     .surface = touch.surface,
                     .slots = {touch.body, touch.other.value_or(bodies.size())},
                     .forceNewtons = std::max(touch.forceNewtons, 0.0),
                     .slideMetresPerSecond = touch.slideMetresPerSecond.norm(),
                     .rollMetresPerSecond = std::abs(touch.rollMetresPerSecond)};
    for (std::size_t side = 0; side < (touch.other ? 2 : 1); ++side) {
        const auto& body = bodies[state.slots[side]];
        const Eigen::Vector3d point = body.own(touch.pointMetres);
        const Eigen::Vector3d drag =
            body.pose.axes.transpose() * touch.slideMetresPerSecond * (side == 0 ? 1 : -1);
        state.points[side] =
            pressedAt(body.surface->nearest({point.x(), point.y(), point.z()}), drag);
        state.points[side].point.radiationDirection = directionTowardsListener(body);
    }
    return say(WorldMixer::MovedTouch{number, state});
}

WorldAnswer World::endTouch(std::size_t number) {
    if (number >= touches.size() || !touches[number].isInUse)
        return Answer::invalid;
    const auto answer = say(WorldMixer::EndedTouch{number});
    touches[number].isInUse = answer != Answer::done;
    return answer;
}

WorldAnswer World::setSynthesis(const SynthesisSettings& settings) {
    const auto wanted = corrected(settings, settingsNow);
    if (wanted != settings)
        return Answer::invalid;
    const auto answer = say(wanted);
    if (answer == Answer::done)
        settingsNow = wanted;
    return answer;
}

WorldAnswer World::setMaterial(std::size_t body, const std::optional<LiveMaterial>& material) {
    if (body >= bodies.size() || (material && !valid(*material)))
        return Answer::invalid;
    return say(WorldMixer::BodyMaterial{body, material});
}

WorldAnswer World::setDamping(std::size_t body, double dampingPerSecond) {
    if (body >= bodies.size() || !(dampingPerSecond >= 0) || !std::isfinite(dampingPerSecond))
        return Answer::invalid;
    return say(WorldMixer::BodyDamping{body, dampingPerSecond});
}

WorldAnswer World::setGain(double gain) {
    if (!(gain >= 0 && gain <= 1e6))
        return Answer::invalid;
    return say(WorldMixer::Gain{static_cast<float>(gain)});
}

void World::render(std::span<float> left, std::span<float> right) noexcept {
    mixer->render(left, right);
}

bool World::silent() const noexcept {
    return mixer->silent();
}

std::int64_t World::modesMixed() const noexcept {
    return mixer->modesMixed();
}

} // namespace idiophone
