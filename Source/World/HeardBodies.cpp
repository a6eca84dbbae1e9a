// SPDX-License-Identifier: Apache-2.0
#include "World/HeardBodies.h"

#include "World/MeasuredSource.h"
#include "World/SphereSource.h"

#include <algorithm>

namespace idiophone {

HeardBodies::HeardBodies(std::size_t slots,
                         std::span<const Surface> surfaces,
                         const Listener& listener,
                         double sampleRateHz,
                         std::uint64_t seed,
                         const std::shared_ptr<const HeadResponses>& measured)
    : contacts(surfaces, sampleRateHz, seed), head(listener) {
    for (std::size_t slot = 0; slot < slots; ++slot)
        if (measured != nullptr)
            sources.push_back(std::make_unique<MeasuredSource>(measured, sampleRateHz));
        else
            sources.push_back(std::make_unique<SphereSource>(sampleRateHz));
}

bool HeardBodies::strike(std::size_t slot,
                         const Strike& strike,
                         double sample,
                         const BegunCell& cell) noexcept {
    return slot < cell.cellsOfSlots.size() && crowded.strike(slot, strike, sample, cell);
}

void HeardBodies::hear(std::span<const CellOutput> cellsOfSlots,
                       std::span<const Eigen::Vector3d> places,
                       const CellOutput& ears) noexcept {
    for (std::size_t ear = 0; ear < 2; ++ear)
        std::fill_n(ears[ear].data(), cellSamples, 0.0f);
    for (std::size_t slot = 0; slot < sources.size(); ++slot)
        hearSlot(slot, cellsOfSlots[slot], places[slot], ears);
}

void HeardBodies::hearApart(std::span<const CellOutput> cellsOfSlots,
                            std::span<const Eigen::Vector3d> places,
                            std::span<const CellOutput> earsOfSlots) noexcept {
    for (std::size_t slot = 0; slot < sources.size(); ++slot)
        hearSlot(slot, cellsOfSlots[slot], places[slot % places.size()], earsOfSlots[slot]);
}

void HeardBodies::hearSlot(std::size_t slot,
                           const CellOutput& cellOfSlot,
                           const Eigen::Vector3d& place,
                           const CellOutput& ears) noexcept {
    const auto cell = cellOfSlot[0];
    const bool sounds = std::ranges::any_of(cell, [](float x) { return x != 0; });
    if (sounds || !sources[slot]->silent())
        sources[slot]->add(cell, head.path(place), ears);
}

void HeardBodies::reset() noexcept {
    crowded.clear();
    contacts.reset();
    for (auto& source : sources)
        source->reset();
}

bool HeardBodies::silent() const noexcept {
    return crowded.empty() &&
           std::ranges::all_of(sources, [](const auto& source) { return source->silent(); });
}

} // namespace idiophone
