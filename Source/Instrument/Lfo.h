// A low-frequency oscillator: its clock on the grid, and its value at any place of a swing.
#pragma once

#include "Parameters/ModulationTable.h"

#include <cstdint>
#include <optional>

namespace idiophone {

/// Returns the value of a shape after that many swings, −1 to 1. The seed decides the values of the
/// random shape, which holds each for one swing.
double lfoValue(LfoShape shape, double swings, std::uint32_t seed) noexcept;

/// For the audio thread, one cell of the grid at a time; neither allocates, locks nor throws. It
/// moves by cells only, so that a render repeats bit for bit.
class Lfo {
public:
    explicit Lfo(double secondsPerCell) : cellSeconds(secondsPerCell) {}

    /// Begins a cell at `rateHz`; the first cell begins at 0 swings. A swing of `beatsPerSwing`
    /// beats, if not 0, follows the tempo in beats a minute instead, if not 0, and stands where the
    /// song is if `beats` is given.
    void beginCell(double rateHz,
                   double beatsPerSwing,
                   double beatsPerMinute,
                   std::optional<double> beats) noexcept;
    /// Returns the swings at the start of the newest cell.
    double swings() const noexcept { return now; }
    void reset() noexcept { now = next = 0; }

private:
    double cellSeconds;
    double now = 0, next = 0; ///< swings at the start of the newest cell and of the next
};

} // namespace idiophone
