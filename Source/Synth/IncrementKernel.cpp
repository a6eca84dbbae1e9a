// SPDX-License-Identifier: Apache-2.0
#include "Synth/IncrementKernel.h"

#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/IncrementKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include "Synth/Motion-inl.h"

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

using Complex = FloatComplex;
constexpr std::size_t lanes = hn::MaxLanes(Floats());

HWY_INLINE Complex load(const AlignedVector<float>& re,
                        const AlignedVector<float>& im,
                        std::size_t g) {
    const Floats f;
    return {hn::Load(f, re.data() + g), hn::Load(f, im.data() + g)};
}

/// Returns factor · ρ^samples for less than a sample. Within the band the angle is below half a
/// turn, so sine and cosine need no reduction.
HWY_INLINE Complex rotation(const PoleArrays& poles, const BeforeSample& before, std::size_t g) {
    const Floats f;
    const auto samples = hn::Set(f, static_cast<float>(before.samples));
    const auto halfTurns = hn::Mul(samples, hn::Load(f, poles.halfTurnsPerSample.data() + g));
    const auto u = hn::Sub(hn::Min(halfTurns, hn::Set(f, 1.0f)), hn::Set(f, 0.5f));
    const auto z = hn::Mul(u, u);
    const auto power = powerOfTwo(hn::Mul(samples, hn::Load(f, poles.octavesPerSample.data() + g)));
    const auto whole = hn::Mul(hn::Set(f, static_cast<float>(before.factor)), power.whole);
    const auto size = hn::MulAdd(whole, power.part, whole);
    return {hn::Neg(hn::Mul(size, hn::Mul(u, polynomial(z, sine)))),
            hn::Mul(size, polynomial(z, cosine))};
}

/// Returns the unit's states, moved to the next sample.
HWY_INLINE Complex unitIncrement(const PoleArrays& poles,
                                 const UnitContact& unit,
                                 const BeforeSample& before,
                                 std::size_t g) {
    const Floats f;
    const Complex increment = load(unit.x, unit.y, g);
    if (before.samples > 0)
        return product(rotation(poles, before, g), increment);
    const auto factor = hn::Set(f, static_cast<float>(before.factor));
    return {hn::Mul(factor, increment.re), hn::Mul(factor, increment.im)};
}

/// Stores the residues times the increment in one channel and returns the residues.
HWY_INLINE Complex store(const ChannelResidues& residues,
                         Complex increment,
                         std::size_t g,
                         std::size_t channel,
                         StateIncrements& increments) {
    const Floats f;
    const Complex residue = load(residues.re, residues.im, g);
    const Complex sounding = product(residue, increment);
    hn::Store(sounding.re, f, increments.x[channel].data() + g);
    hn::Store(sounding.im, f, increments.y[channel].data() + g);
    return residue;
}

void start(const PoleArrays& poles,
           const UnitContact& unit,
           const BeforeSample& before,
           const ModeResidues& residues,
           std::size_t count,
           std::size_t channels,
           StateIncrements& increments) {
    const Floats f;
    for (std::size_t g = 0; g < count; g += lanes) {
        const Complex increment = unitIncrement(poles, unit, before, g);
        const auto energy =
            hn::MulAdd(increment.re, increment.re, hn::Mul(increment.im, increment.im));
        auto loudest = hn::Zero(f);
        for (std::size_t c = 0; c < channels; ++c) {
            const Complex residue = store(residues[c], increment, g, c, increments);
            loudest = hn::Max(loudest,
                              hn::MulAdd(residue.re, residue.re, hn::Mul(residue.im, residue.im)));
        }
        hn::Store(hn::Mul(loudest, energy), f, increments.energies.data() + g);
    }
}

void gather(const UnitContact& unit,
            const ModeResidues& residues,
            double factor,
            double forceShare,
            std::size_t count,
            std::size_t channels,
            StateIncrements& increments) {
    const Floats f;
    const auto scale = hn::Set(f, static_cast<float>(factor));
    const auto force = hn::Set(f, static_cast<float>(forceShare));
    for (std::size_t g = 0; g < count; g += lanes) {
        const Complex forced = load(unit.x, unit.y, g);
        const auto direct = hn::Mul(force, hn::Load(f, unit.quadratureIm.data() + g));
        for (std::size_t c = 0; c < channels; ++c) {
            const Complex residue = load(residues[c].re, residues[c].im, g);
            const Complex sounding = product(residue, forced);
            const auto added = hn::MulAdd(residue.im, direct, sounding.re);
            float* x = increments.x[c].data() + g;
            float* y = increments.y[c].data() + g;
            hn::Store(hn::MulAdd(scale, added, hn::Load(f, x)), f, x);
            hn::Store(hn::MulAdd(scale, sounding.im, hn::Load(f, y)), f, y);
        }
    }
}

void finish(const PoleArrays& poles,
            const UnitContact& end,
            const BeforeSample& before,
            const IncrementMove& contact,
            const ModeResidues& residues,
            std::size_t count,
            std::size_t channels,
            StateIncrements& increments) {
    for (std::size_t g = 0; g < count; g += lanes) {
        const Complex increment =
            product(change(motion(poles, contact, g)), unitIncrement(poles, end, before, g));
        for (std::size_t c = 0; c < channels; ++c)
            store(residues[c], increment, g, c, increments);
    }
}

void join(const PoleArrays& poles,
          const IncrementMove& move,
          const StateIncrements& increments,
          std::size_t count,
          std::size_t channels,
          ModeStates& states,
          AlignedVector<float>& energies) {
    const Floats f;
    for (std::size_t g = 0; g < count; g += lanes) {
        const Complex moving = moved(motion(poles, move, g));
        auto loudest = hn::Zero(f);
        for (std::size_t c = 0; c < channels; ++c) {
            const Complex increment = product(moving, load(increments.x[c], increments.y[c], g));
            const auto x = addTo(states.x[c].data() + g, increment.re);
            const auto y = addTo(states.y[c].data() + g, increment.im);
            loudest = hn::Max(loudest, hn::MulAdd(x, x, hn::Mul(y, y)));
        }
        hn::Store(loudest, f, energies.data() + g);
    }
}

void move(const PoleArrays& poles,
          const IncrementMove& move,
          std::size_t first,
          std::size_t count,
          std::size_t channels,
          ModeStates& states,
          AlignedVector<float>& energies) {
    const Floats f;
    const Doubles d;
    const HalfFloats half;
    for (std::size_t g = first; g < first + count; g += lanes) {
        const Complex moving = moved(motion(poles, move, g));
        auto loudest = hn::Zero(f);
        for (std::size_t c = 0; c < channels; ++c) {
            double* HWY_RESTRICT x = states.x[c].data() + g;
            double* HWY_RESTRICT y = states.y[c].data() + g;
            const auto turn = [&](auto re, auto im, std::size_t k) HWY_ATTR {
                const DoubleComplex state =
                    product(DoubleComplex{hn::PromoteTo(d, re), hn::PromoteTo(d, im)},
                            DoubleComplex{hn::Load(d, x + k), hn::Load(d, y + k)});
                hn::Store(state.re, d, x + k);
                hn::Store(state.im, d, y + k);
            };
            turn(hn::LowerHalf(half, moving.re), hn::LowerHalf(half, moving.im), 0);
            turn(hn::UpperHalf(half, moving.re), hn::UpperHalf(half, moving.im), hn::MaxLanes(d));
            const auto xs = demoted(x), ys = demoted(y);
            loudest = hn::Max(loudest, hn::MulAdd(xs, xs, hn::Mul(ys, ys)));
        }
        hn::Store(loudest, f, energies.data() + g);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(start);
HWY_EXPORT(gather);
HWY_EXPORT(finish);
HWY_EXPORT(join);
HWY_EXPORT(move);

void startIncrements(const PoleArrays& poles,
                     const UnitContact& unit,
                     const BeforeSample& before,
                     const ModeResidues& residues,
                     std::size_t count,
                     std::size_t channels,
                     StateIncrements& increments) noexcept {
    HWY_DYNAMIC_DISPATCH(start)(poles, unit, before, residues, count, channels, increments);
}

void gatherIncrements(const UnitContact& unit,
                      const ModeResidues& residues,
                      double factor,
                      double force,
                      std::size_t count,
                      std::size_t channels,
                      StateIncrements& increments) noexcept {
    HWY_DYNAMIC_DISPATCH(gather)(unit, residues, factor, force, count, channels, increments);
}

void finishIncrements(const PoleArrays& poles,
                      const UnitContact& end,
                      const BeforeSample& before,
                      const IncrementMove& contact,
                      const ModeResidues& residues,
                      std::size_t count,
                      std::size_t channels,
                      StateIncrements& increments) noexcept {
    HWY_DYNAMIC_DISPATCH(finish)
    (poles, end, before, contact, residues, count, channels, increments);
}

void joinIncrements(const PoleArrays& poles,
                    const IncrementMove& move,
                    const StateIncrements& increments,
                    std::size_t count,
                    std::size_t channels,
                    ModeStates& states,
                    AlignedVector<float>& energies) noexcept {
    HWY_DYNAMIC_DISPATCH(join)(poles, move, increments, count, channels, states, energies);
}

void moveStates(const PoleArrays& poles,
                const IncrementMove& move,
                std::size_t first,
                std::size_t count,
                std::size_t channels,
                ModeStates& states,
                AlignedVector<float>& energies) noexcept {
    HWY_DYNAMIC_DISPATCH(move)(poles, move, first, count, channels, states, energies);
}

} // namespace idiophone
#endif
