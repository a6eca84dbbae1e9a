// Free motion and sound of a modal bank.
#include "Synth/ModalBank.h"
#include "Synth/ModeIndex.h"
#include "Synth/PoleKernel.h"

#include <algorithm>
#include <array>

namespace idiophone {

void ModalBank::advanceBlock(std::size_t block,
                             double seconds,
                             double factor,
                             double faintest) noexcept {
    const std::size_t first = block * modeBlock;
    const std::span<HeavyMode> heavyHere = heavyIn(first, first + modeBlock);
    setAside(states, heavyHere);
    for (std::size_t c = 0; c < channelCount; ++c)
        rotateModes(decay.data() + first, frequency.data() + first, modeBlock, seconds, factor,
                    states.x[c].data() + first, states.y[c].data() + first);
    for (const HeavyMode& heavy : heavyHere) {
        const std::size_t g = index(heavy.mode);
        const Propagator motion = propagator(pole(g), seconds);
        for (std::size_t c = 0; c < channelCount; ++c) {
            const ModalState moved = motion * heavy.aside[c];
            states.x[c][g] = factor * moved.x;
            states.y[c][g] = factor * moved.y;
        }
    }
    measureModes(first, first + modeBlock);
    clearFaint(block, faintest);
}

void ModalBank::render(std::span<const std::int32_t> blocks,
                       std::span<const ModeRun> runs,
                       double scale,
                       const ChannelOutputs& outputs,
                       std::span<const ModePart> parts,
                       const ChannelOutputs& partOutputs) noexcept {
    renderStates(states, energy.data(), blocks, runs, scale, outputs, parts, partOutputs);
}

void ModalBank::renderFrom(ModeStates& from,
                           std::span<const ModeRun> runs,
                           const ChannelOutputs& outputs) noexcept {
    if (runs.empty())
        return;
    const std::size_t first = index(runs.front().first) / modeBlock;
    const std::size_t last = index(runs.back().first + runs.back().count - 1) / modeBlock;
    renderStates(from, nullptr, std::span(blockNumbers).subspan(first, last - first + 1), runs, 1,
                 outputs, {}, {});
}

ModeRotations ModalBank::rotations(std::size_t first) const noexcept {
    return {subBlockRe.data() + first, subBlockIm.data() + first, cellRe.data() + first,
            cellIm.data() + first};
}

/// Fills in the states of a heavy mode at the start of each sub-block, from the saved one.
void ModalBank::fillHeavyAhead(const HeavyMode& heavy,
                               std::size_t channel,
                               std::size_t place,
                               SubBlockStates& ahead) noexcept {
    ModalState moving = heavy.aside[channel];
    for (std::size_t k = 0; k < subBlocks; ++k) {
        ahead.x[k][place] = static_cast<float>(moving.x);
        ahead.y[k][place] = static_cast<float>(moving.y);
        moving = heavy.subBlock * moving;
    }
}

/// Mixes the part of `runs` within modes `first` to `end` − 1, whose states are in `ahead`.
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

/// Does the same for parts of modes; scales their states in `ahead`.
void ModalBank::mixParts(std::span<const ModePart> parts,
                         std::size_t first,
                         std::size_t end,
                         SubBlockStates& ahead,
                         std::size_t subBlockCount,
                         float* output) const noexcept {
    for (const ModePart& part : parts) {
        const std::size_t g = index(part.mode);
        if (g < first || g >= end)
            continue;
        const std::size_t place = g - first;
        for (std::size_t b = 0; b < subBlockCount; ++b) {
            ahead.x[b][place] *= part.share;
            ahead.y[b][place] *= part.share;
        }
        mixModes(tables.data() + 2 * subBlockSamples * g, ahead, place, 1, subBlockCount, output);
    }
}

void ModalBank::renderStates(ModeStates& from,
                             float* energies,
                             std::span<const std::int32_t> blocks,
                             std::span<const ModeRun> runs,
                             double scale,
                             const ChannelOutputs& outputs,
                             std::span<const ModePart> parts,
                             const ChannelOutputs& partOutputs) noexcept {
    SubBlockStates ahead;
    for (std::size_t b = 0; b < blocks.size();) {
        // A batch is as many consecutive blocks as fit.
        const std::size_t firstBlock = index(blocks[b]);
        std::size_t blocksHere = 1;
        while (b + blocksHere < blocks.size() && blocksHere < batchModes / modeBlock &&
               index(blocks[b + blocksHere]) == firstBlock + blocksHere)
            ++blocksHere;
        b += blocksHere;
        const std::size_t first = firstBlock * modeBlock;
        const std::size_t end = first + blocksHere * modeBlock;
        setAside(from, heavyIn(first, end));
        while (!runs.empty() && index(runs.front().first + runs.front().count) <= first)
            runs = runs.subspan(1);
        for (std::size_t c = 0; c < channelCount; ++c) {
            advanceBatch(from, c, first, end - first, scale, energies, ahead);
            mixRuns(runs, first, end, ahead, subBlocks, outputs[c]);
            mixParts(parts, first, end, ahead, subBlocks, partOutputs[c]);
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
    // Keep the energy of the louder channel.
    alignas(64) std::array<float, batchModes> others;
    float* here = energies != nullptr && channel == 0 ? energies + first : others.data();
    double* x = from.x[channel].data() + first;
    double* y = from.y[channel].data() + first;
    advanceModes(rotations(first), modes, scale, x, y, here, ahead);
    for (const HeavyMode& heavy : heavyIn(first, first + modes)) {
        const std::size_t g = index(heavy.mode);
        const std::size_t place = g - first;
        fillHeavyAhead(heavy, channel, place, ahead);
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

} // namespace idiophone
