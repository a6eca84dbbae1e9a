#include "Editor/MaterialColour.h"

namespace idiophone {
namespace {

constexpr std::uint32_t wood = 0x996b45, metal = 0x9ea6b0, stone = 0xa8adb0, plastic = 0x4c8c99;

/// Guesses the colour of a material outside the library. Wood has a grain; metals are heavy; stone,
/// glass and ceramics are stiff; plastics are neither.
std::uint32_t suggestedColour(const Material& material) {
    if (material.grain)
        return wood;
    if (material.densityKgPerM3 > 4500)
        return metal;
    return material.youngsModulusPa > 2e10 ? stone : plastic;
}

} // namespace

std::array<float, 3> colourOf(const Material& material) {
    const auto colour = materialColour(material.name).value_or(suggestedColour(material));
    const auto channel = [&](int shift) {
        return static_cast<float>((colour >> shift) & 0xff) / 255;
    };
    return {channel(16), channel(8), channel(0)};
}

} // namespace idiophone
