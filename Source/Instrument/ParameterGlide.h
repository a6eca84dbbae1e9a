// Smooths parameters on the grid. A host gives one value a block, which would be heard as steps.
#pragma once

#include "Parameters/ParameterTable.h"

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. It moves by cells only, so that a
/// render repeats bit for bit.
class ParameterGlide {
public:
    /// Time for 63 % of the way: smooth for blocks up to about 500 samples, yet heard as immediate.
    static constexpr double glideSeconds = 0.01;

    /// Returns the share of the way to a goal that a cell covers.
    static double fractionPerCell(double secondsPerCell) noexcept;

    explicit ParameterGlide(double secondsPerCell);

    /// Sets the goal of the parameters that glide: material, size, pitch, listening position, and
    /// the figures of sustained contacts. All other parameters take their new value at once. After
    /// `reset`, and for a newly chosen material, the gliding parameters do so too.
    void setGoal(const ParameterValues& wanted) noexcept;
    /// Moves on by one cell, on each parameter's own scale.
    void advance() noexcept;
    const ParameterValues& values() const noexcept { return now; }
    const ParameterValues& goalValues() const noexcept { return goal; }

    void reset() noexcept { isFresh = true; }

private:
    double share;
    bool isFresh = true;
    bool isMoving = false;
    ParameterValues goal, now;
};

} // namespace idiophone
