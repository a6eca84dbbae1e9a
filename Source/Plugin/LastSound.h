// Keeps the last seconds of the output, once a window has asked for them.
#pragma once

#include "Plugin/RollingSound.h"

#include <memory>
#include <mutex>

namespace idiophone {

/// Without a window it takes no memory. At 48 kHz the seconds take 11.5 MB.
class LastSound {
public:
    static constexpr double keptSeconds = 30;

    /// [any thread but audio] Call while no callback runs. At another rate the sound starts anew.
    void prepare(double sampleRateHz);
    /// [any thread but audio] Keeps the sound from now on. Without memory for it, keeps nothing.
    void keep();
    /// [any thread but audio] Returns nothing before `keep` and `prepare`. At another rate a new
    /// one replaces it, and it is retired.
    std::shared_ptr<const RollingSound> sound() const;

    /// [audio thread] See RollingSound::write.
    void write(std::span<const float* const> channels, std::size_t count) noexcept {
        if (auto* const now = current.load(std::memory_order_acquire))
            now->write(channels, count);
    }

private:
    void make();

    mutable std::mutex mutex; ///< for all but `current`
    bool isWanted = false;
    double rateHz = 0;
    std::shared_ptr<RollingSound> kept;
    std::atomic<RollingSound*> current{nullptr};
};

} // namespace idiophone
