#include "Plugin/LastSound.h"

#include <cmath>
#include <new>

namespace idiophone {

void LastSound::prepare(double sampleRateHz) {
    const std::scoped_lock lock(mutex);
    if (sampleRateHz == rateHz)
        return;
    rateHz = sampleRateHz;
    current = nullptr;
    if (kept != nullptr)
        kept->retire();
    kept = nullptr;
    make();
}

void LastSound::keep() {
    const std::scoped_lock lock(mutex);
    isWanted = true;
    make();
}

std::shared_ptr<const RollingSound> LastSound::sound() const {
    const std::scoped_lock lock(mutex);
    return kept;
}

/// Needs the lock. A callback may run, because there is nothing yet that it could write to.
void LastSound::make() {
    if (!isWanted || rateHz <= 0 || kept != nullptr)
        return;
    try {
        kept = std::make_shared<RollingSound>(
            rateHz, static_cast<std::size_t>(std::ceil(keptSeconds * rateHz)));
        current.store(kept.get(), std::memory_order_release);
    } catch (const std::bad_alloc&) {
        kept = nullptr;
    }
}

} // namespace idiophone
