// Runs the simulation of a scene. It adds, throws and removes bodies as the file and the notes say.
// It reports their impacts and contacts for the synthesiser.
#pragma once

#include "Scene/RecordedHand.h"
#include "Scene/SceneArrivals.h"
#include "Scene/TouchTracker.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// An impact on one slot, ready for the synthesiser.
struct SceneImpact {
    double seconds = 0;
    std::size_t slot = 0;
    std::size_t role = 0; ///< of the struck body
    Strike strike;
    Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero(); ///< on the object, not scaled
};

/// Returns the error for a scene whose simulation is crowded.
Error crowdedFault(const Scene& scene);

/// One thread at a time; not for the audio thread. The same scene assets and setup give the same
/// bits.
class SceneSimulation {
public:
    explicit SceneSimulation(std::shared_ptr<const SceneAssets> assets, SimulationSetup setup = {});

    /// Returns the slots from which the synthesiser is made. Slots of removed bodies are reused.
    const std::vector<SynthesiserSlot>& slots() const { return allSlots; }
    /// Returns the index of the slot's role in the scene assets.
    std::size_t roleOf(std::size_t slot) const { return arrivals.roleOfSlot[slot]; }
    bool isFixed(std::size_t slot) const {
        return assets->roles()[roleOf(slot)].kind.model->isFixed;
    }

    /// Steps until everything before `seconds` is known.
    void advanceTo(double seconds);
    /// Removes and returns the next impact before a time, in order of time.
    std::optional<SceneImpact> takeImpact(double beforeSeconds);
    /// Returns the contacts at the last step.
    std::span<const TouchState, touchVoices> touches() const { return heardTouches; }

    /// Returns the current or last place of each slot's body.
    std::span<const Eigen::Vector3d> places() const { return slotPlaces; }

    /// Returns the pose of the slot's scaled mesh, or nothing while the slot has no body.
    const std::optional<Eigen::Isometry3d>& pose(std::size_t slot) const { return slotPoses[slot]; }

    /// Returns true if nothing more will happen: the scene and all notes are over, or it ended
    /// early.
    bool finished() const;
    /// Returns whether the simulation ended early because the world is crowded
    /// (`RigidWorld::isCrowded`).
    bool isCrowded() const { return rigid.isCrowded(); }
    /// Returns whether the simulation ended early because of the setup's `maximumWork` or
    /// `isStopped`.
    bool isCutShort() const;

    struct Figures {
        std::int64_t bodies = 0; ///< present now, including fixed ones
        std::int64_t impacts = 0;
    };
    const Figures& figures() const { return counted; }
    std::int64_t notesLeftOut() const { return arrivals.notesLeftOut; } ///< without a target

private:
    std::size_t addBody(std::size_t role, std::size_t slot, const BodyMotion& motion);
    void step();
    std::span<const Touch> withHand(double from, double until);
    void addDueBodies(double now);
    void kick(double now);
    void removeDueBodies(double now);
    void addImpact(const Impact& impact);
    void placeSlots();
    std::int32_t radiationDirection(std::size_t slot,
                                    const Eigen::Isometry3d& pose,
                                    const Eigen::Vector3d& centre) const;

    std::shared_ptr<const SceneAssets> assets;
    const Scene& scene;
    SimulationSetup setup;
    RigidWorld rigid;
    SceneArrivals arrivals;
    std::size_t nextArrival = 0;
    double leadSeconds = 0; ///< how long the world starts before time 0
    std::vector<SynthesiserSlot> allSlots;
    std::vector<Kick> kicks; ///< in order of time
    std::size_t nextKick = 0;
    struct Present {
        std::size_t body;
        double lastsUntil;
    };
    std::vector<Present> present;
    std::vector<std::size_t> slotOfBody, roleOfBody; ///< index: body
    std::deque<SceneImpact> impacts;                 ///< in order of time
    std::vector<Eigen::Vector3d> slotPlaces;
    std::vector<std::optional<Eigen::Isometry3d>> slotPoses;
    TouchTracker tracker;
    std::array<TouchState, touchVoices> heardTouches; ///< with `radiationDirection`
    std::optional<RecordedHand> hand;
    std::size_t handBody = 0;
    std::vector<Touch> touchesWithHand;
    Figures counted;
};

} // namespace idiophone
