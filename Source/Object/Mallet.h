// SPDX-License-Identifier: Apache-2.0
// The list of mallets. It does not know keys, velocities, parameters or contacts.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace idiophone {

struct Mallet {
    std::string_view name = {};
    std::string_view source = {}; ///< source of the figures
    double massKg = 0;
    double headRadiusMetres = 0;
    double effectiveModulusPa = 0; ///< E/(1 − ν²) of the head alone
    double forceExponent = 0;      ///< p of F ∝ d^p: 1.5 for Hertz, more for wound heads
    std::uint32_t colour = 0;      ///< colour of the head in the window, 0xRRGGBB
};

/// Returns the mallets of Resources/Mallets/mallets.json, in the order of the parameter. The span
/// is always valid. Any thread.
std::span<const Mallet> malletRack();

} // namespace idiophone
