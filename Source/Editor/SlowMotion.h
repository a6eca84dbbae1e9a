// Slows vibration down and exaggerates it: chooses modes to show, with displacement and phase.
// Mathematics only; ObjectView draws it.
#pragma once

#include "Editor/SoundView.h"

#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

class SlowMotion {
public:
    /// Maximum number of modes shown. The modes with the largest displacement are chosen.
    static constexpr std::size_t maximumModes = 8;

    struct Swing {
        std::size_t mode = 0;
        /// Within −1 to 1 over all modes together; 1 is the largest recent strike.
        float displacement = 0;
    };

    /// Takes the current modes. They belong to the same object as before, unless `reset` was
    /// called.
    void follow(std::span<const ModeNow> modes);

    /// Advances the motion by a time in seconds, as the viewer sees it.
    void advance(double seconds);

    std::vector<Swing> swings() const;
    bool atRest() const { return shown.empty(); }

    /// Prepares for another object, at rest.
    void reset();

private:
    struct Shown {
        std::size_t mode = 0;
        double extent = 0; ///< share of the total displacement
        double frequencyHz = 0;
        double phase = 0; ///< radians
    };

    std::vector<Shown> shown;
    double largestDisplacement = 0; ///< [m] recent maximum
    double visible = 0;             ///< 0 to 1, scale of the total displacement
};

} // namespace idiophone
