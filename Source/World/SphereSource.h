// SPDX-License-Identifier: Apache-2.0
// Renders a body's sound at the two ears of a spherical head.
#pragma once

#include "World/PlacedSource.h"

#include <array>

namespace idiophone {

class SphereSource final : public PlacedSource {
public:
    explicit SphereSource(double sampleRateHz);

private:
    /// A delay by cubic Lagrange interpolation of four samples.
    struct Delay {
        std::size_t samples = 0; ///< to the first of the four samples
        std::array<float, 4> weights{};
    };
    /// y = b₀ x + b₁ x₁ − a₁ y₁, where x is the delayed sound.
    struct Ear {
        Delay delay;
        float direct = 0, previous = 0;
    };
    struct Memory {
        float input = 0, output = 0;
    };

    void hear(const HeardPath& path, bool isFirst, const CellOutput& output) noexcept override;
    void forget() noexcept override;
    Ear earOf(const EarPath& path, double gain) const noexcept;
    void delayed(const Delay& delay, std::span<float, cellSamples> to) const noexcept;

    double rateHz;
    float feedback; ///< a₁
    std::array<Ear, 2> ears;
    std::array<Memory, 2> memories;
};

} // namespace idiophone
