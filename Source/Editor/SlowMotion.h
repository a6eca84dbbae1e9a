// Vibration slowed down and exaggerated until it can be seen: which modes of an object are shown,
// how far they go and where they are in their swing. Plain mathematics; drawing is ObjectView's.
#pragma once

#include "Editor/SoundView.h"

#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

class SlowMotion {
public:
    /// At most this many modes are shown, those that go farthest.
    static constexpr std::size_t mostModes = 8;

    struct Swing {
        std::size_t mode = 0;
        float displacement = 0; ///< −1 to 1 over all, as far as at the blow that was largest lately
    };

    /// The modes as they sound now, of the same object as before, or after `reset`.
    void follow(std::span<const ModeNow> modes);

    /// Time goes on, for the eye.
    void advance(double seconds);

    /// Empty where nothing moves that could be seen.
    std::vector<Swing> swings() const;
    bool atRest() const { return shown.empty(); }

    /// Another object, at rest.
    void reset();

private:
    struct Shown {
        std::size_t mode = 0;
        double extent = 0; ///< share of the whole displacement
        double frequencyHz = 0;
        double phase = 0; ///< radians
    };

    std::vector<Shown> shown;
    double largestDisplacement = 0; ///< [m] lately
    double visible = 0;             ///< 0 to 1, of the whole
};

} // namespace idiophone
