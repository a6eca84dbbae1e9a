#include "Synth/ForceKernel.h"

#include <algorithm>

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

/// a by + b
HWY_INLINE Complex moveAndAdd(Complex a, Complex by, Complex b) {
    return {hn::NegMulAdd(a.im, by.im, hn::MulAdd(a.re, by.re, b.re)),
            hn::MulAdd(a.im, by.re, hn::MulAdd(a.re, by.im, b.im))};
}

HWY_INLINE Vector demoted(const double* values) {
    const Floats f;
    const Doubles d;
    const HalfFloats half;
    return hn::Combine(f, hn::DemoteTo(half, hn::Load(d, values + hn::MaxLanes(d))),
                       hn::DemoteTo(half, hn::Load(d, values)));
}

/// Returns the sum in single precision.
HWY_INLINE Vector addTo(double* values, Vector sum) {
    const Floats f;
    const Doubles d;
    const HalfFloats half;
    double* upper = values + hn::MaxLanes(d);
    const auto low = hn::Add(hn::Load(d, values), hn::PromoteTo(d, hn::LowerHalf(half, sum)));
    const auto high = hn::Add(hn::Load(d, upper), hn::PromoteTo(d, hn::UpperHalf(half, sum)));
    hn::Store(low, d, values);
    hn::Store(high, d, upper);
    return hn::Combine(f, hn::DemoteTo(half, high), hn::DemoteTo(half, low));
}

constexpr std::size_t hornerStep = 8; ///< samples

/// Σ_j ρ^(15 − j) f[j] over each sub-block, some samples a step of Horner's rule: a product with a
/// real number costs half of one with a complex number. The sub-blocks go side by side, or each
/// addition would wait for the one before.
HWY_INLINE void sumSubBlocks(const float* HWY_RESTRICT impulses,
                             const Complex (&power)[hornerStep + 1],
                             Complex (&sums)[subBlocks]) {
    const Floats f;
#pragma GCC unroll 2
    for (std::size_t k = 0; k < subBlockSamples; k += hornerStep) {
        const float* HWY_RESTRICT last = impulses + k + hornerStep - 1;
#pragma GCC unroll 4
        for (std::size_t b = 0; b < subBlocks; ++b) {
            const auto impulse = hn::Set(f, last[b * subBlockSamples]);
            if (k == 0) {
                sums[b] = {impulse, hn::Zero(f)};
            } else {
                sums[b] = moveAndAdd(sums[b], power[hornerStep], {impulse, hn::Zero(f)});
            }
        }
#pragma GCC unroll 8
        for (std::size_t j = 1; j < hornerStep; ++j)
#pragma GCC unroll 4
            for (std::size_t b = 0; b < subBlocks; ++b) {
                const auto impulse = hn::Set(f, last[b * subBlockSamples - j]);
                sums[b].re = hn::MulAdd(impulse, power[j].re, sums[b].re);
                sums[b].im = hn::MulAdd(impulse, power[j].im, sums[b].im);
            }
    }
}

/// What a force adds to a batch of modes.
template <std::size_t Channels>
struct Increments {
    alignas(64) float x[Channels][batchModes];
    alignas(64) float y[Channels][batchModes];
};

/// Σ_k r ρ^(64 − k) f[k] for `count` modes from `first` on.
template <std::size_t Channels>
HWY_INLINE void findIncrements(const ForcedModes& modes,
                               const float* HWY_RESTRICT impulses,
                               float fall,
                               std::size_t first,
                               std::size_t count,
                               const ForcedChannel (&channels)[Channels],
                               Increments<Channels>& found) {
    const Floats f;
    const auto damper = hn::Set(f, fall);
    for (std::size_t place = 0; place < count; place += hn::MaxLanes(f)) {
        const std::size_t g = first + place;
        Complex power[hornerStep + 1];
        power[1] = {hn::Mul(damper, hn::Load(f, modes.sampleRe + g)),
                    hn::Mul(damper, hn::Load(f, modes.sampleIm + g))};
#pragma GCC unroll 8
        for (std::size_t k = 2; k <= hornerStep; ++k)
            power[k] = product(power[k / 2], power[k - k / 2]);
        const Complex turn = product(power[hornerStep], power[hornerStep]);
        const Complex half = product(turn, turn);
        Complex sums[subBlocks];
        sumSubBlocks(impulses, power, sums);
#pragma GCC unroll 2
        for (std::size_t c = 0; c < Channels; ++c) {
            const auto start = hn::Load(f, channels[c].startResidues + g);
            const auto way = hn::Sub(hn::Load(f, channels[c].endResidues + g), start);
            Complex heard[subBlocks];
#pragma GCC unroll 4
            for (std::size_t b = 0; b < subBlocks; ++b) {
                const auto residue = hn::MulAdd(way, hn::Set(f, shareOfWay(b)), start);
                heard[b] = {hn::Mul(residue, sums[b].re), hn::Mul(residue, sums[b].im)};
            }
            const Complex early = moveAndAdd(heard[0], turn, heard[1]);
            const Complex late = moveAndAdd(heard[2], turn, heard[3]);
            const Complex all = product(moveAndAdd(early, half, late), power[1]);
            hn::Store(all.re, f, found.x[c] + place);
            hn::Store(all.im, f, found.y[c] + place);
        }
    }
}

template <std::size_t Channels>
HWY_INLINE void addIncrements(const double* HWY_RESTRICT velocityShare,
                              std::size_t first,
                              std::size_t count,
                              const Increments<Channels>& found,
                              const ForcedChannel (&channels)[Channels],
                              float* HWY_RESTRICT energies) {
    const Floats f;
    for (std::size_t place = 0; place < count; place += hn::MaxLanes(f)) {
        const std::size_t g = first + place;
        const auto share = demoted(velocityShare + g);
        auto loudest = hn::Zero(f);
#pragma GCC unroll 2
        for (std::size_t c = 0; c < Channels; ++c) {
            const auto re = hn::Load(f, found.x[c] + place);
            const auto im = hn::Load(f, found.y[c] + place);
            const auto x = addTo(channels[c].x + g, hn::NegMulAdd(share, im, re));
            const auto y = addTo(channels[c].y + g, hn::MulAdd(share, re, im));
            loudest = hn::Max(loudest, hn::MulAdd(x, x, hn::Mul(y, y)));
        }
        hn::Store(loudest, f, energies + g);
    }
}

template <std::size_t Channels>
void forceOn(const ForcedModes& modes,
             const float* impulses,
             float fall,
             std::size_t count,
             std::span<const ForcedChannel> given,
             float* energies) {
    ForcedChannel channels[Channels];
    for (std::size_t c = 0; c < Channels; ++c)
        channels[c] = given[c];
    // In two passes: the machine looks ahead over a mode of either, but not of both.
    Increments<Channels> found;
    for (std::size_t first = 0; first < count; first += batchModes) {
        const std::size_t batch = std::min(batchModes, count - first);
        findIncrements(modes, impulses, fall, first, batch, channels, found);
        addIncrements(modes.velocityShare, first, batch, found, channels, energies);
    }
}

void force(const ForcedModes& modes,
           const float* impulses,
           float fall,
           std::size_t count,
           std::span<const ForcedChannel> channels,
           float* energies) {
    if (channels.size() == 1)
        forceOn<1>(modes, impulses, fall, count, channels, energies);
    else
        forceOn<2>(modes, impulses, fall, count, channels, energies);
}

void convolve(const float* HWY_RESTRICT impulses,
              const float* HWY_RESTRICT startResponse,
              const float* HWY_RESTRICT endResponse,
              float* HWY_RESTRICT output) {
    const Floats f;
    constexpr std::size_t cellSize = subBlocks * subBlockSamples;
    constexpr std::size_t lanes = hn::MaxLanes(f);
    // Zeros before the response, so that every impulse adds whole vectors.
    alignas(64) float response[2 * cellSize];
    for (std::size_t k = 0; k < cellSize; k += lanes)
        hn::Store(hn::Zero(f), f, response + k);
    constexpr std::size_t vectors = subBlockSamples / lanes;
    for (std::size_t b = 0; b < subBlocks; ++b) {
        const std::size_t first = b * subBlockSamples;
        const auto share = hn::Set(f, shareOfWay(b));
        for (std::size_t k = 0; k < cellSize - first; k += lanes) {
            const auto from = hn::LoadU(f, startResponse + k);
            const auto way = hn::Sub(hn::LoadU(f, endResponse + k), from);
            hn::Store(hn::MulAdd(share, way, from), f, response + cellSize + k);
        }
        for (std::size_t n = first; n < cellSize; n += subBlockSamples) {
            // Even and odd impulses apart, or each product would wait for the one before.
            hn::Vec<Floats> sums[2][vectors];
#pragma GCC unroll 4
            for (std::size_t v = 0; v < vectors; ++v) {
                sums[0][v] = hn::LoadU(f, output + n + v * lanes);
                sums[1][v] = hn::Zero(f);
            }
            const float* HWY_RESTRICT heard = response + cellSize + n - first;
#pragma GCC unroll 16
            for (std::size_t k = 0; k < subBlockSamples; ++k) {
                const auto impulse = hn::Set(f, impulses[first + k]);
#pragma GCC unroll 4
                for (std::size_t v = 0; v < vectors; ++v)
                    sums[k % 2][v] =
                        hn::MulAdd(impulse, hn::LoadU(f, heard + v * lanes - k), sums[k % 2][v]);
            }
#pragma GCC unroll 4
            for (std::size_t v = 0; v < vectors; ++v)
                hn::StoreU(hn::Add(sums[0][v], sums[1][v]), f, output + n + v * lanes);
        }
    }
}

void blend(const float* HWY_RESTRICT from,
           const float* HWY_RESTRICT to,
           float way,
           std::size_t count,
           float* HWY_RESTRICT output) {
    const Floats f;
    const auto share = hn::Set(f, way);
    for (std::size_t g = 0; g < count; g += hn::MaxLanes(f)) {
        const auto start = hn::Load(f, from + g);
        hn::Store(hn::MulAdd(share, hn::Sub(hn::Load(f, to + g), start), start), f, output + g);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(force);
HWY_EXPORT(convolve);
HWY_EXPORT(blend);

void forceModes(const ForcedModes& modes,
                const float* impulses,
                float fall,
                std::size_t count,
                std::span<const ForcedChannel> channels,
                float* energies) noexcept {
    HWY_DYNAMIC_DISPATCH(force)(modes, impulses, fall, count, channels, energies);
}

void convolveForce(std::span<const float, subBlocks * subBlockSamples> impulses,
                   std::span<const float, subBlocks * subBlockSamples> startResponse,
                   std::span<const float, subBlocks * subBlockSamples> endResponse,
                   std::span<float, subBlocks * subBlockSamples> output) noexcept {
    HWY_DYNAMIC_DISPATCH(convolve)
    (impulses.data(), startResponse.data(), endResponse.data(), output.data());
}

void blendResponses(
    const float* from, const float* to, float way, std::size_t count, float* output) noexcept {
    HWY_DYNAMIC_DISPATCH(blend)(from, to, way, count, output);
}

} // namespace idiophone
#endif
