// Computes the light of the newest scene on its own thread, because it takes some tenths of a
// second.
#pragma once

#include "Editor/SceneLight.h"

#include <atomic>
#include <functional>
#include <juce_core/juce_core.h>
#include <memory>
#include <mutex>
#include <vector>

namespace idiophone {

/// Threads: `begin` and `light` belong to one thread at a time (OpenGL). The worker runs from the
/// first request to the destructor. The mutex is held only to hand a request over.
class LightWorker final : private juce::Thread {
public:
    /// `arrived` is called on the worker's thread whenever a light is ready.
    explicit LightWorker(std::function<void()> arrived);
    /// Abandons the current light, and waits until the worker has stopped.
    ~LightWorker() override;

    /// Requests the light of these triangles, see `sceneLight`. Abandons the former request.
    void begin(std::vector<SceneVertex> vertices, const FloorArea& area);
    /// The light of the last request; nullptr while it is being computed.
    const SceneLight* light() const;

private:
    /// The requesting thread writes it, then the worker until `isReady`, then nobody.
    struct Request {
        std::vector<SceneVertex> vertices;
        FloorArea area;
        SceneLight light;
        std::atomic<bool> isAbandoned{false}, isReady{false};
    };

    void run() override;
    void compute(Request& request) const;

    std::function<void()> arrived;
    std::shared_ptr<Request> newest; ///< of the requesting thread
    std::mutex mutex;
    std::shared_ptr<Request> waiting; ///< guarded by the mutex
};

} // namespace idiophone
