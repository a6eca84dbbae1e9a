// Two whole sounds, A and B, to go to and fro between, and chance variations of the one that plays.
#pragma once

#include <cstdint>

namespace idiophone {

/// For the message thread. Nothing here clicks, and everything is a step of the history.
class SoundVariants {
public:
    virtual ~SoundVariants() = default;

    /// Whether B is the one that plays and is edited; a new session begins with A.
    virtual bool playsB() = 0;
    /// Plays the other one. As long as it has not been made, it is a copy of the one that plays.
    virtual void compare() = 0;
    /// Makes the other one a copy of the one that plays.
    virtual void copyToOther() = 0;

    /// Plays a new sound near the present one, within musical bounds; as near as `strength` is
    /// small, which is from 0 to 1. The same seed makes the same sound.
    virtual void mutate(double strength, std::uint32_t seed) = 0;
};

} // namespace idiophone
