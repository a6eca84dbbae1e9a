// One body's sound on its way through the air to two ears, while the body moves.
#pragma once

#include "Scene/HeadModel.h"
#include "Synth/CellOutput.h"

#include <span>
#include <vector>

namespace idiophone {

/// Constructed off the audio thread; the rest neither allocates, locks nor throws.
class PlacedSource {
public:
    virtual ~PlacedSource() = default;

    /// Adds a cell of its sound to the ears, as the path goes evenly from where it was to this one
    /// at its end; the first cell after silence begins with it.
    void add(std::span<const float, cellSamples> sound,
             const HeardPath& path,
             const CellOutput& ears) noexcept;

    void reset() noexcept; ///< as constructed

    /// Nothing of what was added is still on its way.
    bool silent() const noexcept { return quietSamples >= lineSize; }

protected:
    /// `samplesOnTheWay`: after which what was added has been heard.
    PlacedSource(double sampleRateHz, std::size_t samplesOnTheWay);

    /// The sound as many samples, at most `samplesOnTheWay`, before the cell added last; from there
    /// on it is in one piece up to that cell's end, two cells of it at most.
    const float* cellBefore(std::size_t samples) const noexcept;

private:
    void takeIn(std::span<const float, cellSamples> sound, float pole) noexcept;
    /// From the path it had to this one; `isFirst`: it had none.
    virtual void hear(const HeardPath& path, bool isFirst, const CellOutput& ears) noexcept = 0;
    /// Nothing is on its way.
    virtual void forget() noexcept = 0;

    double rateHz;
    std::size_t lineSize;
    std::vector<float> line;  ///< a ring of a power of two, and its first samples again behind it
    std::size_t position = 0; ///< of the next sample in the ring
    std::size_t quietSamples;
    bool isPlaced = false;
    float airPole = 0, air = 0;
};

} // namespace idiophone
