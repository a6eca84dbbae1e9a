// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModalBankKernel.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Synth/ModalBankKernel.cpp"
#include <hwy/foreach_target.h> // compiles this file once for each target

#include "Synth/SimdComplex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace idiophone {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t floatLanes = hn::MaxLanes(Floats());
constexpr std::size_t doubleLanes = hn::MaxLanes(Doubles());
constexpr std::size_t tableVectors = subBlockSamples / floatLanes;

/// Stores the states at the start of the first `Blocks` sub-blocks; xs and ys become those at the
/// end of the last.
template <std::size_t Blocks>
HWY_INLINE void turnThrough(const ModeRotations& rotations,
                            std::size_t g,
                            hn::Vec<Floats>& xs,
                            hn::Vec<Floats>& ys,
                            SubBlockStates& ahead) {
    const Floats f;
    const auto re = hn::Load(f, rotations.subBlockRe + g);
    const auto im = hn::Load(f, rotations.subBlockIm + g);
    float* HWY_RESTRICT aheadX = ahead.x[0] + g;
    float* HWY_RESTRICT aheadY = ahead.y[0] + g;
#pragma GCC unroll 4
    for (std::size_t b = 0; b < Blocks; ++b) {
        hn::Store(xs, f, aheadX + b * batchModes);
        hn::Store(ys, f, aheadY + b * batchModes);
        const auto turned = hn::NegMulAdd(im, ys, hn::Mul(re, xs));
        ys = hn::MulAdd(im, xs, hn::Mul(re, ys));
        xs = turned;
    }
}

template <std::size_t Blocks>
void fill(const ModeRotations& rotations,
          std::size_t count,
          const float* HWY_RESTRICT x,
          const float* HWY_RESTRICT y,
          SubBlockStates& ahead) {
    const Floats f;
    const ModeRotations local = rotations;
    for (std::size_t g = 0; g < count; g += floatLanes) {
        auto xs = hn::Load(f, x + g);
        auto ys = hn::Load(f, y + g);
        turnThrough<Blocks>(local, g, xs, ys, ahead);
    }
}

void fillBlocks(const ModeRotations& rotations,
                std::size_t count,
                std::size_t blocks,
                const float* x,
                const float* y,
                SubBlockStates& ahead) {
    constexpr decltype(&fill<1>) fills[] = {fill<1>, fill<2>, fill<3>, fill<4>};
    fills[blocks - 1](rotations, count, x, y, ahead);
}

template <bool Scaled>
void advance(const ModeRotations& rotations,
             std::size_t count,
             double scale,
             double* HWY_RESTRICT x,
             double* HWY_RESTRICT y,
             float* HWY_RESTRICT energies,
             SubBlockStates& ahead) {
    const Floats f;
    const Doubles d;
    const ModeRotations local = rotations;
    const double* HWY_RESTRICT cellRe = local.cellRe;
    const double* HWY_RESTRICT cellIm = local.cellIm;
    const auto gain = hn::Set(d, scale);
    const auto squaredGain = hn::Set(f, static_cast<float>(scale * scale));
    const auto step = [&](const double* rotation) HWY_ATTR {
        const auto part = hn::Load(d, rotation);
        return Scaled ? hn::Mul(gain, part) : part;
    };
    for (std::size_t g = 0; g < count; g += floatLanes) {
        auto xs = demoted(x + g);
        auto ys = demoted(y + g);
        turnThrough<subBlocks>(local, g, xs, ys, ahead);
        const auto energy = hn::MulAdd(xs, xs, hn::Mul(ys, ys));
        hn::Store(Scaled ? hn::Mul(energy, squaredGain) : energy, f, energies + g);
#pragma GCC unroll 2
        for (std::size_t k = g; k < g + floatLanes; k += doubleLanes) {
            const auto re = step(cellRe + k);
            const auto im = step(cellIm + k);
            const auto xk = hn::Load(d, x + k);
            const auto yk = hn::Load(d, y + k);
            hn::Store(hn::NegMulAdd(im, yk, hn::Mul(re, xk)), d, x + k);
            hn::Store(hn::MulAdd(im, xk, hn::Mul(re, yk)), d, y + k);
        }
    }
}

void advanceBatch(const ModeRotations& rotations,
                  std::size_t count,
                  double scale,
                  double* x,
                  double* y,
                  float* energies,
                  SubBlockStates& ahead) {
    if (scale == 1)
        advance<false>(rotations, count, scale, x, y, energies, ahead);
    else
        advance<true>(rotations, count, scale, x, y, energies, ahead);
}

/// Mixes sub-blocks `Start` to `Start + Count − 1`. The sums stay in registers, because the loops
/// over them are fully unrolled. With few sub-blocks each sum is split into `Ways` partial sums:
/// one sum takes one product in the time in which the CPU can compute eight.
template <std::size_t Start, std::size_t Count, std::size_t Ways>
HWY_INLINE void mixSubBlocks(const float* HWY_RESTRICT table,
                             const float* HWY_RESTRICT x,
                             const float* HWY_RESTRICT y,
                             std::size_t count,
                             float* HWY_RESTRICT output) {
    const Floats f;
    hn::Vec<Floats> sums[Ways][Count][tableVectors];
#pragma GCC unroll 16
    for (std::size_t w = 0; w < Ways; ++w)
#pragma GCC unroll 16
        for (std::size_t b = 0; b < Count; ++b)
#pragma GCC unroll 16
            for (std::size_t v = 0; v < tableVectors; ++v)
                sums[w][b][v] = w == 0 ? hn::LoadU(f, output + b * subBlockSamples + v * floatLanes)
                                       : hn::Zero(f);
    // 4 ways: even and odd modes, x and y. 2 ways: x and y. 1 way: no split.
    constexpr std::size_t modesAtOnce = Ways == 4 ? 2 : 1;
    const auto add = [&](std::size_t g, std::size_t way) HWY_ATTR {
        const float* HWY_RESTRICT row = table + 2 * subBlockSamples * g;
#pragma GCC unroll 16
        for (std::size_t b = 0; b < Count; ++b) {
            const auto xs = hn::Set(f, x[(Start + b) * batchModes + g]);
            const auto ys = hn::Set(f, y[(Start + b) * batchModes + g]);
#pragma GCC unroll 16
            for (std::size_t v = 0; v < tableVectors; ++v)
                sums[way][b][v] =
                    hn::MulAdd(hn::Load(f, row + v * floatLanes), xs, sums[way][b][v]);
            constexpr std::size_t other = Ways > 1 ? 1 : 0;
#pragma GCC unroll 16
            for (std::size_t v = 0; v < tableVectors; ++v)
                sums[way + other][b][v] =
                    hn::MulAdd(hn::Load(f, row + subBlockSamples + v * floatLanes), ys,
                               sums[way + other][b][v]);
        }
    };
    std::size_t g = 0;
    for (; g + modesAtOnce <= count; g += modesAtOnce)
#pragma GCC unroll 2
        for (std::size_t k = 0; k < modesAtOnce; ++k)
            add(g + k, 2 * k);
    if (g < count)
        add(g, 0);
#pragma GCC unroll 16
    for (std::size_t b = 0; b < Count; ++b)
#pragma GCC unroll 16
        for (std::size_t v = 0; v < tableVectors; ++v) {
            auto sum = sums[0][b][v];
#pragma GCC unroll 16
            for (std::size_t w = 1; w < Ways; ++w)
                sum = hn::Add(sum, sums[w][b][v]);
            hn::StoreU(sum, f, output + b * subBlockSamples + v * floatLanes);
        }
}

void mix(const float* tables,
         const SubBlockStates& ahead,
         std::size_t from,
         std::size_t count,
         std::size_t blocks,
         float* output) {
    const float* x = ahead.x[0] + from;
    const float* y = ahead.y[0] + from;
    // Use no more sums at a time than fit in registers beside the tables.
    if constexpr (tableVectors <= 2) {
        switch (blocks) {
        case 1:
            return mixSubBlocks<0, 1, 4>(tables, x, y, count, output);
        case 2:
            return mixSubBlocks<0, 2, 2>(tables, x, y, count, output);
        case 3:
            return mixSubBlocks<0, 3, 1>(tables, x, y, count, output);
        default:
            return mixSubBlocks<0, 4, 1>(tables, x, y, count, output);
        }
    } else {
        constexpr std::size_t half = 2 * subBlockSamples;
        if (blocks == 1)
            return mixSubBlocks<0, 1, 4>(tables, x, y, count, output);
        mixSubBlocks<0, 2, 1>(tables, x, y, count, output);
        if (blocks == 3)
            mixSubBlocks<2, 1, 4>(tables, x, y, count, output + half);
        if (blocks == 4)
            mixSubBlocks<2, 2, 1>(tables, x, y, count, output + half);
    }
}

EnergySurvey survey(const float* HWY_RESTRICT energies,
                    const float* HWY_RESTRICT audible,
                    float tauSquared,
                    float faintSquared,
                    std::span<const std::int32_t> blocks,
                    std::uint16_t* masks) {
    const Floats f;
    const auto tau = hn::Set(f, tauSquared);
    const auto faint = hn::Set(f, faintSquared);
    const auto largest = hn::Set(f, largestEnergy);
    auto amplitudes = hn::Zero(f);
    auto outside = hn::Gt(hn::Zero(f), hn::Zero(f));
    EnergySurvey result;
    for (const std::int32_t number : blocks) {
        const auto block = static_cast<std::size_t>(number);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < modeBlock; k += floatLanes) {
            const std::size_t g = block * modeBlock + k;
            const auto energy = hn::Load(f, energies + g);
            const auto heard = hn::Mul(energy, hn::Load(f, audible + g));
            const auto rings = hn::Gt(heard, tau);
            amplitudes = hn::Add(amplitudes, hn::IfThenElseZero(rings, hn::Sqrt(heard)));
            std::uint8_t lanes[8] = {};
            hn::StoreMaskBits(f, rings, lanes);
            bits |= (lanes[0] | (std::uint32_t{lanes[1]} << 8)) << k;
            // The group decays into denormals or is not finite.
            const auto fading = hn::And(hn::Lt(energy, faint), hn::Gt(energy, hn::Zero(f)));
            outside = hn::Or(outside, hn::Or(fading, hn::Not(hn::Lt(energy, largest))));
        }
        result.modes += static_cast<std::int32_t>(hwy::PopCount(bits));
        masks[block] = static_cast<std::uint16_t>(bits);
    }
    result.amplitudes = static_cast<double>(hn::GetLane(hn::SumOfLanes(f, amplitudes)));
    result.faint = !hn::AllFalse(f, outside);
    return result;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace idiophone
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace idiophone {

HWY_EXPORT(advanceBatch);
HWY_EXPORT(fillBlocks);
HWY_EXPORT(mix);
HWY_EXPORT(survey);

void advanceModes(const ModeRotations& rotations,
                  std::size_t count,
                  double scale,
                  double* x,
                  double* y,
                  float* energies,
                  SubBlockStates& ahead) noexcept {
    HWY_DYNAMIC_DISPATCH(advanceBatch)(rotations, count, scale, x, y, energies, ahead);
}

void fillAhead(const ModeRotations& rotations,
               std::size_t count,
               std::size_t blocks,
               const float* x,
               const float* y,
               SubBlockStates& ahead) noexcept {
    HWY_DYNAMIC_DISPATCH(fillBlocks)(rotations, count, blocks, x, y, ahead);
}

void mixModes(const float* tables,
              const SubBlockStates& ahead,
              std::size_t from,
              std::size_t count,
              std::size_t blocks,
              float* output) noexcept {
    HWY_DYNAMIC_DISPATCH(mix)(tables, ahead, from, count, blocks, output);
}

EnergySurvey surveyEnergies(const float* energies,
                            const float* audible,
                            float tauSquared,
                            float faintSquared,
                            std::span<const std::int32_t> blocks,
                            std::uint16_t* masks) noexcept {
    return HWY_DYNAMIC_DISPATCH(survey)(energies, audible, tauSquared, faintSquared, blocks, masks);
}

} // namespace idiophone
#endif
