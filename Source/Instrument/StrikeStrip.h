// Where the keys of an instrument strike an object: the places along a path over it and beside the
// path, as a table, so that the audio thread only interpolates.
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
    /// The path's direction along the surface there: unit, or zero where it has none.
    std::array<float, 3> direction{};
};

/// Two neighbouring places of a path, and how far on the way from the first to the second.
struct StripStep {
    StripPlace first, second;
    double way = 0; ///< 0 to 1
};

struct StrikeStrip {
    int alongCount = 0;
    int acrossCount = 0;
    std::vector<StrikePoint> points;              ///< [along, across], within a face each
    std::vector<std::array<float, 3>> directions; ///< [along, across] the path's, as in StripPlace
    double lengthMetres = 0;                      ///< of the path

    /// The place of the table that is nearest; `along` 0 to 1 from one end of the path to the
    /// other, `across` −1 to 1. Any thread.
    const StrikePoint& at(double along, double across) const;

    /// The place itself: linear between the two or three places of the table around it, without a
    /// step anywhere. Any thread; does not allocate.
    StripPlace between(double along, double across) const;

    /// The two places of the table's length around it. They stay the same while `along` moves
    /// between them. Any thread; does not allocate.
    StripStep around(double along, double across) const;

private:
    std::size_t index(int alongIndex, int acrossIndex) const;
};

/// The strip of the map's path over an object, each place the nearest one on the surface
/// (ObjectSurface), of places equally near the upper one. Off the audio thread.
StrikeStrip strikeStrip(const ModalObject& object, const KeyMap& map);

} // namespace idiophone
