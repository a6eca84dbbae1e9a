#include "Synth/IncrementKernel.h"

#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/IncrementKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include "Synth/SimdComplex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

using Vector = hn::Vec<Floats>;
using Complex = FloatComplex;
constexpr std::size_t lanes = hn::MaxLanes(Floats());

HWY_INLINE Complex load(const AlignedVector<float>& re,
                        const AlignedVector<float>& im,
                        std::size_t g) {
    const Floats f;
    return {hn::Load(f, re.data() + g), hn::Load(f, im.data() + g)};
}

/// c0 + z (c1 + z (c2 + …))
template <std::size_t N>
HWY_INLINE Vector polynomial(Vector z, const float (&coefficients)[N]) {
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
    Vector whole, part;
};

HWY_INLINE PowerOfTwo powerOfTwo(Vector octaves) {
    const Floats f;
    const hn::RebindToSigned<Floats> i;
    const auto bounded = hn::Max(octaves, hn::Set(f, -120.0f));
    const auto nearest = hn::NearestInt(bounded);
    const auto rest = hn::Sub(bounded, hn::ConvertTo(f, nearest));
    const auto one = hn::BitCast(i, hn::Set(f, 1.0f));
    return {hn::BitCast(f, hn::Add(one, hn::ShiftLeft<23>(nearest))),
            hn::Mul(rest, polynomial(rest, powers))};
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

/// Sine and cosine of half the angle ωt, and the remaining amplitude, for any time in single
/// precision.
struct Motion {
    Vector sin, cos;
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
HWY_INLINE Complex moved(const Motion& motion) {
    const auto size = hn::MulAdd(motion.left.whole, motion.left.part, motion.left.whole);
    const auto twice = hn::Mul(hn::Add(motion.sin, motion.sin), size);
    return {hn::NegMulAdd(twice, motion.sin, size), hn::Mul(twice, motion.cos)};
}

/// 1 − e^{(−α + iω)t}, precise even if it is small.
HWY_INLINE Complex change(const Motion& motion) {
    const Floats f;
    const auto whole = motion.left.whole;
    const auto size = hn::MulAdd(whole, motion.left.part, whole);
    const auto lost = hn::NegMulAdd(whole, motion.left.part, hn::Sub(hn::Set(f, 1.0f), whole));
    const auto twice = hn::Mul(hn::Add(motion.sin, motion.sin), size);
    return {hn::MulAdd(twice, motion.sin, lost), hn::Neg(hn::Mul(twice, motion.cos))};
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

} // namespace idiophone
#endif
