// SPDX-License-Identifier: Apache-2.0
#include "Synth/StrikeKernel.h"

#include "Synth/ComplexProduct.h"

#include <complex>
#include <numbers>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/StrikeKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include "Synth/SimdComplex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

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
             const std::array<float, 3>& listening,
             std::size_t count,
             float* HWY_RESTRICT struckGains,
             float* HWY_RESTRICT listeningGains) {
    const Floats f;
    constexpr std::size_t lanes = hn::MaxLanes(Floats());
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        auto struckGain = hn::Zero(f);
        auto listeningGain = hn::Zero(f);
        for (std::size_t k = 0; k < point.used; ++k) {
            hn::Vec<Floats> x, y, z;
            hn::LoadInterleaved3(f, point.rows[k] + 3 * i, x, y, z);
            const auto weight = hn::Set(f, point.weights[k]);
            struckGain = hn::MulAdd(dot(x, y, z, struck), weight, struckGain);
            listeningGain = hn::MulAdd(dot(x, y, z, listening), weight, listeningGain);
        }
        hn::StoreU(struckGain, f, struckGains + i);
        hn::StoreU(listeningGain, f, listeningGains + i);
    }
    for (; i < count; ++i) {
        struckGains[i] = listeningGains[i] = 0;
        for (std::size_t k = 0; k < point.used; ++k) {
            const float* shape = point.rows[k] + 3 * i;
            const auto along = [&](const std::array<float, 3>& direction) {
                return shape[0] * direction[0] + shape[1] * direction[1] + shape[2] * direction[2];
            };
            struckGains[i] += point.weights[k] * along(struck);
            listeningGains[i] += point.weights[k] * along(listening);
        }
    }
}

/// A pole in units of the pulse's Ω. Single precision suffices for all but λ − Ω², which is small
/// near resonance.
struct PoleInPulse {
    hn::Vec<Floats> decay;
    hn::Vec<Floats> frequency;
    hn::Vec<Floats> excess; ///< λ − 1
};

HWY_INLINE PoleInPulse poleInPulse(const PoleArrays& poles, double perOmega, std::size_t g) {
    const Floats f;
    const Doubles d;
    const HalfFloats half;
    const auto scale = hn::Set(d, perOmega);
    const auto both = [&](const AlignedVector<double>& values) HWY_ATTR {
        return std::pair(hn::Mul(scale, hn::Load(d, values.data() + g)),
                         hn::Mul(scale, hn::Load(d, values.data() + g + hn::MaxLanes(d))));
    };
    const auto demoted = [&](auto lower, auto upper) HWY_ATTR {
        return hn::Combine(f, hn::DemoteTo(half, upper), hn::DemoteTo(half, lower));
    };
    const auto excess = [&](auto decay, auto frequency) HWY_ATTR {
        const auto square = hn::MulSub(frequency, frequency, hn::Set(d, 1.0));
        return hn::MulAdd(decay, decay, square);
    };
    const auto [decayLower, decayUpper] = both(poles.decay);
    const auto [frequencyLower, frequencyUpper] = both(poles.frequency);
    return {demoted(decayLower, decayUpper), demoted(frequencyLower, frequencyUpper),
            demoted(excess(decayLower, frequencyLower), excess(decayUpper, frequencyUpper))};
}

// The closed form that ForcedResponse explains, in units of Ω. The contact's rate 1/T is then 1/2π.
void forced(const PulseInstant& pulse,
            const PoleArrays& poles,
            std::size_t count,
            UnitContact& unit) {
    const Floats f;
    constexpr double fullTurn = 2 * std::numbers::pi;
    const double perOmega = pulse.contactSeconds / fullTurn;
    const auto set = [&](double value) HWY_ATTR { return hn::Set(f, static_cast<float>(value)); };
    const auto rate = set(1 / fullTurn);
    const auto delta = set(pulse.dampingPerSecond * perOmega);
    const auto phaseRe = set(pulse.phase.real());
    const auto phaseIm = set(pulse.phase.imag());
    const auto rest = set(1 - pulse.phase.real());
    const auto one = set(1);
    // Minimum distance from resonance for single precision. It matters only if no contact time was
    // clear of all resonances.
    const auto nearest = set(1e-3);
    const auto apart = [&](auto re, auto im) HWY_ATTR {
        const auto isNear = hn::And(hn::Lt(hn::Abs(re), nearest), hn::Lt(hn::Abs(im), nearest));
        return hn::IfThenElse(isNear, hn::CopySign(nearest, re), re);
    };
    for (std::size_t g = 0; g < count; g += hn::MaxLanes(f)) {
        const PoleInPulse pole = poleInPulse(poles, perOmega, g);
        const auto damping = hn::Add(pole.decay, pole.decay);
        const auto drag = hn::Mul(delta, hn::Add(delta, damping));
        const auto stiffness =
            hn::MulAdd(pole.frequency, pole.frequency, hn::Mul(pole.decay, pole.decay));
        const auto constant = hn::Add(drag, stiffness); // P(δ)
        const auto im = hn::Add(hn::Add(delta, delta), damping);
        const auto re = apart(hn::Add(drag, pole.excess), im); // P(δ + i)
        const auto perSquared = hn::Div(rate, hn::MulAdd(re, re, hn::Mul(im, im)));
        const auto reciprocal = hn::Div(one, hn::Mul(constant, pole.frequency));
        const auto perConstant = hn::Mul(reciprocal, pole.frequency);
        const auto perFrequency = hn::Mul(reciprocal, constant);

        const auto steady = hn::Mul(hn::Mul(rate, delta), perConstant);
        const auto swingRe = hn::Neg(hn::Mul(perSquared, hn::MulAdd(delta, re, im)));
        const auto swingIm = hn::Mul(perSquared, hn::MulSub(delta, im, re));
        const auto velocity =
            hn::Add(steady, hn::NegMulAdd(swingIm, phaseIm, hn::Mul(swingRe, phaseRe)));
        const auto numeratorRe = hn::MulSub(constant, rest, one);
        const auto numeratorIm = hn::NegMulAdd(constant, phaseIm, im);
        const auto displacement = hn::Mul(hn::Mul(perSquared, perConstant),
                                          hn::MulAdd(numeratorRe, re, hn::Mul(numeratorIm, im)));
        hn::Store(velocity, f, unit.x.data() + g);
        hn::Store(hn::Mul(perFrequency,
                          hn::MulAdd(stiffness, displacement, hn::Mul(pole.decay, velocity))),
                  f, unit.y.data() + g);
        hn::Store(steady, f, unit.steady.data() + g);
        hn::Store(swingRe, f, unit.swingRe.data() + g);
        hn::Store(swingIm, f, unit.swingIm.data() + g);
        // (δ + iΩ + α)/ω
        const auto perOwnFrequency = hn::Div(one, pole.frequency);
        hn::Store(hn::Mul(hn::Add(delta, pole.decay), perOwnFrequency), f,
                  unit.quadratureRe.data() + g);
        hn::Store(perOwnFrequency, f, unit.quadratureIm.data() + g);
    }
}

void sum(const ChannelResidues& residues,
         const UnitContact& unit,
         std::size_t first,
         std::size_t count,
         ForcedSum& total) {
    const Floats f;
    auto steady = hn::Zero(f);
    auto swingRe = hn::Zero(f);
    auto swingIm = hn::Zero(f);
    const std::size_t end = first + count;
    std::size_t g = first;
    for (; g + hn::MaxLanes(f) <= end; g += hn::MaxLanes(f)) {
        const auto quadrature = hn::LoadU(f, residues.im.data() + g);
        const FloatComplex weight{hn::MulAdd(quadrature, hn::LoadU(f, unit.quadratureRe.data() + g),
                                             hn::LoadU(f, residues.re.data() + g)),
                                  hn::Mul(quadrature, hn::LoadU(f, unit.quadratureIm.data() + g))};
        const FloatComplex swing =
            product(weight, FloatComplex{hn::LoadU(f, unit.swingRe.data() + g),
                                         hn::LoadU(f, unit.swingIm.data() + g)});
        steady = hn::MulAdd(weight.re, hn::LoadU(f, unit.steady.data() + g), steady);
        swingRe = hn::Add(swing.re, swingRe);
        swingIm = hn::Add(swing.im, swingIm);
    }
    const auto sumOf = [](hn::Vec<Floats> lanes) HWY_ATTR {
        return static_cast<double>(hn::GetLane(hn::SumOfLanes(Floats(), lanes)));
    };
    total.steady += sumOf(steady);
    total.swing += std::complex<double>(sumOf(swingRe), sumOf(swingIm));
    for (; g < end; ++g) {
        const auto quadrature = static_cast<double>(residues.im[g]);
        const std::complex<double> weight(static_cast<double>(residues.re[g]) +
                                              quadrature *
                                                  static_cast<double>(unit.quadratureRe[g]),
                                          quadrature * static_cast<double>(unit.quadratureIm[g]));
        total.steady += weight.real() * static_cast<double>(unit.steady[g]);
        total.swing +=
            idiophone::product(weight, std::complex<double>(unit.swingRe[g], unit.swingIm[g]));
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
    std::complex<double> power = 1;
    for (std::size_t k = 0; k < lanes; ++k) {
        const auto start = product(swing, power);
        startRe[k] = start.real();
        startIm[k] = start.imag();
        power = product(power, sample);
    }
    auto re = hn::Load(d, startRe);
    auto im = hn::Load(d, startIm);
    const auto stepRe = hn::Set(d, power.real());
    const auto stepIm = hn::Set(d, power.imag());
    const auto middle = hn::Set(d, steady);
    for (std::size_t k = 0; k < count; k += lanes) {
        hn::StoreU(hn::DemoteTo(f, hn::Add(middle, re)), f, output + k);
        const auto next = hn::NegMulAdd(im, stepIm, hn::Mul(re, stepRe));
        im = hn::MulAdd(im, stepRe, hn::Mul(re, stepIm));
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
                   const std::array<float, 3>& listening,
                   std::size_t count,
                   float* struckGains,
                   float* listeningGains) noexcept {
    HWY_DYNAMIC_DISPATCH(project)(point, struck, listening, count, struckGains, listeningGains);
}

void forcedStates(const PulseInstant& pulse,
                  const PoleArrays& poles,
                  std::size_t count,
                  UnitContact& unit) noexcept {
    HWY_DYNAMIC_DISPATCH(forced)(pulse, poles, count, unit);
}

void sumForced(const ChannelResidues& residues,
               const UnitContact& unit,
               const ModeRun& run,
               ForcedSum& total) noexcept {
    HWY_DYNAMIC_DISPATCH(sum)
    (residues, unit, static_cast<std::size_t>(run.first), static_cast<std::size_t>(run.count),
     total);
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
