// The force of a contact that a key or a hand presses: it follows its gain in ramps from cell to
// cell, and fades out when it is released.
#pragma once

#include "Synth/ContactForce.h"

#include <cstdint>
#include <memory>
#include <span>

namespace idiophone {

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws.
class PressedForce {
public:
    /// Maximum time from a release to zero force, with the wait for the next grid point, at sample
    /// rates of 8 kHz and more. At lower rates one cell takes longer.
    static constexpr double fadeSeconds = 0.01;

    PressedForce(const std::shared_ptr<const SurfaceProfile>& profile, std::uint64_t seed);

    /// Begins a new contact.
    void begin() noexcept;
    /// Begins to fade out: half a cosine, without a corner at either end.
    void release() noexcept { isReleased = true; }
    /// Ends the contact at once.
    void end() noexcept;

    bool isActive() const noexcept { return remaining > 0; }
    bool isHeld() const noexcept { return isActive() && !isReleased; }
    bool begins() const noexcept { return isFresh; } ///< no sound of this contact yet
    /// Returns the part of the fade that remains: 1 while it is held, 0 if there is no contact.
    double fade() const noexcept { return remaining; }
    ContactForce& contact() noexcept { return force; }

    /// Renders a cell as ContactForce::render does. The gain moves from that of the previous cell
    /// on a line; the first cell has it at once.
    bool render(const ContactMotion& motion,
                double nextGain,
                std::span<float, cellSamples> newtons) noexcept;

private:
    ContactForce force;
    int fadeSamples;
    double remaining = 0;
    bool isReleased = false;
    bool isFresh = false;
    double gain = 0;
};

} // namespace idiophone
