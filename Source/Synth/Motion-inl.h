// SPDX-License-Identifier: Apache-2.0
// Free motion of modes in single precision over any time, for the kernels of increments and resting
// states. Include it after foreach_target.h.
#if defined(IDIOPHONE_MOTION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef IDIOPHONE_MOTION_INL_H
#undef IDIOPHONE_MOTION_INL_H
#else
#define IDIOPHONE_MOTION_INL_H
#endif

#include "Synth/SimdComplex-inl.h"

#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

/// c0 + z (c1 + z (c2 + …))
template <std::size_t N>
HWY_INLINE hn::Vec<Floats> polynomial(hn::Vec<Floats> z, const float (&coefficients)[N]) {
    const Floats f;
    auto sum = hn::Set(f, coefficients[N - 1]);
#pragma GCC unroll 8
    for (std::size_t k = N - 1; k > 0; --k)
        sum = hn::MulAdd(sum, z, hn::Set(f, coefficients[k - 1]));
    return sum;
}

// Minimax over |u| ≤ 1/2 in z = u²: sin πu / u within 1.4e-8, cos πu within 2.2e-10.
constexpr float sine[] = {3.14159264f, -5.167710091f, 2.550077663f, -0.5982921687f, 0.07765940864f};
constexpr float cosine[] = {0.9999999998f, -4.934802137f, 4.058709165f,
                            -1.335212058f, 0.2349375609f, -0.0243967165f};
// (2^u − 1)/u on the same interval, within 4e-9.
constexpr float powers[] = {0.6931472057f,   0.2402264689f,   0.05550328773f,
                            0.009618488958f, 0.001339993293f, 0.0001534581622f};

/// 2^octaves for −120 ≤ octaves ≤ 0, as whole · (1 + part), which is exact near 1.
struct PowerOfTwo {
    hn::Vec<Floats> whole, part;
};

HWY_INLINE PowerOfTwo powerOfTwo(hn::Vec<Floats> octaves) {
    const Floats f;
    const hn::RebindToSigned<Floats> i;
    const auto bounded = hn::Max(octaves, hn::Set(f, -120.0f));
    const auto nearest = hn::NearestInt(bounded);
    const auto rest = hn::Sub(bounded, hn::ConvertTo(f, nearest));
    const auto one = hn::BitCast(i, hn::Set(f, 1.0f));
    return {hn::BitCast(f, hn::Add(one, hn::ShiftLeft<23>(nearest))),
            hn::Mul(rest, polynomial(rest, powers))};
}

/// Sine and cosine of half the angle ωt, and the remaining amplitude, for any time in single
/// precision.
struct Motion {
    hn::Vec<Floats> sin, cos;
    PowerOfTwo left;
};

HWY_INLINE Motion motion(const PoleArrays& poles, const IncrementMove& move, std::size_t g) {
    const Floats f;
    const Doubles d;
    const HalfFloats half;
    const auto restOfTurn = [&](std::size_t place) HWY_ATTR {
        const auto perTurn = hn::Set(d, move.seconds / (2 * std::numbers::pi));
        const auto turns = hn::Mul(perTurn, hn::Load(d, poles.frequency.data() + place));
        return hn::DemoteTo(half, hn::Sub(turns, hn::Round(turns)));
    };
    const auto u = hn::Combine(f, restOfTurn(g + hn::MaxLanes(d)), restOfTurn(g));
    const auto z = hn::Mul(u, u);
    const auto octaves = hn::MulAdd(hn::Set(f, static_cast<float>(move.samples)),
                                    hn::Load(f, poles.octavesPerSample.data() + g),
                                    hn::Set(f, static_cast<float>(-move.damperOctaves)));
    return {hn::Mul(u, polynomial(z, sine)), polynomial(z, cosine), powerOfTwo(octaves)};
}

/// e^{(−α + iω)t}
HWY_INLINE FloatComplex moved(const Motion& motion) {
    const auto size = hn::MulAdd(motion.left.whole, motion.left.part, motion.left.whole);
    const auto twice = hn::Mul(hn::Add(motion.sin, motion.sin), size);
    return {hn::NegMulAdd(twice, motion.sin, size), hn::Mul(twice, motion.cos)};
}

/// 1 − e^{(−α + iω)t}, precise even if it is small.
HWY_INLINE FloatComplex change(const Motion& motion) {
    const Floats f;
    const auto whole = motion.left.whole;
    const auto size = hn::MulAdd(whole, motion.left.part, whole);
    const auto lost = hn::NegMulAdd(whole, motion.left.part, hn::Sub(hn::Set(f, 1.0f), whole));
    const auto twice = hn::Mul(hn::Add(motion.sin, motion.sin), size);
    return {hn::MulAdd(twice, motion.sin, lost), hn::Neg(hn::Mul(twice, motion.cos))};
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#endif
