// The motor of a vibraphone. Its discs open and close the tubes, so that the modes that bars share
// with their tubes pulse.
#pragma once

namespace idiophone {

/// For the audio thread, one cell of the grid at a time; neither allocates, locks nor throws. It
/// turns by cells only, so that a render repeats bit for bit.
class Motor {
public:
    explicit Motor(double secondsPerCell) : cellSeconds(secondsPerCell) {}

    /// Turns the discs for a cell at `turnsPerSecond` ≥ 0. Returns the gain at the cell's end: from
    /// 1 (open) to 1 − `depth` (closed, 0 to 1), twice a turn each. A change of depth takes about
    /// 10 ms.
    float advance(double turnsPerSecond, double depth);
    /// Returns the last gain of `advance`; 1 at the start.
    float gain() const { return gainNow; }

    /// Corrects the phase to that of another clock; call it before `advance`. With `isAtOnce` the
    /// phase jumps. Otherwise it moves by a share of the shorter way to a phase with the same
    /// opening.
    void keepTo(double turns, bool isAtOnce);

    /// Restarts the motor with open discs.
    void reset();

private:
    double cellSeconds;
    double turn = 0; ///< 0 to 1
    double depthNow = 0;
    float gainNow = 1;
};

} // namespace idiophone
