// SPDX-License-Identifier: Apache-2.0
// Lists the sides of all faces, sorted so that sides along one edge are adjacent.
#pragma once

#include "Mesh/Mesh.h"

#include <compare>
#include <vector>

namespace idiophone {

/// The side from this corner of the face to the next, between vertices `low` ≤ `high`.
struct FaceSide {
    int low = 0, high = 0, face = 0, corner = 0;

    auto operator<=>(const FaceSide&) const = default;
    bool isAlong(const FaceSide& other) const { return low == other.low && high == other.high; }
};

/// Returns all sides in ascending order of low, high, face and corner.
std::vector<FaceSide> sortedFaceSides(const Mesh& mesh);

} // namespace idiophone
