// A hand that taps and scrapes one body along a recorded path.
#pragma once

#include "Scene/Contact.h"
#include "Scene/SceneAssets.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace idiophone {

/// One thread at a time; not for the audio thread.
class RecordedHand {
public:
    /// The roles belong to the hand's kinds. All three arguments must outlive it. `played` must be
    /// a body that sounds.
    RecordedHand(const Hand& hand, const SceneAssets::Role& played, const SceneAssets::Role& tool)
        : recorded(hand), object(played), head(tool) {}

    /// Returns the contact of the tool at a time, or nothing. `body` and `handBody` number the
    /// played body and the hand.
    std::optional<Touch> touchAt(double seconds, std::size_t body, std::size_t handBody) const;

    /// Returns the taps at times in [from, until).
    std::vector<Impact>
    tapsBetween(double from, double until, std::size_t body, std::size_t handBody) const;

private:
    Eigen::Vector3d inwardAt(const Eigen::Vector3d& pointMetres) const;

    const Hand& recorded;
    const SceneAssets::Role& object;
    const SceneAssets::Role& head;
};

} // namespace idiophone
