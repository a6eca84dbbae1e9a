// SPDX-License-Identifier: Apache-2.0
// Renders sliding and rolling as continuous forces on the synthesiser's grid, a few contacts at a
// time.
#pragma once

#include "Synth/CellStrikes.h"
#include "Synth/ContactForce.h"
#include "Synth/ForceCell.h"
#include "Synth/Surface.h"

#include <array>
#include <span>
#include <vector>

namespace idiophone {

/// The number of contacts that can sound at once.
inline constexpr std::size_t touchVoices = 24;
static_assert(touchVoices <= forceCapacity);

/// The state of a contact voice at a time.
struct TouchState {
    std::uint32_t pair = 0;  ///< counts the pairs that the voice has had; 0 before the first
    std::size_t surface = 0; ///< index of the surface that is heard
    std::array<std::size_t, 2> slots{};
    std::array<ForcePoint, 2> points{}; ///< contact points of both bodies, for 1 N
    double forceNewtons = 0;
    double slideMetresPerSecond = 0;
    double rollMetresPerSecond = 0;
};

/// Constructed and destroyed off the audio thread. The other members do not allocate, lock or
/// throw.
class TouchVoices {
public:
    /// The states name the surfaces by their indices.
    TouchVoices(std::span<const Surface> surfaces, double sampleRateHz, std::uint64_t seed);

    /// Sets a voice until the end of the current cell. The state's slots are the synthesiser's;
    /// unknown slots are skipped. `rollSlots`: where rolls act, after the state's
    /// slots; 0 lets slides and rolls act together.
    void press(std::size_t voice,
               const TouchState& state,
               const BegunCell& cell,
               std::size_t rollSlots = 0) noexcept;

    /// Fades the voice's force to 0 until the end of the current cell.
    void release(std::size_t voice, const BegunCell& cell) noexcept;

    void reset() noexcept; ///< restores the constructed state

private:
    struct Voice {
        std::vector<ContactForce> slides, rolls; ///< one for each surface
        TouchState last;
        std::size_t surface = 0;
    };

    using ForceSamples = std::span<float, cellSamples>;
    struct Sounding {
        bool slides = false, rolls = false;
    };

    Sounding render(Voice& voice,
                    const TouchState& state,
                    ForceSamples sliding,
                    ForceSamples rolling) noexcept;

    std::array<Voice, touchVoices> voices;
};

} // namespace idiophone
