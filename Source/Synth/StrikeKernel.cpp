#include "Synth/StrikeKernel.h"

#include <complex>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/StrikeKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Doubles = hn::CappedTag<double, 8>;

HWY_INLINE hn::Vec<Floats> dot(hn::Vec<Floats> x,
                               hn::Vec<Floats> y,
                               hn::Vec<Floats> z,
                               const std::array<float, 3>& direction) {
    const Floats f;
    auto along = hn::Mul(x, hn::Set(f, direction[0]));
    along = hn::MulAdd(y, hn::Set(f, direction[1]), along);
    return hn::MulAdd(z, hn::Set(f, direction[2]), along);
}

void project(const ShapePoint& point,
             const std::array<float, 3>& struck,
             const std::array<float, 3>& heard,
             std::size_t count,
             float* HWY_RESTRICT struckGains,
             float* HWY_RESTRICT heardGains) {
    const Floats f;
    constexpr std::size_t lanes = hn::MaxLanes(Floats());
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        auto struckGain = hn::Zero(f);
        auto heardGain = hn::Zero(f);
        for (std::size_t k = 0; k < point.used; ++k) {
            hn::Vec<Floats> x, y, z;
            hn::LoadInterleaved3(f, point.rows[k] + 3 * i, x, y, z);
            const auto weight = hn::Set(f, point.weights[k]);
            struckGain = hn::MulAdd(dot(x, y, z, struck), weight, struckGain);
            heardGain = hn::MulAdd(dot(x, y, z, heard), weight, heardGain);
        }
        hn::StoreU(struckGain, f, struckGains + i);
        hn::StoreU(heardGain, f, heardGains + i);
    }
    for (; i < count; ++i) {
        struckGains[i] = heardGains[i] = 0;
        for (std::size_t k = 0; k < point.used; ++k) {
            const float* shape = point.rows[k] + 3 * i;
            const auto along = [&](const std::array<float, 3>& direction) {
                return shape[0] * direction[0] + shape[1] * direction[1] + shape[2] * direction[2];
            };
            struckGains[i] += point.weights[k] * along(struck);
            heardGains[i] += point.weights[k] * along(heard);
        }
    }
}

// The same closed form as ForcedResponse, which says why it is written so.
void forced(const PulseInstant& pulse, const ForcedArrays& arrays, std::size_t count) {
    const Doubles d;
    const double rate = 1 / pulse.contactSeconds;
    const double angular = 2 * std::numbers::pi * rate;
    const double damper = pulse.dampingPerSecond;
    const auto contactRate = hn::Set(d, rate);
    const auto omega = hn::Set(d, angular);
    const auto omegaSquared = hn::Set(d, angular * angular);
    const auto delta = hn::Set(d, damper);
    const auto phaseRe = hn::Set(d, pulse.phase.real());
    const auto phaseIm = hn::Set(d, pulse.phase.imag());
    const auto restRe = hn::Set(d, 1 - pulse.phase.real());
    for (std::size_t g = 0; g < count; g += hn::MaxLanes(d)) {
        const auto stiffness = hn::Load(d, arrays.stiffness + g);
        const auto damping = hn::Load(d, arrays.damping + g);
        const auto drag = hn::Mul(delta, hn::Add(delta, damping));
        const auto constant = hn::Add(drag, stiffness); // P(δ)
        const auto re = hn::Add(drag, hn::Sub(stiffness, omegaSquared));
        const auto im = hn::Mul(omega, hn::Add(hn::Add(delta, delta), damping));
        const auto inverse =
            hn::Div(contactRate, hn::MulAdd(re, re, hn::Mul(im, im))); // 1/(T |P(δ + iΩ)|²)
        const auto swingRe = hn::Neg(hn::Mul(inverse, hn::MulAdd(delta, re, hn::Mul(omega, im))));
        const auto swingIm = hn::Mul(inverse, hn::MulSub(delta, im, hn::Mul(omega, re)));
        const auto perConstant = hn::Div(hn::Set(d, 1.0), constant);
        const auto steady = hn::Mul(hn::Mul(contactRate, delta), perConstant);
        hn::Store(steady, d, arrays.steady + g);
        hn::Store(swingRe, d, arrays.swingRe + g);
        hn::Store(swingIm, d, arrays.swingIm + g);

        const auto velocity =
            hn::Add(steady, hn::NegMulAdd(swingIm, phaseIm, hn::Mul(swingRe, phaseRe)));
        const auto numeratorRe = hn::MulSub(constant, restRe, omegaSquared);
        const auto numeratorIm = hn::NegMulAdd(constant, phaseIm, im);
        const auto displacement = hn::Mul(hn::Mul(inverse, perConstant),
                                          hn::MulAdd(numeratorRe, re, hn::Mul(numeratorIm, im)));
        hn::Store(velocity, d, arrays.x + g);
        hn::Store(hn::MulAdd(hn::Load(d, arrays.displacementShare + g), displacement,
                             hn::Mul(hn::Load(d, arrays.velocityShare + g), velocity)),
                  d, arrays.y + g);
    }
}

void sum(const double* HWY_RESTRICT residues,
         const ForcedAmplitudes& arrays,
         std::size_t first,
         std::size_t count,
         ForcedSum& total) {
    const Doubles d;
    auto steady = hn::Zero(d);
    auto swingRe = hn::Zero(d);
    auto swingIm = hn::Zero(d);
    const std::size_t end = first + count;
    std::size_t g = first;
    for (; g + hn::MaxLanes(d) <= end; g += hn::MaxLanes(d)) {
        const auto residue = hn::LoadU(d, residues + g);
        steady = hn::MulAdd(residue, hn::LoadU(d, arrays.steady + g), steady);
        swingRe = hn::MulAdd(residue, hn::LoadU(d, arrays.swingRe + g), swingRe);
        swingIm = hn::MulAdd(residue, hn::LoadU(d, arrays.swingIm + g), swingIm);
    }
    total.steady += hn::GetLane(hn::SumOfLanes(d, steady));
    total.swing += std::complex<double>(hn::GetLane(hn::SumOfLanes(d, swingRe)),
                                        hn::GetLane(hn::SumOfLanes(d, swingIm)));
    for (; g < end; ++g) {
        total.steady += residues[g] * arrays.steady[g];
        total.swing += residues[g] * std::complex<double>(arrays.swingRe[g], arrays.swingIm[g]);
    }
}

void cosine(double steady,
            std::complex<double> swing,
            double radiansPerSample,
            std::size_t count,
            float* HWY_RESTRICT output) {
    const Doubles d;
    const hn::Rebind<float, Doubles> f;
    constexpr std::size_t lanes = hn::MaxLanes(d);
    alignas(64) double startRe[lanes];
    alignas(64) double startIm[lanes];
    const auto product = [](std::complex<double> a, std::complex<double> b) {
        return std::complex<double>(a.real() * b.real() - a.imag() * b.imag(),
                                    a.real() * b.imag() + a.imag() * b.real());
    };
    const std::complex<double> sample = std::polar(1.0, radiansPerSample);
    std::complex<double> turn = 1;
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto start = product(swing, turn);
        startRe[k] = start.real();
        startIm[k] = start.imag();
        turn = product(turn, sample);
    }
    auto re = hn::Load(d, startRe);
    auto im = hn::Load(d, startIm);
    const auto turnRe = hn::Set(d, turn.real());
    const auto turnIm = hn::Set(d, turn.imag());
    const auto middle = hn::Set(d, steady);
    for (std::size_t k = 0; k < count; k += lanes) {
        hn::StoreU(hn::DemoteTo(f, hn::Add(middle, re)), f, output + k);
        const auto next = hn::NegMulAdd(im, turnIm, hn::Mul(re, turnRe));
        im = hn::MulAdd(im, turnRe, hn::Mul(re, turnIm));
        re = next;
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(project);
HWY_EXPORT(forced);
HWY_EXPORT(sum);
HWY_EXPORT(cosine);

void projectShapes(const ShapePoint& point,
                   const std::array<float, 3>& struck,
                   const std::array<float, 3>& heard,
                   std::size_t count,
                   float* struckGains,
                   float* heardGains) noexcept {
    HWY_DYNAMIC_DISPATCH(project)(point, struck, heard, count, struckGains, heardGains);
}

void forcedStates(const PulseInstant& pulse,
                  const ForcedArrays& arrays,
                  std::size_t count) noexcept {
    HWY_DYNAMIC_DISPATCH(forced)(pulse, arrays, count);
}

void sumForced(const double* residues,
               const ForcedAmplitudes& arrays,
               std::size_t first,
               std::size_t count,
               ForcedSum& total) noexcept {
    HWY_DYNAMIC_DISPATCH(sum)(residues, arrays, first, count, total);
}

void raisedCosine(double steady,
                  std::complex<double> swing,
                  double radiansPerSample,
                  std::size_t count,
                  float* output) noexcept {
    HWY_DYNAMIC_DISPATCH(cosine)(steady, swing, radiansPerSample, count, output);
}

} // namespace idiophone
#endif
