// The places where keys strike an object, along a path over it and beside the path. They form a
// table, so that the audio thread only interpolates.
#pragma once

#include "Instrument/Preset.h"
#include "Object/ModalObject.h"
#include "Synth/Strike.h"

#include <array>
#include <cstddef>
#include <vector>

namespace idiophone {

struct StripPlace {
    StrikePoint point;
    /// Direction of the path along the surface: unit, or zero if the path has no direction.
    std::array<float, 3> direction{};
};

/// Two neighbouring places of a path, and the fraction from the first to the second.
struct StripStep {
    StripPlace first, second;
    double fraction = 0; ///< 0 to 1
};

struct StrikeStrip {
    int alongCount = 0;
    int acrossCount = 0;
    std::vector<StrikePoint> points;              ///< [along, across], within a face each
    std::vector<std::array<float, 3>> directions; ///< [along, across] as StripPlace::direction
    double lengthMetres = 0;                      ///< of the path

    /// Returns the nearest place of the table. `along` is 0 to 1 from one end of the path to the
    /// other, `across` −1 to 1. Any thread.
    const StrikePoint& at(double along, double across) const;

    /// Returns the place itself: linear between the two or three surrounding places of the table,
    /// without steps. Any thread; does not allocate.
    StripPlace between(double along, double across) const;

    /// Returns the places before and after `along` on the path. They stay the same while `along`
    /// moves between them. Any thread; does not allocate.
    StripStep around(double along, double across) const;

private:
    std::size_t index(int alongIndex, int acrossIndex) const;
};

/// Returns the strip of the map's path over an object. Each place is the nearest one on the surface
/// (ObjectSurface), the upper of two at equal distance. Off the audio thread.
StrikeStrip strikeStrip(const ModalObject& object, const KeyMap& map);

} // namespace idiophone
