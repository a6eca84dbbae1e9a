// How the chosen mallet's head looks.
#pragma once

#include "Editor/Appearance.h"
#include "Editor/ProcessorView.h"
#include "Object/Mallet.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

/// Yarn is wound, brass is metal, and rubber and plastic are plain.
inline Appearance appearanceOf(const Mallet& mallet) {
    constexpr double windingExponent = 2, metalPascals = 1e10;
    const auto finish = mallet.forceExponent > windingExponent     ? Finish::cloth
                        : mallet.effectiveModulusPa > metalPascals ? Finish::metal
                        : mallet.name == "Wood"                    ? Finish::wood
                                                                   : Finish::plastic;
    return {finish, channelsOf(mallet.colour)};
}

/// The appearance of the chosen mallet; of the custom one, that of the nearest by hardness.
inline Appearance malletAppearance(const ProcessorView& view) {
    const auto rack = malletRack();
    const auto choice = static_cast<int>(view.parameters.value(ParameterId::mallet));
    const auto named = static_cast<std::size_t>(choice - firstRackMallet);
    if (choice >= firstRackMallet && named < rack.size())
        return appearanceOf(rack[named]);
    const double modulus = view.parameters.effectiveValue(ParameterId::malletHardness) * 1e6;
    return appearanceOf(*std::ranges::min_element(rack, {}, [&](const Mallet& mallet) {
        return std::abs(std::log(mallet.effectiveModulusPa / modulus));
    }));
}

} // namespace idiophone
