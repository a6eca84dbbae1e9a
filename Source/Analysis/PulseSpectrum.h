// The low-pass effect of a contact's length on the modes.
#pragma once

#include <cmath>
#include <numbers>

namespace idiophone {

/// |F(f)| of the pulse (1 − cos 2πt/T)/T: sin(πx)/(πx(1 − x²)) with x = fT.
inline double pulseSpectrum(double x) {
    if (x < 1e-6)
        return 1;
    if (std::abs(x - 1) < 1e-6)
        return 0.5;
    constexpr double pi = std::numbers::pi;
    return std::abs(std::sin(pi * x) / (pi * x * (1 - x * x)));
}

} // namespace idiophone
