#include "Editor/LightWorker.h"

#include <new>
#include <utility>

namespace idiophone {

LightWorker::LightWorker(std::function<void()> call)
    : juce::Thread("Light"), arrived(std::move(call)) {}

LightWorker::~LightWorker() {
    if (newest)
        newest->isAbandoned = true;
    stopThread(-1);
}

void LightWorker::begin(std::vector<SceneVertex> vertices, const FloorArea& area) {
    if (newest)
        newest->isAbandoned = true;
    newest = std::make_shared<Request>();
    newest->vertices = std::move(vertices);
    newest->area = area;
    {
        const std::scoped_lock lock(mutex);
        waiting = newest;
    }
    startThread(Priority::low); // once
    notify();
}

const SceneLight* LightWorker::light() const {
    return newest && newest->isReady ? &newest->light : nullptr;
}

void LightWorker::run() {
    while (!threadShouldExit()) {
        std::shared_ptr<Request> next;
        {
            const std::scoped_lock lock(mutex);
            next = std::exchange(waiting, nullptr);
        }
        if (next)
            compute(*next);
        else
            wait(-1);
    }
}

void LightWorker::compute(Request& request) const {
    try {
        auto light = sceneLight(request.vertices, request.area, &request.isAbandoned);
        request.vertices = {};
        if (!light)
            return;
        request.light = *std::move(light);
    } catch (const std::bad_alloc&) { // the picture stays without soft shadows
        return;
    }
    request.isReady = true;
    arrived();
}

} // namespace idiophone
