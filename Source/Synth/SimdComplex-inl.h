// SPDX-License-Identifier: Apache-2.0
// The SIMD kernels share this file, which is compiled for each instruction set: vector types,
// complex numbers in lanes, and conversions between double states and single-precision sums.
// Include it after foreach_target.h.
#if defined(IDIOPHONE_SIMD_COMPLEX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef IDIOPHONE_SIMD_COMPLEX_INL_H
#undef IDIOPHONE_SIMD_COMPLEX_INL_H
#else
#define IDIOPHONE_SIMD_COMPLEX_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Doubles = hn::RepartitionToWide<Floats>;
using HalfFloats = hn::Half<Floats>;

template <class Vector>
struct ComplexOf {
    // Gcc compiles implicit constructors without the instructions of HWY_BEFORE_NAMESPACE.
    HWY_INLINE ComplexOf() {}
    HWY_INLINE ComplexOf(Vector real, Vector imaginary) : re(real), im(imaginary) {}

    Vector re, im;
};
using FloatComplex = ComplexOf<hn::Vec<Floats>>;
using DoubleComplex = ComplexOf<hn::Vec<Doubles>>;

template <class Vector>
HWY_INLINE ComplexOf<Vector> product(ComplexOf<Vector> a, ComplexOf<Vector> b) {
    return {hn::NegMulAdd(a.im, b.im, hn::Mul(a.re, b.re)),
            hn::MulAdd(a.im, b.re, hn::Mul(a.re, b.im))};
}

[[maybe_unused]] HWY_INLINE hn::Vec<Floats> demoted(const double* HWY_RESTRICT values) {
    const Floats f;
    const Doubles d;
    const HalfFloats half;
    return hn::Combine(f, hn::DemoteTo(half, hn::Load(d, values + hn::MaxLanes(d))),
                       hn::DemoteTo(half, hn::Load(d, values)));
}

/// Adds to the states and returns the sums in single precision.
[[maybe_unused]] HWY_INLINE hn::Vec<Floats> addTo(double* HWY_RESTRICT values,
                                                  hn::Vec<Floats> added) {
    const Floats f;
    const Doubles d;
    const HalfFloats half;
    double* upper = values + hn::MaxLanes(d);
    const auto low = hn::Add(hn::Load(d, values), hn::PromoteTo(d, hn::LowerHalf(half, added)));
    const auto high = hn::Add(hn::Load(d, upper), hn::PromoteTo(d, hn::UpperHalf(half, added)));
    hn::Store(low, d, values);
    hn::Store(high, d, upper);
    return hn::Combine(f, hn::DemoteTo(half, high), hn::DemoteTo(half, low));
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#endif
