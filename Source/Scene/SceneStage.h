// A scene as an instrument: every note performs it anew, with chances of its own.
#pragma once

#include "Instrument/Instrument.h"
#include "Scene/SceneCast.h"
#include "Scene/SceneRun.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace idiophone {

/// As `Instrument::build`, and key maps of kind `scene` too: of a factory scene's name or a scene
/// file. Not for the audio thread. The error names what is at fault.
Result<std::shared_ptr<const Instrument>> buildInstrument(const KeyMap& keyMap,
                                                          ObjectLibrary& library);

/// What is seen of a slot's body.
BodyPose bodyPose(const SceneRun& run, std::size_t slot);

/// Several notes sound at a time, each in a world of its own (an act): what stands is the same in
/// all of them and has one slot, what moves has one in each. With `notes` the body of a key is
/// dropped so that it hits when the longest fall has gone by, whatever its own: so a chord stays
/// together. Without them everything that moves begins anew.
class SceneStage final : public Stage {
public:
    static constexpr std::size_t mostActs = 8;

    /// Where the slots of one act's run are among the synthesiser's.
    using SlotMap = std::vector<std::size_t>;

    /// More than these no machine moves while they sound.
    static constexpr std::size_t mostBodies = 500;

    /// Refuses more bodies than `mostBodies`, those that are crowded (RigidWorld::isCrowded), and
    /// what takes too long to begin; the error names the scene.
    static Result<std::shared_ptr<const SceneStage>> make(std::shared_ptr<const SceneCast> cast);

    std::unique_ptr<StagePerformance> perform(double sampleRateHz,
                                              std::uint64_t seed) const override;
    const std::string& objectOf(std::size_t slot) const override {
        return played->roles()[allRoles[slot]].object;
    }
    std::span<const BodyPose> firstPoses() const override { return posesAtFirst; }
    double delaySeconds() const override { return delay; }
    double lengthSeconds() const override;

    const std::shared_ptr<const SceneCast>& cast() const { return played; }
    const std::vector<SynthesiserSlot>& slots() const { return allSlots; }
    /// Where the bodies of the slots are before anything moves.
    const std::vector<Eigen::Vector3d>& places() const { return firstPlaces; }
    std::size_t actCount() const { return slotsOfActs.size(); }
    const SlotMap& slotsOfAct(std::size_t act) const { return slotsOfActs[act]; }
    /// What a note is shown by, −1 where it does nothing.
    std::array<int, 128> slotOfKey(int lowestNote, int highestNote) const;

    /// What a note does.
    SceneCall callFor(int midiNote, int velocity, std::uint32_t seed) const;

private:
    explicit SceneStage(std::shared_ptr<const SceneCast> cast) : played(std::move(cast)) {}

    Result<void> setUp();
    /// The note at middle velocity, for a few seconds' work.
    SceneCall rehearsalCall(int midiNote) const;
    /// Of a rehearsal at middle velocity; 0 where nothing is struck soon, or where it takes more
    /// work than is worth it.
    Result<double> firstBlowSeconds() const;

    std::shared_ptr<const SceneCast> played;
    double delay = 0;
    std::vector<SynthesiserSlot> allSlots;
    std::vector<std::size_t> allRoles; ///< of the slots
    std::vector<Eigen::Vector3d> firstPlaces;
    std::vector<BodyPose> posesAtFirst;
    std::vector<SlotMap> slotsOfActs;
    std::optional<int> firstMovingSlot;
};

} // namespace idiophone
