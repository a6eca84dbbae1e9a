// The envelope of a note, on the grid: a straight rise, then exponential falls.
#pragma once

#include "Parameters/ParameterTable.h"

#include <cmath>

namespace idiophone {

/// The steps of an envelope in a cell; the same for all notes.
struct EnvelopeSteps {
    double attack = 1;             ///< rise a cell
    double decay = 1, release = 1; ///< share of the way to the sustain, and to 0
    double sustain = 0;            ///< 0 to 1

    /// A fall has covered 99 % of its way in the parameter's time.
    EnvelopeSteps(const ParameterValues& values, double secondsPerCell) noexcept
        : attack(secondsPerCell / values[ParameterId::envelopeAttack]),
          decay(fallIn(values[ParameterId::envelopeDecay], secondsPerCell)),
          release(fallIn(values[ParameterId::envelopeRelease], secondsPerCell)),
          sustain(values[ParameterId::envelopeSustain] / 100) {}

private:
    static double fallIn(double seconds, double secondsPerCell) noexcept {
        constexpr double timeConstants = 4.605170185988091; // ln 100
        return -std::expm1(-timeConstants * secondsPerCell / seconds);
    }
};

/// For the audio thread; neither allocates, locks nor throws.
class NoteEnvelope {
public:
    /// Rises from where it is. The rise is always completed, so that a key released at once, as
    /// drum pads do, is heard.
    void start() noexcept { rises = true; }
    /// Moves on by a cell, while the note is held or not.
    void advance(const EnvelopeSteps& steps, bool isHeld) noexcept {
        if (rises) {
            level += steps.attack;
            rises = level < 1;
            if (!rises)
                level = 1;
            return;
        }
        if (level == 0 && !isHeld)
            return;
        level += isHeld ? steps.decay * (steps.sustain - level) : -steps.release * level;
        if (level < silence)
            level = 0;
    }
    double value() const noexcept { return level; } ///< 0 to 1
    void reset() noexcept { *this = {}; }

private:
    static constexpr double silence = 1e-6;

    double level = 0;
    bool rises = false;
};

} // namespace idiophone
