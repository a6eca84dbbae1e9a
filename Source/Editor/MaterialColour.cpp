#include "Editor/MaterialColour.h"

#include <algorithm>
#include <string_view>

namespace idiophone {
namespace {

using Colour = std::array<float, 3>;

struct NamedColour {
    std::string_view word; ///< in the material's name
    Colour colour;
};

constexpr std::array<NamedColour, 17> named{{{"Rosewood", {0.42f, 0.20f, 0.14f}},
                                             {"Padauk", {0.62f, 0.25f, 0.13f}},
                                             {"Maple", {0.80f, 0.66f, 0.47f}},
                                             {"Sapele", {0.52f, 0.28f, 0.17f}},
                                             {"Bubinga", {0.50f, 0.22f, 0.16f}},
                                             {"Wood", {0.66f, 0.48f, 0.31f}},
                                             {"Bell glass", {0.62f, 0.78f, 0.80f}},
                                             {"Glass", {0.62f, 0.78f, 0.80f}},
                                             {"bronze", {0.72f, 0.54f, 0.29f}},
                                             {"Brass", {0.80f, 0.64f, 0.30f}},
                                             {"Copper", {0.76f, 0.44f, 0.29f}},
                                             {"Aluminium", {0.78f, 0.80f, 0.83f}},
                                             {"Porcelain", {0.92f, 0.91f, 0.88f}},
                                             {"Ceramic", {0.86f, 0.82f, 0.76f}},
                                             {"Slate", {0.33f, 0.37f, 0.42f}},
                                             {"Granite", {0.58f, 0.53f, 0.52f}},
                                             {"Marble", {0.85f, 0.84f, 0.83f}}}};

constexpr Colour wood{0.60f, 0.42f, 0.27f}, metal{0.62f, 0.65f, 0.69f}, stone{0.66f, 0.68f, 0.69f},
    plastic{0.30f, 0.55f, 0.60f};

} // namespace

Colour colourOf(const Material& material) {
    const auto found = std::ranges::find_if(named, [&](const NamedColour& candidate) {
        return material.name.find(candidate.word) != std::string::npos;
    });
    if (found != named.end())
        return found->colour;
    if (material.grain)
        return wood;
    if (material.densityKgPerM3 > 4500)
        return metal;
    return material.youngsModulusPa > 2e10 ? stone : plastic;
}

} // namespace idiophone
