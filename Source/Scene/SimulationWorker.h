// Does the work of a simulation beside the audio thread.
#pragma once

#include <functional>
#include <memory>

namespace idiophone {

/// Does one piece of work after the other on a thread of its own, and sleeps while there is nothing
/// to do. In WebAssembly it has no thread (WorkerWithoutThread.cpp): its owner calls `doPiece`
/// between two blocks.
class SimulationWorker {
public:
    /// Does one piece. Returns false if there is nothing to do. Does not throw.
    using Work = std::function<bool()>;

    explicit SimulationWorker(Work work);
    /// Waits for the current piece.
    ~SimulationWorker();
    SimulationWorker(const SimulationWorker&) = delete;
    SimulationWorker& operator=(const SimulationWorker&) = delete;

    /// [audio thread] Takes no lock. Makes a system call only if the worker sleeps.
    void wake() noexcept;
    /// Does one piece on the calling thread, after the worker's current one. Returns false if there
    /// is nothing to do.
    bool doPiece() noexcept;

private:
    struct Thread;
    std::unique_ptr<Thread> thread;
};

} // namespace idiophone
