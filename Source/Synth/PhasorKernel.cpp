// SPDX-License-Identifier: Apache-2.0
#include "Synth/PhasorKernel.h"

#include "Object/RadiationTable.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/PhasorKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include "Synth/SimdComplex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE hn::Vec<Floats> sizeOf(FloatComplex value) {
    return hn::Sqrt(hn::Add(hn::Mul(value.re, value.re), hn::Mul(value.im, value.im)));
}

std::size_t wholeVectors(const float* HWY_RESTRICT from,
                         const float* HWY_RESTRICT to,
                         float share,
                         std::size_t count,
                         float* HWY_RESTRICT phasors) {
    const Floats f;
    constexpr std::size_t lanes = hn::MaxLanes(Floats());
    const auto ofTo = hn::Set(f, share), ofFrom = hn::Set(f, 1 - share);
    const auto between = [&](auto a, auto b)
                             HWY_ATTR { return hn::Add(a, hn::Mul(ofTo, hn::Sub(b, a))); };
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        FloatComplex a, b;
        hn::LoadInterleaved2(f, from + 2 * i, a.re, a.im);
        hn::LoadInterleaved2(f, to + 2 * i, b.re, b.im);
        const auto fromSize = sizeOf(a), toSize = sizeOf(b);
        const auto perFrom = hn::Div(ofFrom, fromSize), perTo = hn::Div(ofTo, toSize);
        const FloatComplex turned{hn::Add(hn::Mul(perFrom, a.re), hn::Mul(perTo, b.re)),
                                  hn::Add(hn::Mul(perFrom, a.im), hn::Mul(perTo, b.im))};
        const auto length = sizeOf(turned);
        const auto turns = hn::Gt(length, hn::Set(f, 1e-6f));
        const auto scale =
            hn::Div(between(fromSize, toSize), hn::IfThenElse(turns, length, toSize));
        const auto isLine =
            hn::Not(hn::And(hn::Gt(fromSize, hn::Zero(f)), hn::Gt(toSize, hn::Zero(f))));
        const auto result = [&](auto ofA, auto ofB, auto ofTurned) HWY_ATTR {
            return hn::IfThenElse(isLine, between(ofA, ofB),
                                  hn::Mul(scale, hn::IfThenElse(turns, ofTurned, ofB)));
        };
        hn::StoreInterleaved2(result(a.re, b.re, turned.re), result(a.im, b.im, turned.im), f,
                              phasors + 2 * i);
    }
    return i;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(wholeVectors);

void phasorsBetween(const std::complex<float>* from,
                    const std::complex<float>* to,
                    float share,
                    std::span<std::complex<float>> phasors) noexcept {
    std::size_t i = HWY_DYNAMIC_DISPATCH(wholeVectors)(
        reinterpret_cast<const float*>(from), reinterpret_cast<const float*>(to), share,
        phasors.size(), reinterpret_cast<float*>(phasors.data()));
    for (; i < phasors.size(); ++i)
        phasors[i] = phasorBetween(from[i], to[i], share);
}

} // namespace idiophone
#endif
