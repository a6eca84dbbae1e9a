// How a long analysis talks to whoever started it: progress out, a wish to stop in.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace idiophone {

/// Both may be left empty. They are used on the thread that runs the analysis.
struct AnalysisControl {
    /// Called now and then with the share done, 0 to 1 and never falling, and what is being done.
    std::function<void(double fraction, std::string_view step)> progress;
    /// Set to true from any thread, it stops the analysis within a fraction of a second.
    const std::atomic<bool>* cancelled = nullptr;

    bool isCancelled() const { return cancelled != nullptr && cancelled->load(); }
    void report(double fraction, std::string_view step) const {
        if (progress)
            progress(fraction, step);
    }
};

/// The error of an analysis that was stopped, to tell it from one that failed.
inline constexpr std::string_view cancelledMessage = "The analysis was cancelled.";

} // namespace idiophone
