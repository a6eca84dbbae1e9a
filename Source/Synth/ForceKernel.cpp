#include "Synth/ForceKernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/ForceKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Doubles = hn::RepartitionToWide<Floats>;
using HalfFloats = hn::Half<Floats>;
using Vector = hn::Vec<Floats>;

struct Complex {
    Vector re, im;
};

HWY_INLINE Complex product(Complex a, Complex b) {
    return {hn::NegMulAdd(a.im, b.im, hn::Mul(a.re, b.re)),
            hn::MulAdd(a.im, b.re, hn::Mul(a.re, b.im))};
}

HWY_INLINE Vector demoted(const double* values) {
    const Floats f;
    const Doubles d;
    const HalfFloats half;
    return hn::Combine(f, hn::DemoteTo(half, hn::Load(d, values + hn::MaxLanes(d))),
                       hn::DemoteTo(half, hn::Load(d, values)));
}

HWY_INLINE void addTo(double* values, Vector sum) {
    const Doubles d;
    const HalfFloats half;
    double* upper = values + hn::MaxLanes(d);
    hn::Store(hn::Add(hn::Load(d, values), hn::PromoteTo(d, hn::LowerHalf(half, sum))), d, values);
    hn::Store(hn::Add(hn::Load(d, upper), hn::PromoteTo(d, hn::UpperHalf(half, sum))), d, upper);
}

/// Σ_j ρ^(15 − j) f[j] over a sub-block, four samples a step of Horner's rule: a product with a
/// real number costs half of one with a complex number.
HWY_INLINE Complex subBlockSum(const float* HWY_RESTRICT impulses, const Complex (&power)[5]) {
    const Floats f;
    Complex sum{hn::Zero(f), hn::Zero(f)};
#pragma GCC unroll 4
    for (std::size_t k = 0; k < subBlockSamples; k += 4) {
        const auto first = hn::Set(f, impulses[k]);
        const auto second = hn::Set(f, impulses[k + 1]);
        const auto third = hn::Set(f, impulses[k + 2]);
        auto re = hn::MulAdd(first, power[3].re, hn::Set(f, impulses[k + 3]));
        auto im = hn::Mul(first, power[3].im);
        re = hn::MulAdd(second, power[2].re, re);
        im = hn::MulAdd(second, power[2].im, im);
        re = hn::MulAdd(third, power[1].re, re);
        im = hn::MulAdd(third, power[1].im, im);
        re = hn::MulAdd(sum.re, power[4].re, re);
        im = hn::MulAdd(sum.re, power[4].im, im);
        sum = {hn::NegMulAdd(sum.im, power[4].im, re), hn::MulAdd(sum.im, power[4].re, im)};
    }
    return sum;
}

void force(const ForcedModes& modes,
           const float* HWY_RESTRICT impulses,
           float fall,
           std::size_t count,
           double* HWY_RESTRICT x,
           double* HWY_RESTRICT y) {
    const Floats f;
    const auto damper = hn::Set(f, fall);
    for (std::size_t g = 0; g < count; g += hn::MaxLanes(f)) {
        Complex power[5];
        power[1] = {hn::Mul(damper, hn::Load(f, modes.sampleRe + g)),
                    hn::Mul(damper, hn::Load(f, modes.sampleIm + g))};
        power[2] = product(power[1], power[1]);
        power[3] = product(power[2], power[1]);
        power[4] = product(power[2], power[2]);
        const Complex eight = product(power[4], power[4]);
        const Complex turn = product(eight, eight);
        const auto start = hn::Load(f, modes.startResidues + g);
        const auto way = hn::Sub(hn::Load(f, modes.endResidues + g), start);

        Complex sum{hn::Zero(f), hn::Zero(f)};
#pragma GCC unroll 4
        for (std::size_t b = 0; b < subBlocks; ++b) {
            const Complex here = subBlockSum(impulses + b * subBlockSamples, power);
            const auto residue = hn::MulAdd(way, hn::Set(f, shareOfWay(b)), start);
            sum = product(sum, turn);
            sum = {hn::MulAdd(residue, here.re, sum.re), hn::MulAdd(residue, here.im, sum.im)};
        }
        sum = product(sum, power[1]);
        const auto share = demoted(modes.velocityShare + g);
        addTo(x + g, hn::NegMulAdd(share, sum.im, sum.re));
        addTo(y + g, hn::MulAdd(share, sum.re, sum.im));
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(force);

void forceModes(const ForcedModes& modes,
                const float* impulses,
                float fall,
                std::size_t count,
                double* x,
                double* y) noexcept {
    HWY_DYNAMIC_DISPATCH(force)(modes, impulses, fall, count, x, y);
}

} // namespace idiophone
#endif
