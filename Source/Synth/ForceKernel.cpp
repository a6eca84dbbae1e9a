// SPDX-License-Identifier: Apache-2.0
#include "Synth/ForceKernel.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/ForceKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include "Synth/SimdComplex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

using Complex = FloatComplex;

/// a by + b
HWY_INLINE Complex moveAndAdd(Complex a, Complex by, Complex b) {
    return {hn::NegMulAdd(a.im, by.im, hn::MulAdd(a.re, by.re, b.re)),
            hn::MulAdd(a.im, by.re, hn::MulAdd(a.re, by.im, b.im))};
}

/// One channel: the states, and complex residues at the cell's start and end.
struct ForcedChannel {
    const float* startRe;
    const float* startIm;
    const float* endRe;
    const float* endIm;
    double* x;
    double* y;
};

constexpr std::size_t hornerStep = 8; ///< samples

/// Computes Σ_j ρ^(15 − j) f[j] over each sub-block, several samples per step of Horner's rule: a
/// product with a real number costs half of a complex one. The sub-blocks are interleaved;
/// otherwise each addition would wait for the one before.
HWY_INLINE void sumSubBlocks(const float* HWY_RESTRICT impulses,
                             const Complex (&power)[hornerStep + 1],
                             Complex (&sums)[subBlocks]) {
    const Floats f;
#pragma GCC unroll 2
    for (std::size_t k = 0; k < subBlockSamples; k += hornerStep) {
        const std::size_t last = k + hornerStep - 1;
#pragma GCC unroll 4
        for (std::size_t b = 0; b < subBlocks; ++b) {
            const auto impulse = hn::Set(f, impulses[last + b * subBlockSamples]);
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
                const auto impulse = hn::Set(f, impulses[last + b * subBlockSamples - j]);
                sums[b].re = hn::MulAdd(impulse, power[j].re, sums[b].re);
                sums[b].im = hn::MulAdd(impulse, power[j].im, sums[b].im);
            }
    }
}

/// Combines the sums of all sub-blocks at the end of the last one.
HWY_INLINE Complex joined(const Complex (&sums)[subBlocks], Complex subBlock) {
    Complex all = sums[0];
#pragma GCC unroll 4
    for (std::size_t b = 1; b < subBlocks; ++b)
        all = moveAndAdd(all, subBlock, sums[b]);
    return all;
}

template <std::size_t Channels>
struct Increments {
    alignas(64) float x[Channels][batchModes];
    alignas(64) float y[Channels][batchModes];
};

/// Computes Σ_k r ρ^(64 − k) f[k] for `count` modes from `first` on.
template <std::size_t Channels, bool Moves>
HWY_INLINE void findIncrements(const PoleArrays& modes,
                               const float* HWY_RESTRICT impulses,
                               std::size_t first,
                               std::size_t count,
                               const ForcedChannel (&channels)[Channels],
                               Increments<Channels>& found) {
    const Floats f;
    for (std::size_t place = 0; place < count; place += hn::MaxLanes(f)) {
        const std::size_t g = first + place;
        Complex power[hornerStep + 1];
        power[1] = {hn::Load(f, modes.sampleRe.data() + g), hn::Load(f, modes.sampleIm.data() + g)};
#pragma GCC unroll 8
        for (std::size_t k = 2; k <= hornerStep; ++k)
            power[k] = product(power[k / 2], power[k - k / 2]);
        const Complex subBlock{hn::Load(f, modes.subBlockRe.data() + g),
                               hn::Load(f, modes.subBlockIm.data() + g)};
        Complex sums[subBlocks];
        sumSubBlocks(impulses, power, sums);
        Complex common{hn::Zero(f), hn::Zero(f)};
        if (!Moves)
            common = product(joined(sums, subBlock), power[1]);
#pragma GCC unroll 2
        for (std::size_t c = 0; c < Channels; ++c) {
            const Complex start{hn::Load(f, channels[c].startRe + g),
                                hn::Load(f, channels[c].startIm + g)};
            Complex all;
            if (Moves) {
                const Complex change{hn::Sub(hn::Load(f, channels[c].endRe + g), start.re),
                                     hn::Sub(hn::Load(f, channels[c].endIm + g), start.im)};
                Complex heard[subBlocks];
#pragma GCC unroll 4
                for (std::size_t b = 0; b < subBlocks; ++b) {
                    const auto share = hn::Set(f, fractionAt(b));
                    heard[b] = product(Complex{hn::MulAdd(change.re, share, start.re),
                                               hn::MulAdd(change.im, share, start.im)},
                                       sums[b]);
                }
                all = product(joined(heard, subBlock), power[1]);
            } else {
                all = product(start, common);
            }
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

template <std::size_t Channels, bool Moves>
void forceOn(const PoleArrays& modes,
             const float* impulses,
             const ModeResidues& start,
             const ModeResidues& end,
             std::size_t count,
             ModeStates& states,
             float* energies) {
    ForcedChannel channels[Channels];
    for (std::size_t c = 0; c < Channels; ++c)
        channels[c] = {start[c].re.data(), start[c].im.data(), end[c].re.data(),
                       end[c].im.data(),   states.x[c].data(), states.y[c].data()};
    // Two passes: the CPU's reorder window holds one mode of either loop, but not of both.
    Increments<Channels> found;
    for (std::size_t first = 0; first < count; first += batchModes) {
        const std::size_t batch = std::min(batchModes, count - first);
        findIncrements<Channels, Moves>(modes, impulses, first, batch, channels, found);
        addIncrements(modes.velocityShare.data(), first, batch, found, channels, energies);
    }
}

void force(const PoleArrays& modes,
           const float* impulses,
           const ModeResidues& start,
           const ModeResidues& end,
           std::size_t count,
           std::size_t channels,
           ModeStates& states,
           float* energies) {
    const bool moves = &start != &end;
    const auto on = channels == 1 ? (moves ? forceOn<1, true> : forceOn<1, false>)
                                  : (moves ? forceOn<2, true> : forceOn<2, false>);
    on(modes, impulses, start, end, count, states, energies);
}

void convolve(const float* HWY_RESTRICT impulses,
              const float* HWY_RESTRICT startResponse,
              const float* HWY_RESTRICT endResponse,
              float* HWY_RESTRICT output) {
    const Floats f;
    constexpr std::size_t lanes = hn::MaxLanes(f);
    // Zeros before the response let every impulse add whole vectors.
    alignas(64) float response[2 * cellSize];
    for (std::size_t k = 0; k < cellSize; k += lanes)
        hn::Store(hn::Zero(f), f, response + k);
    constexpr std::size_t vectors = subBlockSamples / lanes;
    for (std::size_t b = 0; b < subBlocks; ++b) {
        const std::size_t first = b * subBlockSamples;
        const auto share = hn::Set(f, fractionAt(b));
        for (std::size_t k = 0; k < cellSize - first; k += lanes) {
            const auto from = hn::LoadU(f, startResponse + k);
            const auto change = hn::Sub(hn::LoadU(f, endResponse + k), from);
            hn::Store(hn::MulAdd(share, change, from), f, response + cellSize + k);
        }
        for (std::size_t n = first; n < cellSize; n += subBlockSamples) {
            // Separate sums for even and odd impulses; otherwise each product would wait for the
            // one before.
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
           float fraction,
           std::size_t count,
           float* HWY_RESTRICT output) {
    const Floats f;
    const auto share = hn::Set(f, fraction);
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

void forceModes(const PoleArrays& modes,
                const float* impulses,
                const ModeResidues& start,
                const ModeResidues& end,
                std::size_t count,
                std::size_t channels,
                ModeStates& states,
                AlignedVector<float>& energies) noexcept {
    HWY_DYNAMIC_DISPATCH(force)
    (modes, impulses, start, end, count, channels, states, energies.data());
}

void convolveForce(std::span<const float, cellSize> impulses,
                   std::span<const float, cellSize> startResponse,
                   std::span<const float, cellSize> endResponse,
                   std::span<float, cellSize> output) noexcept {
    HWY_DYNAMIC_DISPATCH(convolve)
    (impulses.data(), startResponse.data(), endResponse.data(), output.data());
}

void blendResponses(
    const float* from, const float* to, float fraction, std::size_t count, float* output) noexcept {
    HWY_DYNAMIC_DISPATCH(blend)(from, to, fraction, count, output);
}

} // namespace idiophone
#endif
