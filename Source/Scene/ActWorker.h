// Moves the bodies of a stage's acts ahead of their sound, on a thread of its own.
#pragma once

#include "Scene/ActChunk.h"
#include "Scene/SceneStage.h"

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace idiophone {

/// Cues go to the worker, chunks come back in the order of each act's time and return when they are
/// used up: three queues without locks, between the audio thread and whoever holds `working`.
/// An act for which memory runs out ends where it is: no exception leaves a thread or the host's.
/// The worker looks for cues every few milliseconds, as the audio thread may not call it.
class ActWorker {
public:
    ActWorker(const SceneStage& stage, double sampleRateHz); ///< the stage outlives it
    ~ActWorker();
    ActWorker(const ActWorker&) = delete;
    ActWorker& operator=(const ActWorker&) = delete;

    /// [audio thread] False, and forgotten, where too many wait.
    bool cue(const ActCue& cue) noexcept { return cues.push(cue); }
    /// [audio thread] The next chunk, or nullptr; it is to come back.
    ActChunk* take() noexcept;
    void giveBack(ActChunk* chunk) noexcept { used.push(chunk); }
    /// [audio thread, offline] Makes a chunk itself, once the worker lets it, with all that this
    /// allocates. False where there was nothing to do.
    bool help() noexcept;

private:
    /// Within so many chunks, a second, the worker runs ahead of the sound.
    static constexpr std::size_t chunksAhead = 96;
    static constexpr std::size_t chunkCapacity = SceneStage::mostActs * chunksAhead;

    struct Act {
        ActCue cue;
        bool begins = false;           ///< its run is still to be made
        std::unique_ptr<SceneRun> run; ///< none while nothing is to be done
        std::int64_t cellsDone = 0;
        std::size_t chunksOut = 0; ///< not yet given back
    };

    void runThread() noexcept;
    bool workOnce() noexcept;
    void takeUsed();
    void takeCues();
    bool hasFreeChunk() noexcept;
    void begin(Act& act) const;
    void fill(ActChunk& chunk, Act& act, const SceneStage::SlotMap& slots) const;

    const SceneStage& stage;
    double cellSeconds;

    template <class Message, std::size_t room>
    using Queue = boost::lockfree::spsc_queue<Message, boost::lockfree::capacity<room>>;
    Queue<ActCue, 256> cues;
    Queue<ActChunk*, chunkCapacity> ready, used;

    std::mutex working; ///< whoever holds it is the worker
    std::condition_variable stopped;
    std::atomic<bool> isStopping{false};
    std::vector<Act> acts;
    std::vector<std::unique_ptr<ActChunk>> allChunks;
    std::vector<ActChunk*> freeChunks;
    std::thread thread; ///< the last member: it uses the others
};

} // namespace idiophone
