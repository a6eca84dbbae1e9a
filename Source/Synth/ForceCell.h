// SPDX-License-Identifier: Apache-2.0
// A cell of continuous force that scrapes or rolls exert on an object.
#pragma once

#include "Synth/Strike.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// Maximum number of simultaneous continuous contacts of a synthesiser.
inline constexpr std::size_t forceCapacity = 35;

/// A point of an object's surface and the force there for each newton of the signal.
struct ForcePoint {
    StrikePoint point;
    std::array<float, 3> direction{0, 0, -1};

    bool operator==(const ForcePoint&) const = default;
};

/// A place between two neighbouring points of a path. The responses at both points are cached while
/// the contact is near, so that only new points cost time.
struct ForcePlace {
    std::array<ForcePoint, 2> points;
    float fraction = 0; ///< 0 at the first point to 1 at the second; at 0 the second is not read

    bool operator==(const ForcePlace&) const = default;
};

struct ForceCell {
    std::size_t contact = 0; ///< index of the contact among the simultaneous ones, < forceCapacity
    ForcePlace start, end;   ///< place of the contact at the cell's start and at its end
    std::span<const float, cellSamples> newtons;
    /// Each sample is an impulse that sounds as a strike does. Otherwise the samples are those of a
    /// steady force, which is silent while it is constant.
    bool isImpulses = false;
};

} // namespace idiophone
