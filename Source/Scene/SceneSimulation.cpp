#include "Scene/SceneSimulation.h"

#include "Object/OneLine.h"
#include "Scene/SceneRandom.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

constexpr double lowestMetres = -100;         // bodies below are removed
constexpr std::uint32_t firstKick = 1u << 25; // number of the throw's random sequence

std::vector<RigidWorld::Kind> kindsOf(const SceneAssets& assets) {
    std::vector<RigidWorld::Kind> kinds;
    for (const auto& role : assets.roles())
        kinds.push_back(role.kind);
    return kinds;
}

} // namespace

Error crowdedFault(const Scene& scene) {
    return {"the scene " + inQuotes(scene.name) + " has too many bodies in one place: more than " +
            std::to_string(RigidWorld::maximumPairs) + " pairs of them, or of their parts, meet"};
}

SceneSimulation::SceneSimulation(std::shared_ptr<const SceneAssets> playedAssets,
                                 SimulationSetup wanted)
    : assets(std::move(playedAssets)), scene(assets->scene()), setup(std::move(wanted)),
      rigid(kindsOf(*assets), scene.stepsPerSecond, scene.gravityMetresPerSecond2, setup.team),
      arrivals(arrivalsOf(*assets, setup)), kicks(scene.kicks),
      slotPlaces(arrivals.roleOfSlot.size(), Eigen::Vector3d::Zero()),
      slotPoses(arrivals.roleOfSlot.size()), tracker(assets, rigid.stepSeconds()) {
    for (const auto role : arrivals.roleOfSlot)
        allSlots.push_back(assets->slotOf(role));
    for (const auto& bar : assets->keyboard()) {
        const auto slot = slotOfBody.size(); // the bars have the first slots
        slotPlaces[slot] = rigid.centre(addBody(bar.role, slot, bar.motion));
        slotPoses[slot] = bar.motion.pose;
    }
    if (scene.hand) {
        hand.emplace(*scene.hand, assets->roles()[scene.hand->kind],
                     assets->roles()[scene.hand->tool]);
        handBody = rigid.addAbsent();
        slotOfBody.push_back(noSlot);
        roleOfBody.push_back(scene.hand->tool);
    }
    std::ranges::stable_sort(kicks, {}, &Kick::seconds);
    if (!arrivals.bodies.empty())
        leadSeconds =
            std::ceil(std::max(0.0, -arrivals.bodies.front().seconds) / rigid.stepSeconds()) *
            rigid.stepSeconds();
}

std::size_t SceneSimulation::addBody(std::size_t role, std::size_t slot, const BodyMotion& motion) {
    slotOfBody.push_back(slot);
    roleOfBody.push_back(role);
    ++counted.bodies;
    return rigid.add(role, motion);
}

// A step that begins at t reports impacts since t minus one step.
void SceneSimulation::advanceTo(double seconds) {
    while (!isCrowded() && !isCutShort() &&
           rigid.seconds() - leadSeconds < seconds + rigid.stepSeconds())
        step();
    placeSlots();
}

void SceneSimulation::placeSlots() {
    for (const auto& one : present)
        if (const auto slot = slotOfBody[one.body]; slot != noSlot) {
            slotPlaces[slot] = rigid.centre(one.body);
            slotPoses[slot] = rigid.motion(one.body).pose;
        }
    for (std::size_t k = 0; k < heardTouches.size(); ++k) {
        const auto before = std::exchange(heardTouches[k], tracker.states()[k]);
        auto& now = heardTouches[k];
        for (std::size_t side = 0; side < now.slots.size() && now.pair != 0; ++side) {
            auto& from = now.points[side].point.radiationDirection;
            const auto slot = now.slots[side];
            if (slot != noSlot && slotPoses[slot])
                from = radiationDirection(slot, *slotPoses[slot], slotPlaces[slot]);
            else if (before.pair == now.pair) // the body was removed: it fades at its last place
                from = before.points[side].point.radiationDirection;
        }
    }
}

/// Returns the side of a slot's object that faces the listener: see
/// StrikePoint::radiationDirection.
std::int32_t SceneSimulation::radiationDirection(std::size_t slot,
                                                 const Eigen::Isometry3d& pose,
                                                 const Eigen::Vector3d& centre) const {
    const Eigen::Vector3f own =
        (pose.linear().transpose() * (scene.listener.positionMetres - centre)).cast<float>();
    const auto nearest =
        allSlots[slot].object->radiation.directionTowards({own.x(), own.y(), own.z()});
    return nearest ? static_cast<std::int32_t>(*nearest) : -1;
}

void SceneSimulation::step() {
    const double now = rigid.seconds() - leadSeconds;
    removeDueBodies(now);
    addDueBodies(now);
    kick(now);
    rigid.step();
    for (const auto& impact : rigid.impacts())
        addImpact(impact);
    tracker.follow(withHand(now, rigid.seconds() - leadSeconds), roleOfBody, slotOfBody);
}

/// Returns the contacts of a step, including the hand's, and reports the hand's taps.
std::span<const Touch> SceneSimulation::withHand(double from, double until) {
    const auto played = std::ranges::find_if(present, [&](const Present& one) {
        return hand && roleOfBody[one.body] == scene.hand->kind;
    });
    if (played == present.end())
        return rigid.touches();
    for (auto impact : hand->tapsBetween(from, until, played->body, handBody)) {
        impact.seconds += leadSeconds; // converts to the world's time
        addImpact(impact);
    }
    touchesWithHand.assign(rigid.touches().begin(), rigid.touches().end());
    if (const auto touch = hand->touchAt(until, played->body, handBody))
        touchesWithHand.push_back(*touch);
    return touchesWithHand;
}

/// Adds the bodies that are due. Moves a body that was due between two steps to its current place.
/// Half a step of gravity in advance makes the fall exact at every step.
void SceneSimulation::addDueBodies(double now) {
    for (; nextArrival < arrivals.bodies.size() && arrivals.bodies[nextArrival].seconds <= now &&
           !isCrowded();
         ++nextArrival) {
        const auto& next = arrivals.bodies[nextArrival];
        auto motion = next.motion;
        const double late = now - next.seconds;
        const Eigen::Vector3d gravity(0, 0, -scene.gravityMetresPerSecond2);
        if (!assets->roles()[next.role].kind.model->isFixed) {
            motion.pose.pretranslate(late * motion.velocity + late * late / 2 * gravity);
            motion.velocity += (late - rigid.stepSeconds() / 2) * gravity;
        }
        present.push_back(
            {.body = addBody(next.role, next.slot, motion), .lastsUntil = next.lastsUntil});
    }
}

void SceneSimulation::kick(double now) {
    for (; nextKick < kicks.size() && kicks[nextKick].seconds <= now; ++nextKick) {
        const auto& kick = kicks[nextKick];
        for (const auto& [body, ignored] : present) {
            if (roleOfBody[body] != kick.kind)
                continue;
            SceneRandom chance(setup.seed.value_or(scene.seed),
                               firstKick + static_cast<std::uint32_t>(nextKick << 14 | body));
            const auto velocity = chance.draw(kick.velocityMetresPerSecond);
            rigid.setVelocity(body, setup.speedRatio * velocity,
                              setup.speedRatio *
                                  radiansPerSecond(chance.draw(kick.spinTurnsPerSecond)));
        }
    }
}

void SceneSimulation::removeDueBodies(double now) {
    std::erase_if(present, [&](const Present& one) {
        const bool stays = now < one.lastsUntil && rigid.centre(one.body).z() > lowestMetres;
        if (!stays) {
            if (slotOfBody[one.body] != noSlot)
                slotPoses[slotOfBody[one.body]].reset();
            rigid.remove(one.body);
            --counted.bodies;
        }
        return !stays;
    });
}

void SceneSimulation::addImpact(const Impact& impact) {
    ++counted.impacts;
    if (slotOfBody[impact.body] == noSlot)
        return;
    const auto& role = assets->roles()[roleOfBody[impact.body]];
    const Eigen::Vector3d own = impact.pointMetres / role.kind.model->sizeRatio;
    SceneImpact sceneImpact{.seconds = impact.seconds - leadSeconds,
                            .slot = slotOfBody[impact.body],
                            .role = roleOfBody[impact.body],
                            .strike = {.point = role.surface->nearest({own.x(), own.y(), own.z()}),
                                       .durationSeconds = impact.contactSeconds},
                            .pointMetres = own};
    sceneImpact.strike.point.radiationDirection = radiationDirection(
        sceneImpact.slot, rigid.motion(impact.body).pose, rigid.centre(impact.body));
    for (int axis = 0; axis < 3; ++axis)
        sceneImpact.strike.impulseNewtonSeconds[static_cast<std::size_t>(axis)] =
            static_cast<float>(impact.impulseNewtonSeconds(axis));
    const auto after =
        std::ranges::upper_bound(impacts, sceneImpact.seconds, {}, &SceneImpact::seconds);
    impacts.insert(after, sceneImpact);
}

std::optional<SceneImpact> SceneSimulation::takeImpact(double beforeSeconds) {
    if (impacts.empty() || !(impacts.front().seconds < beforeSeconds))
        return std::nullopt;
    const auto sceneImpact = impacts.front();
    impacts.pop_front();
    return sceneImpact;
}

bool SceneSimulation::finished() const {
    // Make one more step, so that bodies due for removal are removed.
    return isCrowded() || isCutShort() ||
           rigid.seconds() - leadSeconds > arrivals.lastsUntil + rigid.stepSeconds();
}

bool SceneSimulation::isCutShort() const {
    return rigid.work() > setup.maximumWork || (setup.isStopped != nullptr && *setup.isStopped);
}

} // namespace idiophone
