// How an imported object is held while it is analysed.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace idiophone {

struct HeldSettings {
    enum class Kind {
        free,
        lowEnd,   ///< the end of the longest side with the lower coordinate
        highEnd,  ///< the other end
        group,    ///< the faces of a named group of the mesh file
        places,   ///< painted places of the surface
        asBefore, ///< as the object that is analysed again was held
    };

    /// Around a place the object is held within this radius, as a share of its longest side.
    static constexpr double placeRadius = 0.03;
    static constexpr std::size_t maximumPlaces = 1000;

    Kind kind = Kind::free;
    std::string group = {}; ///< for `group`: its name
    /// For `places`: their distances from the lowest corner of the mesh's bounding box along x, y
    /// and z, as shares of its longest side.
    std::vector<std::array<double, 3>> places = {};
    /// The quality factor that the support alone gives the lowest modes, > 0; 0: it is rigid.
    double quality = 0;

    bool isFree() const { return kind == Kind::free || (kind == Kind::places && places.empty()); }
    bool operator==(const HeldSettings&) const = default;
};

} // namespace idiophone
