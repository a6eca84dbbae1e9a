// One body's sound on its way to two ears, while the body moves.
#pragma once

#include "Scene/HeadModel.h"
#include "Synth/CellOutput.h"

#include <array>
#include <span>
#include <vector>

namespace idiophone {

/// Constructed off the audio thread; the rest neither allocates, locks nor throws.
class PlacedSource {
public:
    explicit PlacedSource(double sampleRateHz);

    /// Adds a cell of its sound to the ears, as the path goes evenly from where it was to this one
    /// at its end; the first cell after silence begins with it.
    void add(std::span<const float, cellSamples> sound,
             const HeardPath& path,
             const CellOutput& ears) noexcept;

    void reset() noexcept; ///< as constructed

    /// Nothing of what was added is still on its way.
    bool silent() const noexcept { return quietSamples >= lineSize; }

private:
    /// A delay as the cubic of Lagrange through four samples.
    struct Delay {
        std::size_t samples = 0; ///< to the first of the four
        std::array<float, 4> weights{};
    };
    /// y = b₀ x + b₁ x₁ − a₁ y₁ of what is delayed.
    struct Ear {
        Delay delay;
        float direct = 0, previous = 0;
    };
    struct Memory {
        float input = 0, output = 0;
    };

    Ear earOf(const EarPath& path, double gain) const noexcept;
    void takeIn(std::span<const float, cellSamples> sound, float pole) noexcept;
    void delayed(const Delay& delay, std::span<float, cellSamples> to) const noexcept;

    double rateHz;
    float feedback;          ///< a₁
    std::vector<float> line; ///< a ring of a power of two, and its first samples again behind it
    std::size_t lineSize;
    std::size_t position = 0; ///< of the next sample in the ring
    std::size_t quietSamples;
    bool isPlaced = false;
    float airPole = 0, air = 0;
    std::array<Ear, 2> ears;
    std::array<Memory, 2> memories;
};

} // namespace idiophone
