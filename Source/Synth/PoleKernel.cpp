// SPDX-License-Identifier: Apache-2.0
#include "Synth/PoleKernel.h"

#include "Synth/ModalPole.h"

#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/PoleKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include <hwy/contrib/math/math-inl.h>

#include "Synth/SimdComplex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

using Vector = hn::Vec<Doubles>;
using Complex = DoubleComplex;
constexpr std::size_t lanes = hn::MaxLanes(Doubles());

/// Returns e^{(−α + iω)t}. The angle is first reduced to half a turn, because the library's sine
/// loses precision beyond.
HWY_INLINE Complex rotation(Vector decay, Vector frequency, double seconds) {
    const Doubles d;
    const auto t = hn::Set(d, seconds);
    constexpr double fullTurn = 2 * std::numbers::pi;
    const auto angle = hn::Mul(frequency, t);
    const auto turns = hn::Round(hn::Mul(angle, hn::Set(d, 1 / fullTurn)));
    const auto rest = hn::NegMulAdd(turns, hn::Set(d, fullTurn), angle);
    const auto size = hn::Exp(d, hn::Max(hn::Neg(hn::Mul(decay, t)), hn::Set(d, -700.0)));
    return {hn::Mul(size, hn::Cos(d, rest)), hn::Mul(size, hn::Sin(d, rest))};
}

/// Half as many floats as fit, so that there are as many as doubles.
using Singles = hn::Rebind<float, Doubles>;
using SingleComplex = ComplexOf<hn::Vec<Singles>>;

/// Sets table entries far below rounding to zero, so that no product is denormal.
HWY_INLINE hn::Vec<Singles> cleared(hn::Vec<Singles> value) {
    const Singles f;
    return hn::IfThenElseZero(
        hn::Gt(hn::Abs(value), hn::Set(f, static_cast<float>(faintestTableEntry))), value);
}

HWY_INLINE SingleComplex demoted(Complex value) {
    const Singles f;
    return {hn::DemoteTo(f, value.re), hn::DemoteTo(f, value.im)};
}

PolesFound coefficients(PoleArrays& poles,
                        std::size_t count,
                        double sampleSeconds,
                        const AudibleBand& band,
                        float* HWY_RESTRICT audibles,
                        double* HWY_RESTRICT resonancesHz) {
    const Doubles d;
    const Singles f;
    PolesFound found;
    const auto lowest = hn::Set(d, stiffnessAt(band.lowestHz));
    const auto highest = hn::Set(d, stiffnessAt(band.highestHz));
    for (std::size_t g = 0; g < count; g += lanes) {
        const auto stiffness = hn::Load(d, poles.stiffness.data() + g);
        const auto damping = hn::Load(d, poles.damping.data() + g);
        const auto decay = hn::Mul(damping, hn::Set(d, 0.5));
        const auto squared = hn::NegMulAdd(decay, decay, stiffness);
        const auto frequency = hn::Sqrt(hn::Max(squared, hn::Zero(d)));
        const auto perFrequency = hn::Div(hn::Set(d, 1.0), frequency);
        hn::Store(decay, d, poles.decay.data() + g);
        hn::Store(frequency, d, poles.frequency.data() + g);
        hn::Store(hn::Mul(decay, perFrequency), d, poles.velocityShare.data() + g);

        const auto halfTurns = hn::Mul(frequency, hn::Set(d, sampleSeconds / std::numbers::pi));
        const auto octaves = hn::Mul(decay, hn::Set(d, -sampleSeconds * std::numbers::log2e));
        hn::Store(hn::DemoteTo(f, halfTurns), f, poles.halfTurnsPerSample.data() + g);
        hn::Store(hn::DemoteTo(f, octaves), f, poles.octavesPerSample.data() + g);

        const auto hz = hn::Mul(frequency, hn::Set(d, 0.5 / std::numbers::pi));
        const auto isAudible = hn::And(hn::Ge(stiffness, lowest), hn::Lt(stiffness, highest));
        hn::Store(hn::DemoteTo(f, hn::IfThenElseZero(isAudible, hn::Set(d, 1.0))), f, audibles + g);
        const auto square = hn::Mul(damping, damping);
        const auto isLight = hn::Lt(square, hn::Mul(hn::Set(d, 4e-4), stiffness));
        found.resonances +=
            hn::CompressStore(hz, hn::And(isAudible, isLight), d, resonancesHz + found.resonances);
        const auto oscillates =
            hn::Lt(square, hn::Mul(hn::Set(d, 4 * oscillatingShare), stiffness));
        found.allOscillate = found.allOscillate && hn::AllTrue(d, oscillates);
    }
    return found;
}

/// Writes entries of one table part for each lane: `values` are those of `lanes` modes, entry by
/// entry.
HWY_INLINE void storeTables(const hn::Vec<Singles> (&values)[subBlockSamples],
                            float* HWY_RESTRICT tables) {
    const Singles f;
    alignas(64) float four[4 * lanes];
    for (std::size_t k = 0; k < subBlockSamples; k += 4) {
        hn::StoreInterleaved4(values[k], values[k + 1], values[k + 2], values[k + 3], f, four);
        for (std::size_t lane = 0; lane < lanes; ++lane)
            hwy::CopyBytes<4 * sizeof(float)>(four + 4 * lane,
                                              tables + 2 * subBlockSamples * lane + k);
    }
}

void rotations(PoleArrays& poles, std::size_t first, std::size_t count, double sampleSeconds) {
    const Doubles d;
    const Singles f;
    for (std::size_t g = first; g < first + count; g += lanes) {
        Complex power = rotation(hn::Load(d, poles.decay.data() + g),
                                 hn::Load(d, poles.frequency.data() + g), sampleSeconds);
        SingleComplex single = demoted(power);
        hn::Store(single.re, f, poles.sampleRe.data() + g);
        hn::Store(single.im, f, poles.sampleIm.data() + g);
        // The entries are products of at most four of ρ, ρ², ρ⁴ and ρ⁸, conjugated.
        hn::Vec<Singles> re[subBlockSamples], im[subBlockSamples];
        re[0] = hn::Set(f, 1.0f);
        im[0] = hn::Zero(f);
#pragma GCC unroll 4
        for (std::size_t half = 1; half < subBlockSamples; half *= 2) {
#pragma GCC unroll 8
            for (std::size_t k = 0; k < half; ++k) {
                const SingleComplex entry = product(SingleComplex{single.re, hn::Neg(single.im)},
                                                    SingleComplex{re[k], im[k]});
                re[half + k] = entry.re;
                im[half + k] = entry.im;
            }
            power = product(power, power);
            single = demoted(power);
        }
        hn::Store(single.re, f, poles.subBlockRe.data() + g);
        hn::Store(single.im, f, poles.subBlockIm.data() + g);
        const auto fallen = hn::MulAdd(single.re, single.re, hn::Mul(single.im, single.im));
        if (!hn::AllTrue(f, hn::Gt(fallen, hn::Set(f, 1e-12f))))
            for (auto* part : {re, im})
                for (std::size_t k = 0; k < subBlockSamples; ++k)
                    part[k] = cleared(part[k]);
        storeTables(re, poles.tables.data() + 2 * subBlockSamples * g);
        storeTables(im, poles.tables.data() + 2 * subBlockSamples * g + subBlockSamples);
        const Complex two = product(power, power);
        const Complex four = product(two, two);
        hn::Store(four.re, d, poles.cellRe.data() + g);
        hn::Store(four.im, d, poles.cellIm.data() + g);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(coefficients);
HWY_EXPORT(rotations);

PolesFound coefficientsOfPoles(PoleArrays& poles,
                               std::size_t count,
                               double sampleSeconds,
                               const AudibleBand& band,
                               float* audibles,
                               double* resonancesHz) noexcept {
    return HWY_DYNAMIC_DISPATCH(coefficients)(poles, count, sampleSeconds, band, audibles,
                                              resonancesHz);
}

void rotationsOfPoles(PoleArrays& poles,
                      std::size_t first,
                      std::size_t count,
                      double sampleSeconds) noexcept {
    HWY_DYNAMIC_DISPATCH(rotations)(poles, first, count, sampleSeconds);
}

} // namespace idiophone
#endif
