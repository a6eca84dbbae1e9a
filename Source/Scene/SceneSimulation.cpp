#include "Scene/SceneSimulation.h"

#include "Object/OneLine.h"
#include "Scene/SceneRandom.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace idiophone {
namespace {

constexpr double ringingSeconds = 2;  // a removed body's slot is free after this time
constexpr double lowestMetres = -100; // bodies below are removed
constexpr std::uint32_t firstNote = 1u << 24, firstKick = 1u << 25; // numbers of random sequences

std::vector<RigidWorld::Kind> kindsOf(const SceneAssets& assets) {
    std::vector<RigidWorld::Kind> kinds;
    for (const auto& role : assets.roles())
        kinds.push_back(role.kind);
    return kinds;
}

Eigen::Vector3d radiansPerSecond(const Eigen::Vector3d& turnsPerSecond) {
    return 2 * std::numbers::pi * turnsPerSecond;
}

Eigen::Quaterniond turned(const Eigen::Vector3d& degrees) {
    const double angle = degrees.norm();
    return angle > 0 ? Eigen::Quaterniond(
                           Eigen::AngleAxisd(angle * std::numbers::pi / 180, degrees / angle))
                     : Eigen::Quaterniond::Identity();
}

/// Returns the pose with the centre of mass at `place`; for fixed bodies, with the mesh's origin
/// there.
Eigen::Isometry3d
posed(const RigidBodyModel& model, const Eigen::Vector3d& place, const Eigen::Quaterniond& turn) {
    return Eigen::Translation3d(place) * turn *
           Eigen::Translation3d(-model.meshFromBody.translation());
}

} // namespace

Error crowdedFault(const Scene& scene) {
    return {"the scene " + inQuotes(scene.name) + " has too many bodies in one place: more than " +
            std::to_string(RigidWorld::mostPairs) + " pairs of them, or of their parts, meet"};
}

SceneSimulation::SceneSimulation(std::shared_ptr<const SceneAssets> playedAssets, SceneCall wanted)
    : assets(std::move(playedAssets)), scene(assets->scene()), call(std::move(wanted)),
      seed(call.seed.value_or(scene.seed)),
      rigid(kindsOf(*assets), scene.stepsPerSecond, scene.gravityMetresPerSecond2),
      kicks(scene.kicks), tracker(assets, rigid.stepSeconds()),
      overSeconds(call.seconds.value_or(scene.seconds)) {
    standKeyboard();
    takeHand();
    planReleases();
    planNotes();
    std::ranges::stable_sort(coming, {}, &Coming::seconds);
    std::ranges::stable_sort(kicks, {}, &Kick::seconds);
    if (!coming.empty())
        leadSeconds = std::ceil(std::max(0.0, -coming.front().seconds) / rigid.stepSeconds()) *
                      rigid.stepSeconds();
}

void SceneSimulation::standKeyboard() {
    for (const auto& bar : assets->keyboard()) {
        slotOfBody.push_back(newSlot(bar.role));
        roleOfBody.push_back(bar.role);
        const auto body = rigid.add(bar.role, bar.motion);
        if (slotOfBody.back() != noSlot) {
            slotPlaces[slotOfBody.back()] = rigid.centre(body);
            slotPoses[slotOfBody.back()] = bar.motion.pose;
        }
        ++counted.bodies;
    }
}

std::size_t SceneSimulation::newSlot(std::size_t role) {
    if (!assets->roles()[role].isHeard())
        return noSlot;
    allSlots.push_back(assets->slotOf(role));
    roleOfSlot.push_back(role);
    slotPlaces.push_back(Eigen::Vector3d::Zero());
    slotPoses.emplace_back();
    return allSlots.size() - 1;
}

void SceneSimulation::planReleases() {
    std::uint32_t number = 0;
    for (const auto& release : scene.releases)
        for (int k = 0; k < release.count; ++k, ++number) {
            SceneRandom chance(seed, number);
            const auto& model = *assets->roles()[release.kind].kind.model;
            const double moves = model.isFixed ? 0 : 1;
            const Eigen::Vector3d place = chance.draw(release.positionMetres) +
                                          moves * call.raisedMetres * Eigen::Vector3d::UnitZ();
            const auto turn = release.isTurnedAtRandom ? chance.turn()
                                                       : turned(chance.draw(release.turnedDegrees));
            const double share = release.count > 1 ? k / (release.count - 1.0) : 0;
            coming.push_back(
                {.seconds = release.seconds + share * release.overSeconds,
                 .role = release.kind,
                 .slot = newSlot(release.kind),
                 .motion = {.pose = posed(model, place, turn),
                            .velocity =
                                call.speedRatio * chance.draw(release.velocityMetresPerSecond),
                            .spin = call.speedRatio *
                                    radiansPerSecond(chance.draw(release.spinTurnsPerSecond))},
                 .lastsUntil = std::numeric_limits<double>::infinity()});
        }
}

void SceneSimulation::planNotes() {
    if (!scene.noteDrop)
        return;
    const auto& drop = *scene.noteDrop;
    auto& notes = call.notes;
    std::ranges::stable_sort(notes, {}, &SceneNote::seconds);
    const LowestPoint outer(outerVertices(*assets->roles()[drop.kind].kind.model));
    std::uint32_t number = firstNote;
    const auto first = std::ssize(coming);
    for (const auto& note : notes) {
        if (!assets->target(note.note)) {
            ++counted.notesLeftOut;
            continue;
        }
        double fallSeconds = 0;
        const auto motion = falling(note, number++, outer, fallSeconds);
        const double ends = note.seconds + drop.lifeSeconds;
        coming.push_back({.seconds = note.seconds - fallSeconds,
                          .role = drop.kind,
                          .slot = noSlot,
                          .motion = motion,
                          .lastsUntil = ends});
        overSeconds = std::max(overSeconds, ends);
    }
    const std::span fallen(coming.begin() + first, coming.end());
    std::ranges::stable_sort(fallen, {}, &Coming::seconds);
    shareSlots(fallen);
}

/// Gives each body the first slot that is free when it enters.
void SceneSimulation::shareSlots(std::span<Coming> ofOneRole) {
    using Leaving = std::pair<double, std::size_t>; // time, slot
    std::priority_queue<Leaving, std::vector<Leaving>, std::greater<>> taken;
    std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> free;
    for (auto& one : ofOneRole) {
        for (; !taken.empty() && taken.top().first < one.seconds; taken.pop())
            free.push(taken.top().second);
        if (free.empty())
            free.push(newSlot(one.role));
        one.slot = free.top();
        free.pop();
        taken.emplace(one.lastsUntil + ringingSeconds, one.slot);
    }
}

/// Starts the body at rest in a random orientation. The height makes its lowest point hit the
/// target at a speed that is linear in the note's velocity.
BodyMotion SceneSimulation::falling(const SceneNote& note,
                                    std::uint32_t number,
                                    const LowestPoint& outer,
                                    double& fallSeconds) {
    const auto& drop = *scene.noteDrop;
    const double gravity = std::max(scene.gravityMetresPerSecond2, 1e-3);
    const double slowest = std::sqrt(2 * gravity * drop.softestMetres);
    const double fastest = std::sqrt(2 * gravity * drop.hardestMetres);
    const double speed = slowest + (fastest - slowest) * (note.velocity - 1) / 126.0;
    fallSeconds = speed / gravity;

    SceneRandom chance(seed, number);
    const auto turn = chance.turn();
    auto place = *assets->target(note.note);
    for (int axis = 0; axis < 2; ++axis)
        place(axis) += drop.reachMetres(axis) * chance.spread();
    const auto& model = *assets->roles()[drop.kind].kind.model;
    const auto about = posed(model, Eigen::Vector3d::Zero(), turn);
    const double lowest = std::min(0.0, outer.metres(about)); // relative to its centre of mass
    place.z() += speed * fallSeconds / 2 - lowest;
    return {.pose = posed(model, place, turn)};
}

// A step that begins at t reports impacts since t minus one step.
void SceneSimulation::advanceTo(double seconds) {
    while (!isCrowded() && !isCutShort() &&
           rigid.seconds() - leadSeconds < seconds + rigid.stepSeconds())
        step();
    follow();
}

void SceneSimulation::follow() {
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
            else if (before.pair == now.pair) // the body was removed: it fades where it was
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
    takeAway(now);
    letIn(now);
    kick(now);
    rigid.step();
    for (const auto& impact : rigid.impacts())
        tell(impact);
    tracker.follow(withHand(now, rigid.seconds() - leadSeconds), roleOfBody, slotOfBody);
}

void SceneSimulation::takeHand() {
    if (!scene.hand)
        return;
    hand.emplace(*scene.hand, assets->roles()[scene.hand->kind], assets->roles()[scene.hand->tool]);
    handBody = rigid.addAbsent();
    slotOfBody.push_back(noSlot);
    roleOfBody.push_back(scene.hand->tool);
}

/// Returns the contacts of a step, including the hand's, and reports the hand's taps.
std::span<const Touch> SceneSimulation::withHand(double from, double until) {
    const auto played = std::ranges::find_if(present, [&](const Present& one) {
        return hand && roleOfBody[one.body] == scene.hand->kind;
    });
    if (played == present.end())
        return rigid.touches();
    for (auto impact : hand->tapsBetween(from, until, played->body, handBody)) {
        impact.seconds += leadSeconds; // to the world's time
        tell(impact);
    }
    touchesWithHand.assign(rigid.touches().begin(), rigid.touches().end());
    if (const auto touch = hand->touchAt(until, played->body, handBody))
        touchesWithHand.push_back(*touch);
    return touchesWithHand;
}

/// Adds the bodies that are due. One due between two steps is moved to where it is now. Half a step
/// of gravity ahead makes the fall exact at every step.
void SceneSimulation::letIn(double now) {
    for (; nextComing < coming.size() && coming[nextComing].seconds <= now && !isCrowded();
         ++nextComing) {
        const auto& next = coming[nextComing];
        auto motion = next.motion;
        const double late = now - next.seconds;
        const Eigen::Vector3d gravity(0, 0, -scene.gravityMetresPerSecond2);
        if (!assets->roles()[next.role].kind.model->isFixed) {
            motion.pose.pretranslate(late * motion.velocity + late * late / 2 * gravity);
            motion.velocity += (late - rigid.stepSeconds() / 2) * gravity;
        }
        const auto body = rigid.add(next.role, motion);
        slotOfBody.push_back(next.slot);
        roleOfBody.push_back(next.role);
        present.push_back({.body = body, .lastsUntil = next.lastsUntil});
        ++counted.bodies;
    }
}

void SceneSimulation::kick(double now) {
    for (; nextKick < kicks.size() && kicks[nextKick].seconds <= now; ++nextKick) {
        const auto& kick = kicks[nextKick];
        for (const auto& [body, ignored] : present) {
            if (roleOfBody[body] != kick.kind)
                continue;
            SceneRandom chance(seed, firstKick + static_cast<std::uint32_t>(nextKick << 14 | body));
            const auto velocity = chance.draw(kick.velocityMetresPerSecond);
            rigid.setVelocity(body, call.speedRatio * velocity,
                              call.speedRatio *
                                  radiansPerSecond(chance.draw(kick.spinTurnsPerSecond)));
        }
    }
}

void SceneSimulation::takeAway(double now) {
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

void SceneSimulation::tell(const Impact& impact) {
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
    // One more step, so that bodies due for removal are gone.
    return isCrowded() || isCutShort() ||
           rigid.seconds() - leadSeconds > overSeconds + rigid.stepSeconds();
}

bool SceneSimulation::isCutShort() const {
    return rigid.work() > call.mostWork || (call.isStopped != nullptr && *call.isStopped);
}

} // namespace idiophone
