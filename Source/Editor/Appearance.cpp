#include "Editor/Appearance.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace idiophone {
namespace {

constexpr double comparedHz = 1000; ///< frequency at which damping is compared

/// A distance that makes kinds compact: density separates metals and woods best.
double squaredDistance(const Material& a, const Material& b) {
    const auto decay = [](const Material& material) {
        constexpr double shortest = 1e-3, longest = 100; // seconds
        return std::log10(std::clamp(decaySeconds(material, comparedHz), shortest, longest));
    };
    const double stiffness = std::log10(a.youngsModulusPa / b.youngsModulusPa);
    const double density = 2 * std::log10(a.densityKgPerM3 / b.densityKgPerM3);
    const double ringing = 0.4 * (decay(a) - decay(b));
    return stiffness * stiffness + density * density + ringing * ringing;
}

MaterialKind kindOf(const Material& libraryMaterial) {
    return *materialKind(libraryMaterial.name);
}

std::array<float, 3> colourOf(const Material& libraryMaterial) {
    return channelsOf(*materialColour(libraryMaterial.name));
}

} // namespace

std::array<float, 3> channelsOf(std::uint32_t colour) {
    const auto channel = [&](int shift) {
        return static_cast<float>((colour >> shift) & 0xff) / 255;
    };
    return {channel(16), channel(8), channel(0)};
}

Appearance appearanceOf(const Material& material) {
    if (const auto* known = findMaterial(material.name))
        return {static_cast<Finish>(kindOf(*known)), colourOf(*known)};
    const auto library = materialLibrary();
    const auto kind = material.grain
                          ? MaterialKind::wood
                          : kindOf(*std::ranges::min_element(library, {}, [&](const auto& known) {
                                return squaredDistance(material, known);
                            }));
    constexpr double closest = 1e-6; // avoids division by zero
    double sum = 0;
    std::array<double, 3> mixed{};
    for (const auto& known : library) {
        if (kindOf(known) != kind)
            continue;
        const double weight = 1 / std::pow(closest + squaredDistance(material, known), 2);
        const auto colour = colourOf(known);
        sum += weight;
        for (std::size_t channel = 0; channel < mixed.size(); ++channel)
            mixed[channel] += weight * double(colour[channel]);
    }
    Appearance result{.finish = static_cast<Finish>(kind)};
    for (std::size_t channel = 0; channel < mixed.size(); ++channel)
        result.colour[channel] = static_cast<float>(mixed[channel] / sum);
    return result;
}

} // namespace idiophone
