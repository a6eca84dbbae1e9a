// Reports loads by the host and by MIDI to the window's history.
#pragma once

#include "Plugin/Sound.h"

#include <atomic>
#include <functional>
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

    /// Keeps the sound before a program that MIDI asked for, unless one is kept already.
    void keepBeforePrograms(const std::function<Sound()>& sound) {
        const std::scoped_lock lock(mutex);
        if (!before)
            before = sound();
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
