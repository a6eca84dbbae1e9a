#include "Synth/PoleKernel.h"

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

/// Sets table entries far below rounding to zero, so that no product is denormal.
HWY_INLINE Vector cleared(Vector value) {
    const Doubles d;
    return hn::IfThenElseZero(hn::Gt(hn::Abs(value), hn::Set(d, faintestTableEntry)), value);
}

void rotations(PoleArrays& poles, std::size_t count, double sampleSeconds) {
    const Doubles d;
    const hn::Rebind<float, Doubles> f;
    alignas(64) double re[subBlockSamples][lanes];
    alignas(64) double im[subBlockSamples][lanes];
    for (std::size_t g = 0; g < count; g += lanes) {
        const auto stiffness = hn::Load(d, poles.stiffness.data() + g);
        const auto decay = hn::Mul(hn::Load(d, poles.damping.data() + g), hn::Set(d, 0.5));
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

        const Complex sample = rotation(decay, frequency, sampleSeconds);
        hn::Store(hn::DemoteTo(f, sample.re), f, poles.sampleRe.data() + g);
        hn::Store(hn::DemoteTo(f, sample.im), f, poles.sampleIm.data() + g);
        Complex power{hn::Set(d, 1.0), hn::Zero(d)};
        for (std::size_t k = 0; k < subBlockSamples; ++k) {
            hn::Store(cleared(power.re), d, re[k]);
            hn::Store(hn::Neg(cleared(power.im)), d, im[k]);
            power = product(power, sample);
        }
        hn::Store(hn::DemoteTo(f, power.re), f, poles.subBlockRe.data() + g);
        hn::Store(hn::DemoteTo(f, power.im), f, poles.subBlockIm.data() + g);
        const Complex two = product(power, power);
        const Complex four = product(two, two);
        hn::Store(four.re, d, poles.cellRe.data() + g);
        hn::Store(four.im, d, poles.cellIm.data() + g);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            float* HWY_RESTRICT table = poles.tables.data() + 2 * subBlockSamples * (g + lane);
            for (std::size_t k = 0; k < subBlockSamples; ++k) {
                table[k] = static_cast<float>(re[k][lane]);
                table[subBlockSamples + k] = static_cast<float>(im[k][lane]);
            }
        }
    }
}

void rotate(const PoleArrays& poles,
            std::size_t first,
            std::size_t count,
            double seconds,
            double factor,
            double* HWY_RESTRICT x,
            double* HWY_RESTRICT y) {
    const Doubles d;
    const auto gain = hn::Set(d, factor);
    const double* HWY_RESTRICT decay = poles.decay.data() + first;
    const double* HWY_RESTRICT frequency = poles.frequency.data() + first;
    for (std::size_t g = 0; g < count; g += lanes) {
        const Complex motion =
            rotation(hn::Load(d, decay + g), hn::Load(d, frequency + g), seconds);
        const Complex state = product(Complex{hn::Mul(gain, motion.re), hn::Mul(gain, motion.im)},
                                      Complex{hn::Load(d, x + g), hn::Load(d, y + g)});
        hn::Store(state.re, d, x + g);
        hn::Store(state.im, d, y + g);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(rotations);
HWY_EXPORT(rotate);

void rotationsOfPoles(PoleArrays& poles, std::size_t count, double sampleSeconds) noexcept {
    HWY_DYNAMIC_DISPATCH(rotations)(poles, count, sampleSeconds);
}

void rotateModes(const PoleArrays& poles,
                 std::size_t first,
                 std::size_t count,
                 double seconds,
                 double factor,
                 double* x,
                 double* y) noexcept {
    HWY_DYNAMIC_DISPATCH(rotate)(poles, first, count, seconds, factor, x, y);
}

} // namespace idiophone
#endif
