// Mixes the sounds of all bodies at the listener's two ears.
#pragma once

#include "Scene/HeadModel.h"
#include "Scene/HeadResponses.h"
#include "Scene/PlacedSource.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread. The other members do not allocate, lock or
/// throw.
class SceneEars {
public:
    /// `measured`: the listener's head at that sample rate; null selects a sphere.
    SceneEars(const Listener& listener,
              const std::shared_ptr<const HeadResponses>& measured,
              std::size_t slots,
              double sampleRateHz);

    /// Renders a cell to both ears from the first channel of every slot. `places` are in metres, at
    /// the cell's end.
    void hear(std::span<const CellOutput> cellsOfSlots,
              std::span<const Eigen::Vector3d> places,
              const CellOutput& ears) noexcept;

    void reset() noexcept; ///< to the state after construction

    /// Returns true if no sound is on its way.
    bool silent() const noexcept;

private:
    HeadModel head;
    std::vector<std::unique_ptr<PlacedSource>> sources; ///< one for each slot
};

} // namespace idiophone
