// Comparison of two whole sounds, A and B, and random variations of the current one.
#pragma once

#include <cstdint>

namespace idiophone {

/// For the message thread. No call makes the sound click. Each one is a step of the edit history.
class SoundVariants {
public:
    virtual ~SoundVariants() = default;

    /// Whether B plays and is edited. A new session begins with A.
    virtual bool playsB() = 0;
    /// Plays the other sound. At first, the other sound is a copy of the current one.
    virtual void compare() = 0;
    /// Copies the current sound to the other one.
    virtual void copyToOther() = 0;

    /// Plays a random variation of the current sound, within musical bounds. `strength` is 0 to 1;
    /// a smaller one changes the sound less. The same seed gives the same sound.
    virtual void mutate(double strength, std::uint32_t seed) = 0;
};

} // namespace idiophone
