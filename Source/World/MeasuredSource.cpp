// SPDX-License-Identifier: Apache-2.0
#include "World/MeasuredSource.h"

#include <algorithm>
#include <array>

namespace idiophone {

MeasuredSource::MeasuredSource(std::shared_ptr<const HeadResponses> head, double sampleRateHz)
    : PlacedSource(sampleRateHz, head->lengthSamples()), responses(std::move(head)) {}

void MeasuredSource::forget() noexcept {
    gain = 0;
}

/// Filters the last added cell with one ear's response of direction `from`.
void MeasuredSource::respond(std::size_t from,
                             std::size_t ear,
                             std::span<float, cellSamples> to) const noexcept {
    std::ranges::fill(to, 0.0f);
    const auto response = responses->response(from, ear);
    for (std::size_t k = 0; k < response.size(); ++k) {
        const float* sound = cellBefore(k);
        const float weight = response[k];
        for (std::size_t i = 0; i < cellSamples; ++i)
            to[i] += weight * sound[i];
    }
}

void MeasuredSource::hear(const HeardPath& path, bool isFirst, const CellOutput& output) noexcept {
    const auto next = responses->nearest(path.direction);
    const auto nextGain = static_cast<float>(path.gain);
    if (isFirst) {
        direction = next;
        gain = nextGain;
    }
    alignas(64) std::array<float, cellSamples> before, after;
    for (std::size_t ear = 0; ear < 2; ++ear) {
        respond(direction, ear, before);
        if (next != direction)
            respond(next, ear, after);
        for (std::size_t i = 0; i < cellSamples; ++i) {
            const float way = static_cast<float>(i + 1) / cellSamples;
            const float heard =
                next == direction ? before[i] : before[i] + way * (after[i] - before[i]);
            output[ear][i] += (gain + way * (nextGain - gain)) * heard;
        }
    }
    direction = next;
    gain = nextGain;
}

} // namespace idiophone
