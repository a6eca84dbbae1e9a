// Slots' sounds from where their bodies are, as a scene's listener hears them.
#pragma once

#include "Scene/HeadModel.h"
#include "Scene/HeadResponses.h"
#include "Scene/PlacedSource.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread; every other member neither allocates, locks nor
/// throws.
class SceneEars {
public:
    /// `measured`: the listener's head at that rate; none: a sphere.
    SceneEars(const Listener& listener,
              const std::shared_ptr<const HeadResponses>& measured,
              std::size_t slots,
              double sampleRateHz);

    /// A cell of every slot (of its first channel) to both ears, with each slot at its place in
    /// metres by its end.
    void hear(std::span<const CellOutput> cellsOfSlots,
              std::span<const Eigen::Vector3d> places,
              const CellOutput& ears) noexcept;

    void reset() noexcept; ///< as constructed

    /// Nothing is on its way.
    bool silent() const noexcept;

private:
    HeadModel head;
    std::vector<std::unique_ptr<PlacedSource>> sources; ///< of the slots
};

} // namespace idiophone
