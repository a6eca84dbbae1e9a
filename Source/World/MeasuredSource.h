// SPDX-License-Identifier: Apache-2.0
// Renders a body's sound at the two ears of a measured head.
#pragma once

#include "World/HeadResponses.h"
#include "World/PlacedSource.h"

#include <memory>

namespace idiophone {

/// Costs a convolution of a few milliseconds for each ear, and twice that while the body moves.
class MeasuredSource final : public PlacedSource {
public:
    MeasuredSource(std::shared_ptr<const HeadResponses> head, double sampleRateHz);

private:
    void hear(const HeardPath& path, bool isFirst, const CellOutput& output) noexcept override;
    void forget() noexcept override;
    void
    respond(std::size_t from, std::size_t ear, std::span<float, cellSamples> to) const noexcept;

    std::shared_ptr<const HeadResponses> responses;
    std::size_t direction = 0; ///< index into the responses
    float gain = 0;
};

} // namespace idiophone
