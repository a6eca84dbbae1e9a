// SPDX-License-Identifier: Apache-2.0
// Complex multiplication for inner loops.
#pragma once

#include <complex>

namespace idiophone {

/// The product without std::complex's handling of infinities, which costs several times as much.
inline std::complex<double> product(std::complex<double> a, std::complex<double> b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

} // namespace idiophone
