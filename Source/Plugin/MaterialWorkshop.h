// Fits materials to recordings on its own thread. It does not know the processor, which fetches the
// results.
#pragma once

#include "Analysis/RecordedMaterial.h"
#include "Editor/MaterialFitView.h"
#include "Plugin/RemainingTime.h"
#include "Plugin/WorkThread.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace idiophone {

/// Threads: call every member function from one thread at a time, not the audio thread (the message
/// thread calls them). Both sides share the status and the product under `mutex`.
class MaterialWorkshop {
public:
    /// Called on the worker. Returns what was struck, or nothing if that is unknown. The error is
    /// one sentence.
    using StruckObjectMaker = std::function<Result<std::optional<StruckObject>>()>;
    struct Task {
        std::filesystem::path recording;
        std::string materialName;
        StruckObjectMaker struckObject;
    };

    MaterialWorkshop() = default;
    MaterialWorkshop(const MaterialWorkshop&) = delete;
    MaterialWorkshop& operator=(const MaterialWorkshop&) = delete;
    /// Cancels, and waits until the worker has stopped.
    ~MaterialWorkshop() { cancel(); }

    /// Replaces any running or pending task.
    void start(Task task);
    void cancel();

    /// It stays `working` until the product is taken, and is `none` then.
    MaterialFitStatus status() const;
    /// Returns the material of the latest task once, if it is ready.
    std::optional<RecordedMaterial> takeProduct();

private:
    struct Job {
        Task task;
        std::atomic<bool> cancelled{false};
    };

    // Called on the worker.
    void work(const Job& job);
    Result<RecordedMaterial> make(const Job& job);
    void report(const Job& job, double progress, std::string_view step);
    void finish(const Job& job, Result<RecordedMaterial> made);

    mutable std::mutex mutex;
    std::shared_ptr<Job> current; ///< the latest
    MaterialFitStatus shown;
    RemainingTime remaining;
    std::optional<RecordedMaterial> product;
    WorkThread worker; ///< last, so that it ends first
};

} // namespace idiophone
