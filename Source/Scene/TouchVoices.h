// Renders sliding and rolling as continuous forces on the synthesiser's grid, a few contacts at a
// time.
#pragma once

#include "Instrument/CellStrikes.h"
#include "Scene/SceneAssets.h"
#include "Scene/TouchTracker.h"
#include "Synth/ContactForce.h"

#include <array>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread. The other members do not allocate, lock or
/// throw.
class TouchVoices {
public:
    TouchVoices(const SceneAssets& assets, double sampleRateHz, std::uint64_t seed);

    /// Sets a voice until the end of the current cell. The state's slots are the synthesiser's;
    /// `noSlot` and unknown slots are skipped. `rollSlots`: where rolls act, after the state's
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

    std::vector<std::size_t> surfaceOfRole;
    std::array<Voice, TouchTracker::voiceCount> voices;
};

} // namespace idiophone
