// SPDX-License-Identifier: Apache-2.0
// The sound of bodies on the synthesiser's grid: impacts at their samples, contacts as
// continuous forces, and everything at the listener's ears.
#pragma once

#include "Synth/CellStrikes.h"
#include "World/HeadModel.h"
#include "World/HeadResponses.h"
#include "World/PlacedSource.h"
#include "World/TouchVoices.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// In each cell call `strike` and `contacts.press`, then `crowded.strikeBefore` for the whole cell,
/// then `hear`. Constructed and destroyed off the audio thread. The other members do not allocate,
/// lock or throw.
class HeardBodies {
public:
    /// `slots` are the synthesiser's. `surfaces`: see TouchVoices. `measured`: the listener's head
    /// at that sample rate; null selects a sphere.
    HeardBodies(std::size_t slots,
                std::span<const Surface> surfaces,
                const Listener& listener,
                double sampleRateHz,
                std::uint64_t seed = 1,
                const std::shared_ptr<const HeadResponses>& measured = nullptr);

    /// Adds an impact at a sample of the cell, or at once if it is earlier. Returns false if it is
    /// not valid for its slot.
    bool
    strike(std::size_t slot, const Strike& strike, double sample, const BegunCell& cell) noexcept;
    /// Renders a cell to both ears from the first channel of every slot. `places` are in metres, at
    /// the cell's end.
    void hear(std::span<const CellOutput> cellsOfSlots,
              std::span<const Eigen::Vector3d> places,
              const CellOutput& ears) noexcept;
    /// Does the same with ears of their own for each slot, which are not cleared first. If there
    /// are more slots than places, the places repeat.
    void hearApart(std::span<const CellOutput> cellsOfSlots,
                   std::span<const Eigen::Vector3d> places,
                   std::span<const CellOutput> earsOfSlots) noexcept;

    void setListener(const Listener& listener) noexcept { head = HeadModel(listener); }

    void reset() noexcept; ///< restores the constructed state, except the listener
    /// Returns whether no impact is pending and no sound is on its way to the listener.
    bool silent() const noexcept;

    TouchVoices contacts;
    CellStrikes crowded{1024}; ///< impacts on slots with no free contact

private:
    void hearSlot(std::size_t slot,
                  const CellOutput& cellOfSlot,
                  const Eigen::Vector3d& place,
                  const CellOutput& ears) noexcept;

    HeadModel head;
    std::vector<std::unique_ptr<PlacedSource>> sources; ///< one for each slot
};

} // namespace idiophone
