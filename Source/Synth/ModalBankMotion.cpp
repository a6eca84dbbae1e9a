// How the states of a modal bank move and sound.
#include "Synth/ForceKernel.h"
#include "Synth/ModalBank.h"
#include "Synth/PoleKernel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {

namespace {

constexpr std::size_t cellSize = subBlocks * subBlockSamples;

std::size_t index(std::int32_t number) noexcept {
    return static_cast<std::size_t>(number);
}

} // namespace

void ModalBank::advanceBlock(std::size_t block,
                             double seconds,
                             double factor,
                             double floor) noexcept {
    const std::size_t first = block * modeBlock;
    setAside(states);
    for (std::size_t c = 0; c < channelCount; ++c) {
        rotateModes(decay.data() + first, frequency.data() + first, modeBlock, seconds, factor,
                    states.x[c].data() + first, states.y[c].data() + first);
        for (const HeavyMode& heavy : heavyModes) {
            const std::size_t g = index(heavy.mode);
            if (g / modeBlock != block)
                continue;
            const ModalState moved = propagator(pole(g), seconds) * heavy.aside[c];
            states.x[c][g] = factor * moved.x;
            states.y[c][g] = factor * moved.y;
        }
    }
    for (std::size_t g = first; g < first + modeBlock; ++g)
        measure(g);
    clearFaint(block, floor);
}

void ModalBank::render(std::span<const std::int32_t> blocks,
                       std::span<const ModeRun> runs,
                       double scale,
                       const ChannelOutputs& outputs) noexcept {
    renderStates(states, energy.data(), blocks, runs, scale, outputs);
}

void ModalBank::renderFrom(ModeStates& from,
                           std::span<const ModeRun> runs,
                           const ChannelOutputs& outputs) noexcept {
    if (runs.empty())
        return;
    const std::size_t first = index(runs.front().first) / modeBlock;
    const std::size_t last = index(runs.back().first + runs.back().count - 1) / modeBlock;
    renderStates(from, nullptr, std::span(blockNumbers).subspan(first, last - first + 1), runs, 1,
                 outputs);
}

void ModalBank::sound(const ModeStates& from,
                      std::span<const ModeRun> runs,
                      std::size_t subBlockCount,
                      const ChannelOutputs& outputs) noexcept {
    if (runs.empty())
        return;
    SubBlockStates ahead;
    setAside(from);
    const std::size_t last = index(runs.back().first + runs.back().count);
    for (std::size_t first = index(runs.front().first) / modeBlock * modeBlock; first < last;
         first += batchModes) {
        const std::size_t modes = std::min(batchModes, paddedSize() - first);
        for (std::size_t c = 0; c < channelCount; ++c) {
            lookAhead(rotations(first), modes, from.x[c].data() + first, from.y[c].data() + first,
                      ahead);
            for (const HeavyMode& heavy : heavyModes)
                if (index(heavy.mode) >= first && index(heavy.mode) < first + modes)
                    lookAtHeavy(heavy, c, index(heavy.mode) - first, ahead);
            mixRuns(runs, first, first + modes, ahead, subBlockCount, outputs[c]);
        }
    }
}

ModeRotations ModalBank::rotations(std::size_t first) const noexcept {
    return {turnRe.data() + first, turnIm.data() + first, cellRe.data() + first,
            cellIm.data() + first};
}

/// Its states at the start of each sub-block, from the one set aside.
void ModalBank::lookAtHeavy(const HeavyMode& heavy,
                            std::size_t channel,
                            std::size_t place,
                            SubBlockStates& ahead) noexcept {
    ModalState moving = heavy.aside[channel];
    for (std::size_t k = 0; k < subBlocks; ++k) {
        ahead.x[k][place] = static_cast<float>(moving.x);
        ahead.y[k][place] = static_cast<float>(moving.y);
        moving = heavy.turn * moving;
    }
}

/// Mixes what of `runs` lies within modes `first` to `end` − 1, whose states stand in `ahead`.
void ModalBank::mixRuns(std::span<const ModeRun> runs,
                        std::size_t first,
                        std::size_t end,
                        const SubBlockStates& ahead,
                        std::size_t subBlockCount,
                        float* output) const noexcept {
    for (const ModeRun& run : runs) {
        const std::size_t runFirst = std::max(index(run.first), first);
        const std::size_t runEnd = std::min(index(run.first + run.count), end);
        if (runFirst < runEnd)
            mixModes(tables.data() + 2 * subBlockSamples * runFirst, ahead, runFirst - first,
                     runEnd - runFirst, subBlockCount, output);
    }
}

void ModalBank::renderStates(ModeStates& from,
                             float* energies,
                             std::span<const std::int32_t> blocks,
                             std::span<const ModeRun> runs,
                             double scale,
                             const ChannelOutputs& outputs) noexcept {
    SubBlockStates ahead;
    setAside(from);
    for (std::size_t b = 0; b < blocks.size();) {
        // A batch is as many consecutive blocks as it holds.
        const std::size_t firstBlock = index(blocks[b]);
        std::size_t blocksHere = 1;
        while (b + blocksHere < blocks.size() && blocksHere < batchModes / modeBlock &&
               index(blocks[b + blocksHere]) == firstBlock + blocksHere)
            ++blocksHere;
        b += blocksHere;
        const std::size_t first = firstBlock * modeBlock;
        const std::size_t end = first + blocksHere * modeBlock;
        while (!runs.empty() && index(runs.front().first + runs.front().count) <= first)
            runs = runs.subspan(1);
        for (std::size_t c = 0; c < channelCount; ++c) {
            advanceBatch(from, c, first, end - first, scale, energies, ahead);
            mixRuns(runs, first, end, ahead, subBlocks, outputs[c]);
        }
    }
}

void ModalBank::advanceBatch(ModeStates& from,
                             std::size_t channel,
                             std::size_t first,
                             std::size_t modes,
                             double scale,
                             float* energies,
                             SubBlockStates& ahead) noexcept {
    // The louder channel counts.
    alignas(64) std::array<float, batchModes> others;
    float* here = energies != nullptr && channel == 0 ? energies + first : others.data();
    double* x = from.x[channel].data() + first;
    double* y = from.y[channel].data() + first;
    advanceModes(rotations(first), modes, scale, x, y, here, ahead);
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        if (g < first || g >= first + modes)
            continue;
        const std::size_t place = g - first;
        lookAtHeavy(heavy, channel, place, ahead);
        const ModalState next = heavy.cell * heavy.aside[channel];
        x[place] = scale * next.x;
        y[place] = scale * next.y;
        const double size = amplitudeBound(pole(g), {x[place], y[place]});
        here[place] = static_cast<float>(size * size);
    }
    if (energies != nullptr && channel > 0)
        for (std::size_t k = 0; k < modes; ++k)
            energies[first + k] = std::max(energies[first + k], here[k]);
}

void ModalBank::addMoved(const ModeStates& others,
                         std::size_t samples,
                         double factor,
                         ModeStates& sum) noexcept {
    setAside(sum);
    for (std::size_t c = 0; c < channelCount; ++c) {
        const double* x = others.x[c].data();
        const double* y = others.y[c].data();
        double* sumX = sum.x[c].data();
        double* sumY = sum.y[c].data();
        if (samples == cellSize) {
            for (std::size_t g = 0; g < paddedSize(); ++g) {
                sumX[g] += factor * (cellRe[g] * x[g] - cellIm[g] * y[g]);
                sumY[g] += factor * (cellRe[g] * y[g] + cellIm[g] * x[g]);
            }
        } else {
            addMovedModes({sampleRe.data(), sampleIm.data(), turnRe.data(), turnIm.data()},
                          paddedSize(), samples, factor, x, y, sumX, sumY);
        }
        for (const HeavyMode& heavy : heavyModes) {
            const std::size_t g = index(heavy.mode);
            const ModalState moved =
                propagator(pole(g), static_cast<double>(samples) * sampleSeconds) *
                ModalState{x[g], y[g]};
            sumX[g] = heavy.aside[c].x + factor * moved.x;
            sumY[g] = heavy.aside[c].y + factor * moved.y;
        }
    }
}

void ModalBank::join(const ModeStates& others, std::size_t samples, double factor) noexcept {
    addMoved(others, samples, factor, states);
    measureStates(states, energy.data());
}

void ModalBank::measureStates(const ModeStates& others, float* energies) const noexcept {
    for (std::size_t c = 0; c < channelCount; ++c) {
        const double* x = others.x[c].data();
        const double* y = others.y[c].data();
        for (std::size_t g = 0; g < paddedSize(); ++g) {
            const auto size = static_cast<float>(x[g] * x[g] + y[g] * y[g]);
            energies[g] = c == 0 ? size : std::max(energies[g], size);
        }
    }
    for (const HeavyMode& heavy : heavyModes) {
        const double size = amplitude(others, index(heavy.mode));
        energies[index(heavy.mode)] = static_cast<float>(size * size);
    }
}

void ModalBank::rotate(ModeStates& from, double seconds, double factor) noexcept {
    setAside(from);
    for (std::size_t c = 0; c < channelCount; ++c) {
        turnModes(decay.data(), frequency.data(), paddedSize(), seconds, factor, from.x[c].data(),
                  from.y[c].data());
        for (const HeavyMode& heavy : heavyModes) {
            const std::size_t g = index(heavy.mode);
            const ModalState moved = propagator(pole(g), seconds) * heavy.aside[c];
            from.x[c][g] = factor * moved.x;
            from.y[c][g] = factor * moved.y;
        }
    }
}

void ModalBank::forcedStates(const PulseInstant& pulse,
                             double* x,
                             double* y,
                             double* steady,
                             double* swingRe,
                             double* swingIm) const noexcept {
    idiophone::forcedStates(pulse,
                            {stiffness.data(), damping.data(), displacementShare.data(),
                             velocityShare.data(), x, y, steady, swingRe, swingIm},
                            paddedSize());
}

void ModalBank::impulseStates(double* x, double* y) const noexcept {
    std::fill_n(x, paddedSize(), 1.0);
    std::copy_n(velocityShare.data(), paddedSize(), y);
}

void ModalBank::force(std::span<const float, cellSize> impulses,
                      const float* startResidues,
                      const float* endResidues,
                      double dampingPerSecond,
                      std::size_t channel) noexcept {
    const double fall = std::exp(-dampingPerSecond * sampleSeconds);
    forceModes({sampleRe.data(), sampleIm.data(), velocityShare.data(), startResidues, endResidues},
               impulses.data(), static_cast<float>(fall), paddedSize(), states.x[channel].data(),
               states.y[channel].data());
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        const Propagator sample = propagator(pole(g), sampleSeconds);
        const auto start = static_cast<double>(startResidues[g]);
        const auto way = static_cast<double>(endResidues[g]) - start;
        ModalState moving;
        for (std::size_t k = 0; k < cellSize; ++k) {
            const double residue =
                start + way * static_cast<double>(shareOfWay(k / subBlockSamples));
            moving.x += residue * static_cast<double>(impulses[k]);
            moving = sample * moving;
            moving = {fall * moving.x, fall * moving.y};
        }
        // SIMD, with ρ = 0, left these states alone.
        states.x[channel][g] += moving.x;
        states.y[channel][g] += moving.y;
    }
}

} // namespace idiophone
