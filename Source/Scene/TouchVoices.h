// What slides and rolls as continuous forces on the synthesiser's grid, a few contacts at a time.
#pragma once

#include "Scene/SceneCast.h"
#include "Scene/TouchTracker.h"
#include "Synth/ContactForce.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread; every other member neither allocates, locks nor
/// throws.
class TouchVoices {
public:
    TouchVoices(const SceneCast& cast, double sampleRateHz, std::uint64_t seed);

    /// What a voice does until the end of the cell begun last. The state's slots are those of the
    /// synthesiser; a slot that it has not is not pressed.
    void press(std::size_t voice,
               const TouchState& state,
               Synthesiser& synthesiser,
               std::span<const CellOutput> cellsOfSlots) noexcept;

    /// The end of what a voice did: its force goes to 0 until the end of the cell begun last.
    void release(std::size_t voice,
                 Synthesiser& synthesiser,
                 std::span<const CellOutput> cellsOfSlots) noexcept;

    void reset() noexcept; ///< as constructed

private:
    struct Voice {
        std::vector<ContactForce> slides, rolls; ///< one for each surface
        TouchState last;
        std::size_t surface = 0;
    };

    bool
    render(Voice& voice, const TouchState& state, std::span<float, cellSamples> newtons) noexcept;

    std::vector<std::size_t> surfaceOfRole;
    std::array<Voice, TouchTracker::voiceCount> voices;
};

} // namespace idiophone
