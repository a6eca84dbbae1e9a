#include "Plugin/VariantSession.h"

#include "Instrument/Mutation.h"

namespace idiophone {

void VariantSession::compare() {
    history.keepAudition();
    history.record(playsB() ? "Compare with A" : "Compare with B", [this] {
        auto& other = history.otherVariant();
        const auto now = holder.loadedSound();
        const auto next = other.sound.value_or(now);
        if (now == next || holder.playSound(next))
            other = {.sound = now, .playsB = !other.playsB};
    });
}

void VariantSession::copyToOther() {
    history.keepAudition();
    history.record(playsB() ? "Copy B to A" : "Copy A to B",
                   [this] { history.otherVariant().sound = holder.loadedSound(); });
}

void VariantSession::mutate(double strength, std::uint32_t seed) {
    history.keepAudition();
    history.record("Mutate", [&] {
        const auto now = holder.loadedSound();
        holder.changeParameters(
            now, mutated(now.parameters, now.instrument, now.preset, strength, seed));
    });
}

} // namespace idiophone
