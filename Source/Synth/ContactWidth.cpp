// SPDX-License-Identifier: Apache-2.0
#include "Synth/ContactWidth.h"

#include <cmath>

namespace idiophone {

void ContactWidth::average(double softestRadians, std::span<float, cellSamples> newtons) noexcept {
    const double share = -std::expm1(-cornerRatio * softestRadians);
    for (float& newton : newtons) {
        double passed = static_cast<double>(newton);
        for (double& state : states)
            passed = state += share * (passed - state);
        newton = static_cast<float>(passed);
    }
}

} // namespace idiophone
