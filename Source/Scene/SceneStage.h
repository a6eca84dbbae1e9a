// A scene as an instrument: every note starts a new simulation with random numbers of its own.
#pragma once

#include "Instrument/Instrument.h"
#include "Scene/SceneAssets.h"
#include "Scene/SceneSimulation.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace idiophone {

/// Builds as `Instrument::build` does, and also key maps of kind `scene` (a factory scene's name or
/// a scene file). Not for the audio thread. The error names the part at fault.
Result<std::shared_ptr<const Instrument>> buildInstrument(const KeyMap& keyMap,
                                                          ObjectSource& objects);

/// Returns the pose of a slot's body for the window.
BodyPose bodyPose(const SceneSimulation& run, std::size_t slot);

/// Several notes sound at a time, each in a simulation of its own. A fixed body has one slot in all
/// of them; a moving body has one slot in each. If the scene has `notes`, every body hits after the
/// same delay, the longest fall, so that a chord stays together. Otherwise a note restarts all
/// moving bodies.
class SceneStage final : public Stage {
public:
    static constexpr std::size_t maximumSimulations = 8;

    /// Maps the slots of one simulation to those of the synthesiser.
    using SlotMap = std::vector<std::size_t>;

    /// The maximum number of bodies. No machine simulates more of them in real time.
    static constexpr std::size_t maximumBodies = 500;

    /// Refuses more than `maximumBodies` bodies, a crowded scene (RigidWorld::isCrowded) and one
    /// that takes too long to begin. The error names the scene.
    static Result<std::shared_ptr<const SceneStage>>
    make(std::shared_ptr<const SceneAssets> assets);

    std::unique_ptr<StagePlayer> makePlayer(double sampleRateHz, std::uint64_t seed) const override;
    const std::string& objectOf(std::size_t slot) const override {
        return played->roles()[allRoles[slot]].object;
    }
    std::span<const BodyPose> firstPoses() const override { return posesAtFirst; }
    double delaySeconds() const override { return delay; }
    double lengthSeconds() const override;

    const std::shared_ptr<const SceneAssets>& assets() const { return played; }
    const std::vector<SynthesiserSlot>& slots() const { return allSlots; }
    /// Returns the initial place of each slot's body.
    const std::vector<Eigen::Vector3d>& places() const { return firstPlaces; }
    std::size_t simulationCount() const { return slotsOfSimulations.size(); }
    const SlotMap& slotsOfSimulation(std::size_t simulation) const {
        return slotsOfSimulations[simulation];
    }
    /// Returns the slot that shows each note in the window, −1 for notes without effect.
    std::array<int, 128> slotOfKey(int lowestNote, int highestNote) const;

    /// Returns the setup of the simulation of a note.
    SimulationSetup setupFor(int midiNote, int velocity, std::uint32_t seed) const;

private:
    explicit SceneStage(std::shared_ptr<const SceneAssets> assets) : played(std::move(assets)) {}

    Result<void> setUp();
    /// Returns the setup of the note at middle velocity, limited to a few seconds of work.
    SimulationSetup trialSetup(int midiNote) const;
    /// Simulates a note at middle velocity. Returns 0 if nothing is struck soon or within the work
    /// limit.
    Result<double> firstImpactSeconds() const;

    std::shared_ptr<const SceneAssets> played;
    double delay = 0;
    std::vector<SynthesiserSlot> allSlots;
    std::vector<std::size_t> allRoles; ///< by slot
    std::vector<Eigen::Vector3d> firstPlaces;
    std::vector<BodyPose> posesAtFirst;
    std::vector<SlotMap> slotsOfSimulations;
    std::optional<int> firstMovingSlot;
};

} // namespace idiophone
