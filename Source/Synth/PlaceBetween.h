// SPDX-License-Identifier: Apache-2.0
// A place on an object as a weighted mean of up to three others, such as the corners of a face.
#pragma once

#include "Synth/Strike.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace idiophone {

/// Does not allocate. Any thread.
class PlaceBetween {
public:
    static constexpr std::size_t maximumPlaces = 3;

    /// Adds a place of at most three rows, as a face has. Weights must not be negative and must sum
    /// to 1 over all places.
    void add(const StrikePoint& place, double weight);

    /// Returns the mean. Rows of several places count once. If there are more rows than a strike
    /// point holds, fades the lightest out, so that the sound changes without a step while the
    /// weights change. If the normals cancel, takes that of the heaviest place.
    StrikePoint point() const;

private:
    struct Row {
        std::int32_t row = 0;
        double weight = 0;
    };

    void addRow(std::int32_t row, double weight);

    std::array<Row, 3 * maximumPlaces> rows{};
    std::size_t used = 0;
    std::array<double, 3> normalSum{};
    std::array<float, 3> heaviestNormal{0, 0, 1};
    double heaviestWeight = 0;
};

} // namespace idiophone
