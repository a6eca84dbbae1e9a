// The sound of a scene's bodies on the synthesiser's grid: impacts at their samples, contacts as
// continuous forces, and everything at the listener's ears.
#pragma once

#include "Instrument/CellStrikes.h"
#include "Scene/SceneEars.h"
#include "Scene/SceneSimulation.h"
#include "Scene/TouchVoices.h"

namespace idiophone {

/// In each cell call `strike` and `contacts.press`, then `crowded.strikeBefore` for the whole cell,
/// then `ears.hear`. Constructed and destroyed off the audio thread. The other members do not
/// allocate, lock or throw.
struct SceneSound {
    /// `slots` are the synthesiser's. `head`: the listener's measured head at that sample rate;
    /// null selects a sphere.
    SceneSound(const SceneAssets& assets,
               std::size_t slots,
               double sampleRateHz,
               std::uint64_t seed = 1,
               const std::shared_ptr<const HeadResponses>& head = nullptr)
        : ears(assets.scene().listener, head, slots, sampleRateHz),
          contacts(assets, sampleRateHz, seed) {}

    /// Adds an impact at a sample of the cell, or at once if it is earlier. Returns false if it is
    /// not valid for its slot.
    bool strike(const SceneImpact& impact, double sample, const BegunCell& cell) noexcept {
        return impact.slot < cell.cellsOfSlots.size() &&
               crowded.strike(impact.slot, impact.strike, sample, cell);
    }

    /// Returns whether no impact is pending and no sound on its way to the listener.
    bool silent() const noexcept { return crowded.empty() && ears.silent(); }

    SceneEars ears;
    TouchVoices contacts;
    CellStrikes crowded{1024}; ///< impacts on slots with no free contact
};

} // namespace idiophone
