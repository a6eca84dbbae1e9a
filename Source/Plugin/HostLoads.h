// Counts what the host and MIDI load, for the history of the window.
#pragma once

#include "Plugin/Sound.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

namespace idiophone {

/// For any thread except the audio thread.
class HostLoads {
public:
    /// Counts a state or a program that the host has loaded.
    void count() {
        ++loads;
        takeBeforePrograms();
    }
    /// Returns the number of loads. Does not count refused states or programs that MIDI asked for.
    int counted() const noexcept { return loads; }

    /// Keeps the sound before a program that MIDI asked for, unless one is kept.
    void keepBeforePrograms(Sound sound) {
        const std::scoped_lock lock(mutex);
        if (!before)
            before = std::move(sound);
    }
    /// Returns the sound before the programs that MIDI has asked for since the last call or load by
    /// the host. Returns nothing if there were none.
    std::optional<Sound> takeBeforePrograms() {
        const std::scoped_lock lock(mutex);
        return std::exchange(before, std::nullopt);
    }

private:
    std::atomic<int> loads{0};
    std::mutex mutex;
    std::optional<Sound> before;
};

} // namespace idiophone
