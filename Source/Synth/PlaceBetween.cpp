// SPDX-License-Identifier: Apache-2.0
#include "Synth/PlaceBetween.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace idiophone {
namespace {

constexpr double shortestNormal = 1e-6;

} // namespace

void PlaceBetween::addRow(std::int32_t row, double weight) {
    const auto end = rows.begin() + static_cast<std::ptrdiff_t>(used);
    const auto known = std::find_if(rows.begin(), end, [row](Row r) { return r.row == row; });
    if (known != end)
        known->weight += weight;
    else
        rows[used++] = {row, weight};
}

void PlaceBetween::add(const StrikePoint& place, double weight) {
    if (!(weight > 0))
        return;
    for (std::size_t k = 0; k < 3; ++k)
        if (place.weights[k] != 0)
            addRow(place.shapeRows[k], weight * static_cast<double>(place.weights[k]));
    for (std::size_t axis = 0; axis < 3; ++axis)
        normalSum[axis] += weight * static_cast<double>(place.normal[axis]);
    if (weight > heaviestWeight) {
        heaviestWeight = weight;
        heaviestNormal = place.normal;
    }
}

StrikePoint PlaceBetween::point() const {
    auto kept = rows;
    const auto end = kept.begin() + static_cast<std::ptrdiff_t>(used);
    double leftOut = 0, sum = 1;
    if (used > maximumShapeRows) {
        std::sort(kept.begin(), end, [](Row a, Row b) { // a stable sort would allocate
            return a.weight != b.weight ? a.weight > b.weight : a.row < b.row;
        });
        leftOut = kept[maximumShapeRows].weight;
        sum = 0;
        for (std::size_t k = 0; k < maximumShapeRows; ++k)
            sum += kept[k].weight - leftOut;
        if (!(sum > 0)) { // all weights are equal
            leftOut = 0;
            sum = static_cast<double>(maximumShapeRows) * kept[0].weight;
        }
    }
    StrikePoint point{.weights = {}, .normal = heaviestNormal};
    for (std::size_t k = 0; k < std::min(used, maximumShapeRows); ++k) {
        point.shapeRows[k] = kept[k].row;
        point.weights[k] = static_cast<float>((kept[k].weight - leftOut) / sum);
    }
    const double length = std::hypot(normalSum[0], normalSum[1], normalSum[2]);
    if (length > shortestNormal)
        for (std::size_t axis = 0; axis < 3; ++axis)
            point.normal[axis] = static_cast<float>(normalSum[axis] / length);
    return point;
}

} // namespace idiophone
