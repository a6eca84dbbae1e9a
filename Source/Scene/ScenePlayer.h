// Plays a scene instrument on the audio thread: impacts and contacts at their samples, and the
// listener.
#pragma once

#include "Instrument/Stage.h"
#include "Scene/SceneStage.h"
#include "Scene/SimulationThread.h"
#include "World/HeardBodies.h"

#include <array>
#include <cstdint>
#include <vector>

namespace idiophone {

class ScenePlayer final : public StagePlayer {
public:
    /// `stage` must outlive it.
    ScenePlayer(const SceneStage& stage, double sampleRateHz, std::uint64_t seed);

    void
    startNote(int midiNote, int velocity, std::int64_t cell, double sampleInCell) noexcept override;
    void countNotesFrom(std::uint32_t number) noexcept override { noteCount = number; }
    bool simulateAhead() noexcept override;
    void sound(std::int64_t cell,
               Synthesiser& synthesiser,
               std::span<const CellOutput> cellsOfSlots) noexcept override;
    void release(Synthesiser& synthesiser,
                 std::span<const CellOutput> cellsOfSlots) noexcept override;
    void hear(std::span<const CellOutput> cellsOfSlots, const CellOutput& heard) noexcept override;
    void setOffline(bool isOffline) noexcept override { mayWait = isOffline; }
    void pause(bool isPaused) noexcept override { paused = isPaused; }
    void clear() noexcept override;
    void reset() noexcept override;
    bool silent() const noexcept override;
    std::int64_t lateEvents() const noexcept override { return lateCount; }
    std::span<const PlacedImpact> takeImpacts() noexcept override;
    std::uint32_t number() const noexcept override { return ownNumber; }
    std::span<const BodyPose> bodyPoses() const noexcept override { return poses; }

private:
    static constexpr std::size_t impactCapacity = 1024; // between two calls of takeImpacts

    /// A note's simulation while it sounds.
    struct Simulation {
        std::uint32_t number = 0; ///< of its note; 0: idle
        std::int64_t startCell = 0;
        double startSample = 0;                            ///< start of the note within that cell
        SimulationBlock *first = nullptr, *last = nullptr; ///< received, and not played completely
        std::size_t impactsDone = 0;                       ///< of the first block
        std::int64_t contactCells = 0; ///< contacts of earlier cells are played or late
        std::int64_t knownCells = 0;
        bool isAllKnown = false;
        bool isPlaced = false;
    };

    void clear(Simulation& simulation) noexcept;
    void drop(Simulation& simulation) noexcept;
    void takeBlocks() noexcept;
    void waitFor(std::int64_t cell) noexcept;
    void releaseOthers(const BegunCell& cell) noexcept;
    void play(Simulation& simulation, const BegunCell& cell) noexcept;
    void strike(const SceneImpact& impact, double sample, const BegunCell& cell) noexcept;
    void press(const TouchState& state, const BegunCell& cell) noexcept;
    void place(Simulation& simulation, std::int64_t cellsLeft) noexcept;

    const SceneStage& stage;
    double rate;
    std::uint32_t firstSeed;
    SimulationThread worker;
    std::vector<Simulation> simulations;
    std::size_t nextSimulation = 0;
    std::uint32_t noteCount = 0;
    std::uint32_t notesEver = 0; ///< identifies blocks from before a reset
    HeardBodies bodies;
    std::array<std::uint32_t, touchVoices> pairOfVoice{}; ///< 0: not in use
    std::array<bool, touchVoices> isPressed{};            ///< in this cell
    std::vector<Eigen::Vector3d> places;                  ///< by slot
    std::vector<BodyPose> poses;                          ///< by slot
    std::vector<PlacedImpact> recentImpacts;
    bool areImpactsTaken = false;
    std::uint32_t ownNumber;
    std::int64_t lateCount = 0;
    bool paused = false;
    bool mayWait = false;
};

} // namespace idiophone
