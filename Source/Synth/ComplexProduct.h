// Complex arithmetic written out, for inner loops.
#pragma once

#include <complex>

namespace idiophone {

/// The product without std::complex's care for infinities, which costs several times the product.
inline std::complex<double> product(std::complex<double> a, std::complex<double> b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

} // namespace idiophone
