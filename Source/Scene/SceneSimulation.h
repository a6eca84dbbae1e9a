// Runs the simulation of a scene. It adds, throws and removes bodies as the file and the notes say.
// It reports their impacts and contacts for the synthesiser.
#pragma once

#include "Scene/LowestPoint.h"
#include "Scene/RecordedHand.h"
#include "Scene/SceneAssets.h"
#include "Scene/TouchTracker.h"

#include <atomic>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

struct SceneNote {
    double seconds = 0; ///< ≥ 0
    int note = 0;       ///< MIDI, 0 to 127
    int velocity = 0;   ///< 1 to 127
};

/// The slot of bodies without modes.
inline constexpr std::size_t noSlot = ~std::size_t{0};

/// An impact on one slot, ready for the synthesiser.
struct SceneImpact {
    double seconds = 0;
    std::size_t slot = 0;
    std::size_t role = 0; ///< of the struck body
    Strike strike;
    Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero(); ///< on the object, not scaled
};

/// How to perform a scene, beyond its file.
struct SceneCall {
    /// In any order. Notes without a target are ignored. The bodies of the first notes may start to
    /// fall before time 0.
    std::vector<SceneNote> notes = {};
    std::optional<std::uint32_t> seed = {}; ///< replaces the scene's seed
    std::optional<double> seconds = {};     ///< replaces the scene's duration
    double raisedMetres = 0;                ///< added to the initial height of moving bodies
    double speedRatio = 1;                  ///< factor of initial speeds
    /// In the units of `RigidWorld::work`. The simulation stops when it has done this much.
    double mostWork = std::numeric_limits<double>::infinity();
    /// Set by another thread to stop the simulation. May be null.
    const std::atomic<bool>* isStopped = nullptr;
};

/// Returns the error for a scene whose run is crowded.
Error crowdedFault(const Scene& scene);

/// One thread at a time; not for the audio thread. The same scene assets and call give the same
/// bits.
class SceneSimulation {
public:
    explicit SceneSimulation(std::shared_ptr<const SceneAssets> assets, SceneCall call = {});

    /// Returns the slots from which the synthesiser is made. Slots of removed bodies are reused.
    const std::vector<SynthesiserSlot>& slots() const { return allSlots; }
    /// Returns the index of the slot's role in the scene assets.
    std::size_t roleOf(std::size_t slot) const { return roleOfSlot[slot]; }
    bool isFixed(std::size_t slot) const {
        return assets->roles()[roleOfSlot[slot]].kind.model->isFixed;
    }

    /// Steps until everything before `seconds` is known.
    void advanceTo(double seconds);
    /// Removes and returns the next impact before a time, in order of time.
    std::optional<SceneImpact> takeImpact(double beforeSeconds);
    /// Returns the contacts at the last step.
    std::span<const TouchState, TouchTracker::voiceCount> touches() const { return heardTouches; }

    /// Returns the current or last place of each slot's body.
    std::span<const Eigen::Vector3d> places() const { return slotPlaces; }

    /// Returns the pose of the slot's scaled mesh, or nothing while the slot has no body.
    const std::optional<Eigen::Isometry3d>& pose(std::size_t slot) const { return slotPoses[slot]; }

    /// Returns true if nothing more will happen: the scene and all notes are over, or it ended
    /// early.
    bool finished() const;
    /// Returns whether it ended early because the world is crowded (`RigidWorld::isCrowded`).
    bool isCrowded() const { return rigid.isCrowded(); }
    /// Returns whether it ended early because of the call's `mostWork` or `isStopped`.
    bool isCutShort() const;

    struct Figures {
        std::int64_t bodies = 0; ///< present now, with fixed ones
        std::int64_t impacts = 0;
        std::int64_t notesLeftOut = 0; ///< notes without a target
    };
    const Figures& figures() const { return counted; }

private:
    struct Coming {
        double seconds = 0;
        std::size_t role = 0;
        std::size_t slot = 0;
        BodyMotion motion; ///< at that time
        double lastsUntil = 0;
    };

    void standKeyboard();
    std::size_t newSlot(std::size_t role);
    void planReleases();
    void planNotes();
    BodyMotion falling(const SceneNote& note,
                       std::uint32_t number,
                       const LowestPoint& outer,
                       double& fallSeconds);
    void shareSlots(std::span<Coming> ofOneRole);
    void step();
    void takeHand();
    std::span<const Touch> withHand(double from, double until);
    void letIn(double now);
    void kick(double now);
    void takeAway(double now);
    void tell(const Impact& impact);
    void follow();
    std::int32_t radiationDirection(std::size_t slot,
                                    const Eigen::Isometry3d& pose,
                                    const Eigen::Vector3d& centre) const;

    std::shared_ptr<const SceneAssets> assets;
    const Scene& scene;
    SceneCall call;
    std::uint32_t seed;
    RigidWorld rigid;
    double leadSeconds = 0; ///< how long the world starts before time 0
    std::vector<SynthesiserSlot> allSlots;
    std::vector<std::size_t> roleOfSlot;
    std::vector<Coming> coming; ///< in order of time
    std::size_t nextComing = 0;
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
    std::array<TouchState, TouchTracker::voiceCount> heardTouches; ///< with `radiationDirection`
    std::optional<RecordedHand> hand;
    std::size_t handBody = 0;
    std::vector<Touch> touchesWithHand;
    double overSeconds = 0;
    Figures counted;
};

} // namespace idiophone
