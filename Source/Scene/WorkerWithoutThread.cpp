// A worker without a thread: WebAssembly has none.
#include "Scene/SimulationWorker.h"

#include <utility>

namespace idiophone {

struct SimulationWorker::Thread {
    Work work;
};

SimulationWorker::SimulationWorker(Work work)
    : thread(std::make_unique<Thread>(Thread{std::move(work)})) {}

SimulationWorker::~SimulationWorker() = default;

void SimulationWorker::wake() noexcept {}

bool SimulationWorker::doPiece() noexcept {
    return thread->work();
}

} // namespace idiophone
