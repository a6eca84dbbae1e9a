// SPDX-License-Identifier: Apache-2.0
#include "Synth/PoleLawKernel.h"

#include "Synth/ModeCompression.h"

#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/PoleLawKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include "Synth/SimdComplex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t lanes = hn::MaxLanes(Doubles());

std::size_t wholeVectors(const PoleLaw& law,
                         std::span<const double> referenceEigenvalues,
                         std::span<const ModeDamping> dampings,
                         double* HWY_RESTRICT stiffness,
                         double* HWY_RESTRICT damping) {
    const Doubles d;
    const auto ratio = hn::Set(d, law.eigenvalueRatio);
    const auto extraFactor = hn::Set(d, law.extraFactor());
    const auto fluid = hn::Set(d, law.damping.fluidPerSecond);
    const auto viscoelastic = hn::Set(d, law.damping.viscoelasticSeconds);
    const auto loss = hn::Set(d, law.damping.lossFactor);
    std::size_t i = 0;
    for (; i + lanes <= referenceEigenvalues.size(); i += lanes) {
        const auto product = hn::Mul(ratio, hn::LoadU(d, referenceEigenvalues.data() + i));
        const auto lambda =
            hn::Min(hn::Max(product, hn::Set(d, smallestStiffness)), hn::Set(d, largestStiffness));
        auto ofPole = hn::Add(fluid, hn::Mul(viscoelastic, lambda));
        if (law.damping.lossFactor != 0)
            ofPole = hn::Add(ofPole, hn::Mul(loss, hn::Sqrt(lambda)));
        if (!dampings.empty()) {
            hn::Vec<Doubles> scale, extra;
            hn::LoadInterleaved2(d, &dampings[i].scale, scale, extra);
            const auto twice = hn::Mul(hn::Set(d, 2.0), extra);
            ofPole = hn::Add(hn::Mul(scale, ofPole), hn::Mul(twice, extraFactor));
        }
        hn::StoreU(lambda, d, stiffness + i);
        hn::StoreU(hn::Min(hn::Max(ofPole, hn::Zero(d)), hn::Set(d, largestDamping)), d,
                   damping + i);
    }
    return i;
}

/// The first mode's comparisons of `groupModes`, with a tolerance that is wider than rounding.
void neighbours(const double* HWY_RESTRICT stiffness,
                const double* HWY_RESTRICT damping,
                std::size_t count,
                double compression,
                std::uint8_t* HWY_RESTRICT mayMerge) {
    const Doubles d;
    constexpr double wider = 1 + 1e-9;
    const auto quarter = hn::Set(d, 0.25);
    const auto noticeable = [&](auto frequency, double fromHz) HWY_ATTR {
        const double perRadian = 1 / (2 * std::numbers::pi);
        const double atStart = discriminationHz(fromHz);
        const double slope = discriminationHz(fromHz + 1) - atStart;
        const auto distance =
            hn::Sub(hn::Mul(frequency, hn::Set(d, perRadian)), hn::Set(d, fromHz));
        const auto hz = hn::Add(hn::Mul(distance, hn::Set(d, slope)), hn::Set(d, atStart));
        return hn::Mul(hz, hn::Set(d, wider * compression / perRadian));
    };
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto ownStiffness = hn::LoadU(d, stiffness + i);
        const auto firstStiffness = hn::LoadU(d, stiffness + i - 1);
        const auto ownDamping = hn::LoadU(d, damping + i);
        const auto firstDamping = hn::LoadU(d, damping + i - 1);
        const auto squared = [&](auto lambda, auto damped) HWY_ATTR {
            return hn::Sub(lambda, hn::Mul(hn::Mul(damped, damped), quarter));
        };
        const auto own = squared(ownStiffness, ownDamping);
        const auto first = hn::Max(squared(firstStiffness, firstDamping), hn::Zero(d));
        const auto frequency = hn::Sqrt(first);
        // The curve is convex, so it is the larger one of its two lines.
        const auto discrimination = hn::Max(noticeable(frequency, 20), noticeable(frequency, 2000));
        const auto decay = hn::Mul(hn::Add(ownDamping, firstDamping), hn::Set(d, wider / 4));
        const auto tolerance = hn::Min(discrimination, decay);
        const auto low = hn::Max(hn::Sub(frequency, tolerance), hn::Zero(d));
        const auto high = hn::Add(frequency, tolerance);
        const auto rounding = hn::Mul(first, hn::Set(d, 1e-9));
        const auto isNear = hn::And(hn::Le(own, hn::Add(hn::Mul(high, high), rounding)),
                                    hn::Ge(own, hn::Sub(hn::Mul(low, low), rounding)));
        const auto apart = hn::Abs(hn::Sub(ownStiffness, firstStiffness));
        const auto isSame = hn::Le(apart, hn::Mul(firstStiffness, hn::Set(d, 2e-9)));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Or(isNear, isSame), bits);
        for (std::size_t lane = 0; lane < lanes; ++lane)
            mayMerge[i + lane] = (bits[0] >> lane) & 1;
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(wholeVectors);
HWY_EXPORT(neighbours);

void polesOfLaw(const PoleLaw& law,
                std::span<const double> referenceEigenvalues,
                std::span<const ModeDamping> dampings,
                double* stiffness,
                double* damping) noexcept {
    std::size_t i =
        HWY_DYNAMIC_DISPATCH(wholeVectors)(law, referenceEigenvalues, dampings, stiffness, damping);
    for (; i < referenceEigenvalues.size(); ++i) {
        const ModalPole pole = law.pole(referenceEigenvalues[i], dampingOf(dampings, i));
        stiffness[i] = pole.stiffness;
        damping[i] = pole.damping;
    }
}

void findNeighbours(const double* stiffness,
                    const double* damping,
                    std::size_t count,
                    double compression,
                    std::uint8_t* mayMerge) noexcept {
    HWY_DYNAMIC_DISPATCH(neighbours)(stiffness, damping, count, compression, mayMerge);
}

} // namespace idiophone
#endif
