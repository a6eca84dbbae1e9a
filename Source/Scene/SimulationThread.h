// Simulates the bodies of a scene instrument ahead of their sound, on a thread of its own if there
// are threads.
#pragma once

#include "Scene/SceneStage.h"
#include "Scene/SimulationBlock.h"
#include "Scene/SimulationWorker.h"

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <memory>
#include <vector>

namespace idiophone {

/// Three lock-free queues connect the audio thread and the worker. They carry notes, filled blocks
/// and used blocks. The filled blocks of a simulation are in order of time. If memory runs out, a
/// simulation ends early: no exception leaves the thread. The audio thread wakes the worker for a
/// note, and for every few used blocks.
class SimulationThread {
public:
    SimulationThread(const SceneStage& stage,
                     double sampleRateHz); ///< `stage` must outlive the worker
    ~SimulationThread();
    SimulationThread(const SimulationThread&) = delete;
    SimulationThread& operator=(const SimulationThread&) = delete;

    /// [audio thread] Sends a note. Returns false and drops it if the queue is full.
    bool start(const SimulationNote& note) noexcept;
    /// [audio thread] Returns the next block or nullptr. The caller gives it back.
    SimulationBlock* take() noexcept;
    void giveBack(SimulationBlock* block) noexcept;
    /// [audio thread, offline; or between two blocks of it] Fills one block on the calling thread,
    /// after the worker's current one. Allocates. Returns false if there is nothing to do.
    bool help() noexcept;

private:
    /// The worker runs at most this many blocks ahead of the sound, about a second.
    static constexpr std::size_t blocksAhead = 96;
    static constexpr std::size_t blockCapacity = SceneStage::maximumSimulations * blocksAhead;

    struct Simulation {
        SimulationNote note;
        bool begins = false;                  ///< its simulation has not been created yet
        std::unique_ptr<SceneSimulation> run; ///< null while the simulation is idle
        std::int64_t cellsDone = 0;
        std::size_t blocksOut = 0; ///< blocks that have not been given back
    };

    /// The audio thread wakes the worker once for so many used blocks. The worker still has most of
    /// its lead by then.
    static constexpr std::uint32_t blocksPerWake = 16;

    bool workOnce() noexcept;
    void takeUsed();
    void takeNotes();
    void begin(Simulation& simulation) const;
    void
    fill(SimulationBlock& block, Simulation& simulation, const SceneStage::SlotMap& slots) const;

    const SceneStage& stage;
    double cellSeconds;

    template <class Message, std::size_t room>
    using Queue = boost::lockfree::spsc_queue<Message, boost::lockfree::capacity<room>>;
    Queue<SimulationNote, 256> notes;
    Queue<SimulationBlock*, blockCapacity> ready, used;

    std::atomic<bool> isStopping{false};
    std::uint32_t blocksReturned = 0; ///< [audio thread]
    std::vector<Simulation> simulations;
    std::vector<SimulationBlock> blocks; ///< `blocksAhead` for each simulation
    std::vector<SimulationBlock*> freeBlocks;
    SimulationWorker worker; ///< started last, because it uses the others
};

} // namespace idiophone
