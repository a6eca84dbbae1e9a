// The motor of a vibraphone, whose discs open and close the tubes: the modes that bars share with
// their tubes pulse.
#pragma once

namespace idiophone {

/// On the audio thread, a cell of the grid at a time; neither allocates, locks nor throws. It turns
/// by cells alone, so that a render repeats bit for bit.
class Motor {
public:
    explicit Motor(double secondsPerCell) : cellSeconds(secondsPerCell) {}

    /// Turns on by a cell at `turnsPerSecond` ≥ 0 and returns the gain at its end, from 1 (open) to
    /// 1 − `depth` (closed, 0 to 1), twice a turn each. A change of depth takes about 10 ms.
    float advance(double turnsPerSecond, double depth);
    /// As returned last; 1 at the start.
    float gain() const { return gainNow; }

    /// Before `advance`, where something else says how far the motor has turned: so far at once, or
    /// a share of the way, by the shorter one to discs as open as that.
    void keepTo(double turns, bool isAtOnce);

    /// Open, as at the start.
    void reset();

private:
    double cellSeconds;
    double turn = 0; ///< 0 to 1
    double depthNow = 0;
    float gainNow = 1;
};

} // namespace idiophone
