// Parameters that sound while they move, smoothed on the grid: a host hands over one value a block,
// which would be heard as steps.
#pragma once

#include "Parameters/ParameterTable.h"

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. Goes by cells alone, so that a render
/// repeats bit for bit.
class ParameterGlide {
public:
    /// 63 % of the way in this time: smooth for blocks up to some 500 samples, and no slower to the
    /// ear than at once.
    static constexpr double glideSeconds = 0.01;

    /// Of the way to a goal, in a cell.
    static double shareOfWay(double secondsPerCell) noexcept;

    explicit ParameterGlide(double secondsPerCell);

    /// What glides is on its way from here on: material, size, pitch, where all is heard from and
    /// what a held contact does.
    /// All else is so at once, as are all values after `reset`, and the figures of a material that
    /// was just chosen.
    void setGoal(const ParameterValues& wanted) noexcept;
    /// A cell further, by each parameter's own scale.
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
