// A hand that taps and scrapes one body along a recorded path.
#pragma once

#include "Scene/Contact.h"
#include "Scene/SceneCast.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace idiophone {

/// One thread at a time; not for the audio thread.
class RecordedHand {
public:
    /// The roles are those of the hand's kinds, and outlive it as the hand does; what is played is
    /// heard.
    RecordedHand(const Hand& hand, const SceneCast::Role& played, const SceneCast::Role& tool)
        : recorded(hand), object(played), head(tool) {}

    /// What it rubs at a moment, if it touches. `bodies` are the played one and the hand.
    std::optional<Touch> touchAt(double seconds, std::size_t body, std::size_t handBody) const;

    /// Its taps from one moment on and before another one.
    std::vector<Impact>
    tapsBetween(double from, double until, std::size_t body, std::size_t handBody) const;

private:
    Eigen::Vector3d inwardAt(const Eigen::Vector3d& pointMetres) const;

    const Hand& recorded;
    const SceneCast::Role& object;
    const SceneCast::Role& head;
};

} // namespace idiophone
