// Slots' sounds from where their bodies are, as a scene's listener hears them.
#pragma once

#include "Scene/HeadModel.h"
#include "Scene/PlacedSource.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread; every other member neither allocates, locks nor
/// throws.
class SceneEars {
public:
    SceneEars(const Listener& listener, std::size_t slots, double sampleRateHz);

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
    std::vector<PlacedSource> sources; ///< of the slots
};

} // namespace idiophone
