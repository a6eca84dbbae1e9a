// How a material looks: its finish and colour.
#pragma once

#include "Object/Material.h"
#include "Object/MaterialKind.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace idiophone {

/// The kinds of materials in their order, then the finishes that only furniture has. The shader
/// `scene.frag` has the same numbers.
enum class Finish { wood, metal, glass, stone, ceramic, plastic, cloth };
inline constexpr std::size_t finishCount = 7;

struct Appearance {
    Finish finish = Finish::plastic;
    std::array<float, 3> colour{}; ///< red, green, blue in sRGB; 0 to 1

    bool operator==(const Appearance&) const = default;
};

/// Returns red, green and blue of 0xRRGGBB.
std::array<float, 3> channelsOf(std::uint32_t colour);

/// Returns the appearance of a material. Materials of the library have a fixed one. Others look
/// like the library's nearest by density, stiffness and damping, mixed with those of the same kind
/// around it, so that the colour follows the figures without steps while the kind stays.
Appearance appearanceOf(const Material& material);

} // namespace idiophone
