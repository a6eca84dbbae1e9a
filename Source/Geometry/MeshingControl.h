// How a long remeshing talks to whoever started it: progress out, a wish to stop in.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace idiophone {

/// Both may be left empty. They are used on the thread that does the work.
struct MeshingControl {
    /// Called now and then with the share done, 0 to 1 and never falling.
    std::function<void(double fraction)> progress;
    /// Set to true from any thread, it stops the work soon: within a pass over the mesh.
    const std::atomic<bool>* cancelled = nullptr;

    bool isCancelled() const { return cancelled != nullptr && cancelled->load(); }
    void report(double fraction) const {
        if (progress)
            progress(fraction);
    }
};

/// The error of a meshing that was stopped, to tell it from one that failed.
inline constexpr std::string_view meshingCancelledMessage = "The meshing was cancelled.";

} // namespace idiophone
