// SPDX-License-Identifier: Apache-2.0
// Progress and cancellation of long work on meshes and modes.
#pragma once

#include "Object/Result.h"

#include <atomic>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>

namespace idiophone {

/// Both members may be empty. The working thread uses them.
struct WorkControl {
    /// Called from time to time with the fraction done (0 to 1, never decreasing) and the current
    /// step.
    std::function<void(double fraction, std::string_view step)> progress;
    /// Any thread sets this to true to stop the work within a fraction of a second.
    const std::atomic<bool>* cancelled = nullptr;

    bool isCancelled() const { return cancelled != nullptr && cancelled->load(); }
    void report(double fraction, std::string_view step) const {
        if (progress)
            progress(fraction, step);
    }
    /// Returns a control that reports its progress as the range `from` to `to` of this control,
    /// which must outlive it.
    WorkControl part(double from, double to) const {
        return {.progress =
                    [this, from, to](double fraction, std::string_view step) {
                        report(std::lerp(from, to, fraction), step);
                    },
                .cancelled = cancelled};
    }
    /// Returns a control without progress that is cancelled together with this control.
    WorkControl quiet() const { return {.progress = {}, .cancelled = cancelled}; }
};

/// The error of cancelled work, to tell it from failed work.
inline constexpr std::string_view cancelledMessage = "The analysis was cancelled.";

inline tl::unexpected<Error> cancellation() {
    return failure(std::string(cancelledMessage));
}

inline bool isCancellation(const Error& error) {
    return error.message == cancelledMessage;
}

} // namespace idiophone
