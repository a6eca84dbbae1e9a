#include "Scene/SceneEars.h"

#include "Scene/MeasuredSource.h"
#include "Scene/SphereSource.h"

#include <algorithm>

namespace idiophone {

SceneEars::SceneEars(const Listener& listener,
                     const std::shared_ptr<const HeadResponses>& measured,
                     std::size_t slots,
                     double sampleRateHz)
    : head(listener) {
    for (std::size_t slot = 0; slot < slots; ++slot)
        if (measured != nullptr)
            sources.push_back(std::make_unique<MeasuredSource>(measured, sampleRateHz));
        else
            sources.push_back(std::make_unique<SphereSource>(sampleRateHz));
}

void SceneEars::hear(std::span<const CellOutput> cellsOfSlots,
                     std::span<const Eigen::Vector3d> places,
                     const CellOutput& ears) noexcept {
    for (std::size_t ear = 0; ear < 2; ++ear)
        std::fill_n(ears[ear].data(), cellSamples, 0.0f);
    for (std::size_t slot = 0; slot < sources.size(); ++slot) {
        const auto cell = cellsOfSlots[slot][0];
        const bool sounds = std::ranges::any_of(cell, [](float x) { return x != 0; });
        if (sounds || !sources[slot]->silent())
            sources[slot]->add(cell, head.path(places[slot]), ears);
    }
}

void SceneEars::reset() noexcept {
    for (auto& source : sources)
        source->reset();
}

bool SceneEars::silent() const noexcept {
    return std::ranges::all_of(sources, [](const auto& source) { return source->silent(); });
}

} // namespace idiophone
