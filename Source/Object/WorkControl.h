// How long work on meshes and modes talks to whoever started it: progress out, a wish to stop in.
#pragma once

#include "Object/Result.h"

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

namespace idiophone {

/// Both may be left empty. They are used on the thread that works.
struct WorkControl {
    /// Called now and then with the share done, 0 to 1 and never falling, and what is being done.
    std::function<void(double fraction, std::string_view step)> progress;
    /// Set to true from any thread, it stops the work within a fraction of a second.
    const std::atomic<bool>* cancelled = nullptr;

    bool isCancelled() const { return cancelled != nullptr && cancelled->load(); }
    void report(double fraction, std::string_view step) const {
        if (progress)
            progress(fraction, step);
    }
    /// For a part that tells nothing of its progress, and stops as the whole does.
    WorkControl quiet() const { return {.progress = {}, .cancelled = cancelled}; }
};

/// The error of work that was stopped, to tell it from work that failed.
inline constexpr std::string_view cancelledMessage = "The analysis was cancelled.";

inline tl::unexpected<Error> cancellation() {
    return failure(std::string(cancelledMessage));
}

inline bool isCancellation(const Error& error) {
    return error.message == cancelledMessage;
}

} // namespace idiophone
