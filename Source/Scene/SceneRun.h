// A performance of a scene: bodies come, are thrown and go as its file and the notes say, and what
// they strike is told for the synthesiser.
#pragma once

#include "Scene/LowestPoint.h"
#include "Scene/RecordedHand.h"
#include "Scene/SceneCast.h"
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

/// Of what has no modes.
inline constexpr std::size_t noSlot = ~std::size_t{0};

/// A blow on one slot, ready to be struck.
struct SceneBlow {
    double seconds = 0;
    std::size_t slot = 0;
    std::size_t role = 0; ///< of what is struck
    Strike strike;
    Eigen::Vector3d pointMetres = Eigen::Vector3d::Zero(); ///< on the object, not scaled
};

/// How a scene is performed, beside what its file says.
struct SceneCall {
    /// In any order; those without a target are left out. What falls for the first ones begins
    /// before 0.
    std::vector<SceneNote> notes = {};
    std::optional<std::uint32_t> seed = {}; ///< instead of the scene's
    std::optional<double> seconds = {};     ///< instead of the scene's
    double raisedMetres = 0;                ///< how much higher what moves begins
    double speedRatio = 1;                  ///< times the speeds at which it begins
    /// As `RigidWorld::work` counts; beyond it nothing moves on.
    double mostWork = std::numeric_limits<double>::infinity();
    /// Set by another thread that waits for its end: nothing moves on.
    const std::atomic<bool>* isStopped = nullptr;
};

/// What is wrong with a scene of which a run is crowded, by its name.
Error crowdedFault(const Scene& scene);

/// One thread at a time; not for the audio thread. The same cast and call give the same bits.
class SceneRun {
public:
    explicit SceneRun(std::shared_ptr<const SceneCast> cast, SceneCall call = {});

    /// What sounds, for the synthesiser to be made of. Bodies that were taken away leave their
    /// slots to others.
    const std::vector<SynthesiserSlot>& slots() const { return allSlots; }
    /// Which of the cast's roles sounds there.
    std::size_t roleOf(std::size_t slot) const { return roleOfSlot[slot]; }
    /// Whether what sounds there never moves.
    bool isFixed(std::size_t slot) const {
        return cast->roles()[roleOfSlot[slot]].kind.model->isFixed;
    }

    /// Steps until everything before a time is known.
    void advanceTo(double seconds);
    /// The next blow before a time, in order of time, or none.
    std::optional<SceneBlow> takeBlow(double beforeSeconds);
    /// What slides and rolls, as of the last step.
    std::span<const TouchState, TouchTracker::voiceCount> touches() const { return heardTouches; }

    /// Where each slot's body is, or was last.
    std::span<const Eigen::Vector3d> places() const { return slotPlaces; }

    /// Where its mesh, scaled, is; nothing while there is no body.
    const std::optional<Eigen::Isometry3d>& pose(std::size_t slot) const { return slotPoses[slot]; }

    /// Nothing more will happen: the scene's time is over and every note has fallen, or it ended
    /// before that.
    bool finished() const;
    /// Whether it ended early, as `RigidWorld::isCrowded`.
    bool isCrowded() const { return rigid.isCrowded(); }
    /// Whether it ended early, as the call has it.
    bool isCutShort() const;

    struct Figures {
        std::int64_t bodies = 0; ///< there now, with those that stand
        std::int64_t impacts = 0;
        std::int64_t notesLeftOut = 0; ///< without a target
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
    std::int32_t
    heardFrom(std::size_t slot, const Eigen::Isometry3d& pose, const Eigen::Vector3d& centre) const;

    std::shared_ptr<const SceneCast> cast;
    const Scene& scene;
    SceneCall call;
    std::uint32_t seed;
    RigidWorld rigid;
    double leadSeconds = 0; ///< of the world's time before 0
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
    std::vector<std::size_t> slotOfBody, roleOfBody; ///< by body
    std::deque<SceneBlow> blows;                     ///< in order of time
    std::vector<Eigen::Vector3d> slotPlaces;
    std::vector<std::optional<Eigen::Isometry3d>> slotPoses;
    TouchTracker tracker;
    std::array<TouchState, TouchTracker::voiceCount> heardTouches; ///< with where they are heard
    std::optional<RecordedHand> hand;
    std::size_t handBody = 0;
    std::vector<Touch> touchesWithHand;
    double overSeconds = 0;
    Figures counted;
};

} // namespace idiophone
