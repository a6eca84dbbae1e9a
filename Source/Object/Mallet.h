// What strikes: the rack of mallets. Knows nothing of keys, velocities, parameters or contacts.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace idiophone {

struct Mallet {
    std::string_view name;
    std::string_view source; ///< where the figures come from
    double massKg;
    double headRadiusMetres;
    double effectiveModulusPa; ///< E/(1 − ν²) of the head by itself
    std::uint32_t colour = 0;  ///< of the head in the window, 0xRRGGBB
};

/// The mallets of Resources/Mallets/mallets.json, in the order in which the parameter has them. For
/// the life of the program; any thread.
std::span<const Mallet> malletRack();

} // namespace idiophone
