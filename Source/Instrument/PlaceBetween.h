// A place on an object as a weighted mean of up to three others: what ObjectSurface makes of the
// corners of a face, and StrikeStrip of the places of its table.
#pragma once

#include "Synth/Strike.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace idiophone {

/// Does not allocate. Any thread.
class PlaceBetween {
public:
    static constexpr std::size_t mostPlaces = 3;

    /// Adds a place of at most three rows, as a face has them. The weights of all places are not
    /// negative and sum to 1.
    void add(const StrikePoint& place, double weight);

    /// Rows of several places count once. Of more rows than a strike point holds the lightest are
    /// left out, under a fade: what is heard changes without a step as the weights change. The
    /// normal is that of the heaviest place where the places' cancel.
    StrikePoint point() const;

private:
    struct Row {
        std::int32_t row = 0;
        double weight = 0;
    };

    void addRow(std::int32_t row, double weight);

    std::array<Row, 3 * mostPlaces> rows{};
    std::size_t used = 0;
    std::array<double, 3> normalSum{};
    std::array<float, 3> heaviestNormal{0, 0, 1};
    double heaviestWeight = 0;
};

} // namespace idiophone
