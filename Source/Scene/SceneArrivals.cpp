#include "Scene/SceneArrivals.h"

#include "Scene/SceneRandom.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <span>
#include <utility>

namespace idiophone {
namespace {

constexpr double ringingSeconds = 2;          // a removed body's slot is free after this time
constexpr std::uint32_t firstNote = 1u << 24; // number of the note's random sequence

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

class Planner {
public:
    Planner(const SceneAssets& playedAssets, const SimulationSetup& wanted)
        : assets(playedAssets), scene(assets.scene()), setup(wanted),
          seed(setup.seed.value_or(scene.seed)) {
        result.lastsUntil = setup.seconds.value_or(scene.seconds);
        for (const auto& bar : assets.keyboard())
            newSlot(bar.role);
        planReleases();
        if (scene.noteDrop)
            planNotes(*scene.noteDrop);
        std::ranges::stable_sort(result.bodies, {}, &SceneArrivals::Arrival::seconds);
    }

    SceneArrivals result;

private:
    const RigidBodyModel& model(std::size_t role) const { return *assets.roles()[role].kind.model; }

    std::size_t newSlot(std::size_t role) {
        if (!assets.roles()[role].isHeard())
            return noSlot;
        result.roleOfSlot.push_back(role);
        return result.roleOfSlot.size() - 1;
    }

    void planReleases();
    void planNotes(const NoteDrop& drop);
    SceneArrivals::Arrival fall(const NoteDrop& drop,
                                const SceneNote& note,
                                std::uint32_t number,
                                const std::vector<Eigen::Vector3d>& outer) const;
    void shareSlots(std::span<SceneArrivals::Arrival> ofOneRole);

    const SceneAssets& assets;
    const Scene& scene;
    const SimulationSetup& setup;
    std::uint32_t seed;
};

void Planner::planReleases() {
    std::uint32_t number = 0;
    for (const auto& release : scene.releases)
        for (int k = 0; k < release.count; ++k, ++number) {
            SceneRandom chance(seed, number);
            const double moves = model(release.kind).isFixed ? 0 : 1;
            const Eigen::Vector3d place = chance.draw(release.positionMetres) +
                                          moves * setup.raisedMetres * Eigen::Vector3d::UnitZ();
            const auto turn = release.isTurnedAtRandom ? chance.turn()
                                                       : turned(chance.draw(release.turnedDegrees));
            const double share = release.count > 1 ? k / (release.count - 1.0) : 0;
            result.bodies.push_back(
                {.seconds = release.seconds + share * release.overSeconds,
                 .role = release.kind,
                 .slot = newSlot(release.kind),
                 .motion = {.pose = posed(model(release.kind), place, turn),
                            .velocity =
                                setup.speedRatio * chance.draw(release.velocityMetresPerSecond),
                            .spin = setup.speedRatio *
                                    radiansPerSecond(chance.draw(release.spinTurnsPerSecond))},
                 .lastsUntil = std::numeric_limits<double>::infinity()});
        }
}

void Planner::planNotes(const NoteDrop& drop) {
    auto notes = setup.notes;
    std::ranges::stable_sort(notes, {}, &SceneNote::seconds);
    const auto outer = outerVertices(model(drop.kind));
    std::uint32_t number = firstNote;
    const auto first = std::ssize(result.bodies);
    for (const auto& note : notes) {
        if (!assets.target(note.note)) {
            ++result.notesLeftOut;
            continue;
        }
        result.bodies.push_back(fall(drop, note, number++, outer));
        result.lastsUntil = std::max(result.lastsUntil, result.bodies.back().lastsUntil);
    }
    const std::span fallen(result.bodies.begin() + first, result.bodies.end());
    std::ranges::stable_sort(fallen, {}, &SceneArrivals::Arrival::seconds);
    shareSlots(fallen);
}

/// Gives each body the first slot that is free when it enters.
void Planner::shareSlots(std::span<SceneArrivals::Arrival> ofOneRole) {
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
SceneArrivals::Arrival Planner::fall(const NoteDrop& drop,
                                     const SceneNote& note,
                                     std::uint32_t number,
                                     const std::vector<Eigen::Vector3d>& outer) const {
    const double gravity = std::max(scene.gravityMetresPerSecond2, 1e-3);
    const double slowest = std::sqrt(2 * gravity * drop.softestMetres);
    const double fastest = std::sqrt(2 * gravity * drop.hardestMetres);
    const double speed = slowest + (fastest - slowest) * (note.velocity - 1) / 126.0;
    const double fallSeconds = speed / gravity;

    SceneRandom chance(seed, number);
    const auto turn = chance.turn();
    auto place = *assets.target(note.note);
    for (int axis = 0; axis < 2; ++axis)
        place(axis) += drop.reachMetres(axis) * chance.spread();
    const auto about = posed(model(drop.kind), Eigen::Vector3d::Zero(), turn);
    double lowest = 0; // relative to the centre of mass
    for (const auto& point : outer)
        lowest = std::min(lowest, (about * point).z());
    place.z() += speed * fallSeconds / 2 - lowest;
    return {.seconds = note.seconds - fallSeconds,
            .role = drop.kind,
            .slot = noSlot,
            .motion = {.pose = posed(model(drop.kind), place, turn)},
            .lastsUntil = note.seconds + drop.lifeSeconds};
}

} // namespace

SceneArrivals arrivalsOf(const SceneAssets& assets, const SimulationSetup& setup) {
    return Planner(assets, setup).result;
}

Eigen::Vector3d radiansPerSecond(const Eigen::Vector3d& turnsPerSecond) {
    return 2 * std::numbers::pi * turnsPerSecond;
}

} // namespace idiophone
