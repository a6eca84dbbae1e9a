// SPDX-License-Identifier: Apache-2.0
// The sound of one moving body on its way through the air to two ears.
#pragma once

#include "Synth/CellOutput.h"
#include "World/HeadModel.h"

#include <span>
#include <vector>

namespace idiophone {

/// Constructed off the audio thread. The other members do not allocate, lock or throw.
class PlacedSource {
public:
    virtual ~PlacedSource() = default;

    /// Adds a cell of sound to the ears. The path moves evenly from the previous one to `path` at
    /// the cell's end. The first cell after silence uses `path` throughout.
    void add(std::span<const float, cellSamples> sound,
             const HeardPath& path,
             const CellOutput& ears) noexcept;

    void reset() noexcept; ///< restores the constructed state

    /// Returns true if no added sound is still on its way.
    bool silent() const noexcept { return quietSamples >= lineSize; }

protected:
    /// `samplesOnTheWay`: the samples after which an added sound has been heard completely.
    PlacedSource(double sampleRateHz, std::size_t samplesOnTheWay);

    /// Returns the sound `samples` samples before the last added cell, at most `samplesOnTheWay`.
    /// It is contiguous up to that cell's end, for at most two cells.
    const float* cellBefore(std::size_t samples) const noexcept;

private:
    void takeIn(std::span<const float, cellSamples> sound, float pole) noexcept;
    /// Renders the last cell while the path moves from the previous one to `path`. `isFirst`: there
    /// is no previous path.
    virtual void hear(const HeardPath& path, bool isFirst, const CellOutput& ears) noexcept = 0;
    /// Clears all sound that is on its way.
    virtual void forget() noexcept = 0;

    double rateHz;
    std::size_t lineSize;
    std::vector<float> line;  ///< a ring of a power of two, then a copy of its first samples
    std::size_t position = 0; ///< of the next sample in the ring
    std::size_t quietSamples;
    bool isPlaced = false;
    float airPole = 0, air = 0;
};

} // namespace idiophone
