// SPDX-License-Identifier: Apache-2.0
// The destination of a cell of sound: 64 samples of one or two channels.
#pragma once

#include "Synth/SynthesisSettings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

class CellOutput {
public:
    CellOutput(std::span<float, cellSamples> mono) noexcept
        : samples{mono.data(), nullptr}, count(1) {}
    CellOutput(std::array<float, cellSamples>& mono) noexcept : CellOutput(std::span(mono)) {}
    CellOutput(std::span<float, cellSamples> left, std::span<float, cellSamples> right) noexcept
        : samples{left.data(), right.data()}, count(2) {}

    std::size_t channels() const noexcept { return count; }
    std::span<float, cellSamples> operator[](std::size_t channel) const noexcept {
        return std::span<float, cellSamples>(samples[channel], cellSamples);
    }
    void clear() const noexcept {
        for (std::size_t c = 0; c < count; ++c)
            std::fill_n(samples[c], cellSamples, 0.0f);
    }

private:
    std::array<float*, 2> samples;
    std::size_t count;
};

/// Returns one mono cell per slot, as views of `samples` [slots, 64]. Allocates.
inline std::vector<CellOutput> cellsOfSlotsIn(std::span<float> samples) {
    std::vector<CellOutput> cells;
    for (; samples.size() >= cellSamples; samples = samples.subspan(cellSamples))
        cells.emplace_back(samples.first<cellSamples>());
    return cells;
}

} // namespace idiophone
