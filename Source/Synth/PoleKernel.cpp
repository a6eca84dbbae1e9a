#include "Synth/PoleKernel.h"

#include "Synth/ModalBankKernel.h"

#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/PoleKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using Floats = hn::CappedTag<float, 16>;
using HalfFloats = hn::Half<Floats>;
using Vector = hn::Vec<Doubles>;
constexpr std::size_t lanes = hn::MaxLanes(Doubles());

struct Complex {
    Vector re, im;
};

HWY_INLINE Complex product(Complex a, Complex b) {
    return {hn::NegMulAdd(a.im, b.im, hn::Mul(a.re, b.re)),
            hn::MulAdd(a.im, b.re, hn::Mul(a.re, b.im))};
}

/// e^{(−α + iω)t}. The angle is first taken to within half a turn, beyond which the library's sine
/// loses precision.
HWY_INLINE Complex rotation(Vector decay, Vector frequency, double seconds) {
    const Doubles d;
    const auto t = hn::Set(d, seconds);
    constexpr double turn = 2 * std::numbers::pi;
    const auto angle = hn::Mul(frequency, t);
    const auto turns = hn::Round(hn::Mul(angle, hn::Set(d, 1 / turn)));
    const auto rest = hn::NegMulAdd(turns, hn::Set(d, turn), angle);
    const auto size = hn::Exp(d, hn::Max(hn::Neg(hn::Mul(decay, t)), hn::Set(d, -700.0)));
    return {hn::Mul(size, hn::Cos(d, rest)), hn::Mul(size, hn::Sin(d, rest))};
}

/// Table entries far below rounding become zero, so that no product is denormal.
HWY_INLINE Vector cleared(Vector value) {
    const Doubles d;
    return hn::IfThenElseZero(hn::Gt(hn::Abs(value), hn::Set(d, 1e-15)), value);
}

void rotations(const PoleArrays& arrays, std::size_t count, double sampleSeconds) {
    const Doubles d;
    const hn::Rebind<float, Doubles> f;
    alignas(64) double re[subBlockSamples][lanes];
    alignas(64) double im[subBlockSamples][lanes];
    for (std::size_t g = 0; g < count; g += lanes) {
        const auto stiffness = hn::Load(d, arrays.stiffness + g);
        const auto decay = hn::Mul(hn::Load(d, arrays.damping + g), hn::Set(d, 0.5));
        const auto squared = hn::NegMulAdd(decay, decay, stiffness);
        const auto frequency = hn::Sqrt(hn::Max(squared, hn::Zero(d)));
        const auto perFrequency = hn::Div(hn::Set(d, 1.0), frequency);
        hn::Store(decay, d, arrays.decay + g);
        hn::Store(frequency, d, arrays.frequency + g);
        hn::Store(hn::Mul(stiffness, perFrequency), d, arrays.displacementShare + g);
        hn::Store(hn::Mul(decay, perFrequency), d, arrays.velocityShare + g);

        const Complex sample = rotation(decay, frequency, sampleSeconds);
        hn::Store(hn::DemoteTo(f, sample.re), f, arrays.sampleRe + g);
        hn::Store(hn::DemoteTo(f, sample.im), f, arrays.sampleIm + g);
        Complex power{hn::Set(d, 1.0), hn::Zero(d)};
        for (std::size_t k = 0; k < subBlockSamples; ++k) {
            hn::Store(cleared(power.re), d, re[k]);
            hn::Store(hn::Neg(cleared(power.im)), d, im[k]);
            power = product(power, sample);
        }
        hn::Store(hn::DemoteTo(f, power.re), f, arrays.turnRe + g);
        hn::Store(hn::DemoteTo(f, power.im), f, arrays.turnIm + g);
        const Complex two = product(power, power);
        const Complex four = product(two, two);
        hn::Store(four.re, d, arrays.cellRe + g);
        hn::Store(four.im, d, arrays.cellIm + g);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            float* HWY_RESTRICT table = arrays.tables + 2 * subBlockSamples * (g + lane);
            for (std::size_t k = 0; k < subBlockSamples; ++k) {
                table[k] = static_cast<float>(re[k][lane]);
                table[subBlockSamples + k] = static_cast<float>(im[k][lane]);
            }
        }
    }
}

void rotate(const double* HWY_RESTRICT decay,
            const double* HWY_RESTRICT frequency,
            std::size_t count,
            double seconds,
            double factor,
            double* HWY_RESTRICT x,
            double* HWY_RESTRICT y) {
    const Doubles d;
    const auto gain = hn::Set(d, factor);
    for (std::size_t g = 0; g < count; g += lanes) {
        const Complex turn = rotation(hn::Load(d, decay + g), hn::Load(d, frequency + g), seconds);
        const Complex state = product({hn::Mul(gain, turn.re), hn::Mul(gain, turn.im)},
                                      {hn::Load(d, x + g), hn::Load(d, y + g)});
        hn::Store(state.re, d, x + g);
        hn::Store(state.im, d, y + g);
    }
}

void turn(const double* HWY_RESTRICT decay,
          const double* HWY_RESTRICT frequency,
          std::size_t count,
          double seconds,
          double factor,
          double* HWY_RESTRICT x,
          double* HWY_RESTRICT y) {
    const Floats f;
    const HalfFloats half;
    const hn::RepartitionToWide<Floats> d;
    constexpr std::size_t wide = hn::MaxLanes(d);
    const auto time = hn::Set(d, seconds);
    const auto gain = hn::Set(f, static_cast<float>(factor));
    for (std::size_t g = 0; g < count; g += hn::MaxLanes(f)) {
        const auto scaled = [&](const double* values) HWY_ATTR {
            return hn::Combine(f, hn::DemoteTo(half, hn::Mul(time, hn::Load(d, values + g + wide))),
                               hn::DemoteTo(half, hn::Mul(time, hn::Load(d, values + g))));
        };
        const auto angle = scaled(frequency);
        const auto fall = hn::Max(hn::Neg(scaled(decay)), hn::Set(f, -80.0f));
        const auto size = hn::Mul(gain, hn::Exp(f, fall));
        const auto re = hn::Mul(size, hn::Cos(f, angle));
        const auto im = hn::Mul(size, hn::Sin(f, angle));
        const auto moved = [&](auto reHalf, auto imHalf, std::size_t place) HWY_ATTR {
            const auto turnRe = hn::PromoteTo(d, reHalf);
            const auto turnIm = hn::PromoteTo(d, imHalf);
            const auto xs = hn::Load(d, x + place);
            const auto ys = hn::Load(d, y + place);
            hn::Store(hn::NegMulAdd(turnIm, ys, hn::Mul(turnRe, xs)), d, x + place);
            hn::Store(hn::MulAdd(turnIm, xs, hn::Mul(turnRe, ys)), d, y + place);
        };
        moved(hn::LowerHalf(half, re), hn::LowerHalf(half, im), g);
        moved(hn::UpperHalf(half, re), hn::UpperHalf(half, im), g + wide);
    }
}

struct FloatComplex {
    hn::Vec<Floats> re, im;
};

HWY_INLINE FloatComplex product(FloatComplex a, FloatComplex b) {
    return {hn::NegMulAdd(a.im, b.im, hn::Mul(a.re, b.re)),
            hn::MulAdd(a.im, b.re, hn::Mul(a.re, b.im))};
}

void addMoved(const SampleRotations& rotations,
              std::size_t count,
              std::size_t samples,
              double factor,
              const double* HWY_RESTRICT x,
              const double* HWY_RESTRICT y,
              double* HWY_RESTRICT sumX,
              double* HWY_RESTRICT sumY) {
    const Floats f;
    const HalfFloats half;
    const hn::RepartitionToWide<Floats> d;
    for (std::size_t g = 0; g < count; g += hn::MaxLanes(f)) {
        FloatComplex move{hn::Set(f, static_cast<float>(factor)), hn::Zero(f)};
        const FloatComplex turn{hn::Load(f, rotations.turnRe + g),
                                hn::Load(f, rotations.turnIm + g)};
        for (std::size_t turns = samples / subBlockSamples; turns > 0; --turns)
            move = product(move, turn);
        FloatComplex power{hn::Load(f, rotations.sampleRe + g),
                           hn::Load(f, rotations.sampleIm + g)};
        for (std::size_t rest = samples % subBlockSamples; rest > 0; rest /= 2) {
            if (rest % 2 == 1)
                move = product(move, power);
            power = product(power, power);
        }
        const auto add = [&](auto re, auto im, std::size_t place) HWY_ATTR {
            const auto moveRe = hn::PromoteTo(d, re);
            const auto moveIm = hn::PromoteTo(d, im);
            const auto xs = hn::Load(d, x + place);
            const auto ys = hn::Load(d, y + place);
            const auto toX =
                hn::NegMulAdd(moveIm, ys, hn::MulAdd(moveRe, xs, hn::Load(d, sumX + place)));
            const auto toY =
                hn::MulAdd(moveIm, xs, hn::MulAdd(moveRe, ys, hn::Load(d, sumY + place)));
            hn::Store(toX, d, sumX + place);
            hn::Store(toY, d, sumY + place);
        };
        add(hn::LowerHalf(half, move.re), hn::LowerHalf(half, move.im), g);
        add(hn::UpperHalf(half, move.re), hn::UpperHalf(half, move.im), g + hn::MaxLanes(d));
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
HWY_EXPORT(turn);
HWY_EXPORT(addMoved);

void rotationsOfPoles(const PoleArrays& arrays, std::size_t count, double sampleSeconds) noexcept {
    HWY_DYNAMIC_DISPATCH(rotations)(arrays, count, sampleSeconds);
}

void rotateModes(const double* decay,
                 const double* frequency,
                 std::size_t count,
                 double seconds,
                 double factor,
                 double* x,
                 double* y) noexcept {
    HWY_DYNAMIC_DISPATCH(rotate)(decay, frequency, count, seconds, factor, x, y);
}

void turnModes(const double* decay,
               const double* frequency,
               std::size_t count,
               double seconds,
               double factor,
               double* x,
               double* y) noexcept {
    HWY_DYNAMIC_DISPATCH(turn)(decay, frequency, count, seconds, factor, x, y);
}

void addMovedModes(const SampleRotations& rotations,
                   std::size_t count,
                   std::size_t samples,
                   double factor,
                   const double* x,
                   const double* y,
                   double* sumX,
                   double* sumY) noexcept {
    HWY_DYNAMIC_DISPATCH(addMoved)(rotations, count, samples, factor, x, y, sumX, sumY);
}

} // namespace idiophone
#endif
