#include "Scene/SimulationWorker.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>

namespace idiophone {

struct SimulationWorker::Thread {
    explicit Thread(Work wanted) : work(std::move(wanted)) {
        runner = std::thread([this] { run(); });
    }

    ~Thread() {
        isStopping = true;
        wake();
        runner.join();
    }

    void wake() noexcept {
        ++wakes;
        wakes.notify_one();
    }

    bool doPiece() noexcept {
        const std::lock_guard lock(working);
        return work();
    }

    void run() noexcept {
        while (!isStopping) {
            const auto before = wakes.load(); // a later wake ends the wait at once
            if (!doPiece())
                wakes.wait(before);
        }
    }

    Work work;
    std::mutex working; ///< the thread that owns it does the work
    std::atomic<bool> isStopping{false};
    std::atomic<std::uint32_t> wakes{0};
    std::thread runner; ///< started last, because it uses the others
};

SimulationWorker::SimulationWorker(Work work) : thread(std::make_unique<Thread>(std::move(work))) {}

SimulationWorker::~SimulationWorker() = default;

void SimulationWorker::wake() noexcept {
    thread->wake();
}

bool SimulationWorker::doPiece() noexcept {
    return thread->doPiece();
}

} // namespace idiophone
