// Compares two whole sounds, A and B, and varies the current one.
#pragma once

#include "Editor/SoundVariants.h"
#include "Plugin/SoundHistory.h"

namespace idiophone {

/// For the message thread. Comparing, copying or mutating an auditioned sound keeps it.
class VariantSession final : public SoundVariants {
public:
    VariantSession(SoundHolder& soundHolder, SoundHistory& soundHistory)
        : holder(soundHolder), history(soundHistory) {}

    bool playsB() override { return history.playsB(); }
    void compare() override;
    void copyToOther() override;
    void mutate(double strength, std::uint32_t seed) override;

private:
    SoundHolder& holder;
    SoundHistory& history;
};

} // namespace idiophone
