// The sound of a flow out of a small place.
#pragma once

#include "Analysis/Air.h"

#include <array>
#include <complex>
#include <cstddef>
#include <numbers>

namespace idiophone {

/// Returns the far pressure times distance in one direction, in Pa·m, of a flow of 1 m³/s. The
/// place is relative to the origin of the phase. `direction` is a unit vector to the listener.
inline std::complex<double> monopole(double omega,
                                     const std::array<float, 3>& direction,
                                     const std::array<double, 3>& placeMetres) {
    double along = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        along += static_cast<double>(direction[axis]) * placeMetres[axis];
    return std::complex(0.0, omega * airDensityKgPerM3) / (4 * std::numbers::pi) *
           std::polar(1.0, omega / speedOfSoundMetresPerSecond * along);
}

} // namespace idiophone
