// The sides of all faces, those along one edge together. Internal to Geometry.
#pragma once

#include "Geometry/Mesh.h"

#include <compare>
#include <vector>

namespace idiophone {

/// From this corner of the face to its next, between vertices `low` ≤ `high`.
struct FaceSide {
    int low = 0, high = 0, face = 0, corner = 0;

    auto operator<=>(const FaceSide&) const = default;
    bool isAlong(const FaceSide& other) const { return low == other.low && high == other.high; }
};

/// In ascending order of low, high, face and corner.
std::vector<FaceSide> sortedFaceSides(const Mesh& mesh);

} // namespace idiophone
