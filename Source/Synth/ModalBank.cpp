// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModalBank.h"

#include "Synth/ForceKernel.h"
#include "Synth/IncrementKernel.h"
#include "Synth/ModeMix.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace idiophone {

ModalBank::ModalBank(std::size_t capacity, std::size_t channelsReserved, double sampleRateHz)
    : modes(capacity, sampleRateHz), channelCapacity(channelsReserved),
      states(modes.paddedSize(), channelsReserved), energy(modes.paddedSize()),
      blockNumbers(modes.blockCount()) {
    std::iota(blockNumbers.begin(), blockNumbers.end(), 0);
}

StateIncrements ModalBank::emptyIncrements() const {
    return {energy.size(), channelCapacity};
}

void ModalBank::setChannels(std::size_t wanted) noexcept {
    for (; channelCount < std::min(wanted, channelCapacity); ++channelCount) {
        std::ranges::copy(states.x[0], states.x[channelCount].begin());
        std::ranges::copy(states.y[0], states.y[channelCount].begin());
    }
    channelCount = std::min(channelCount, wanted);
}

void ModalBank::clear() noexcept {
    for (auto* arrays : {&states.x, &states.y})
        for (auto& array : *arrays)
            std::ranges::fill(array, 0.0);
    std::ranges::fill(energy, 0.0f);
}

void ModalBank::regroup(std::size_t count,
                        std::span<const ModeShare> shares,
                        ModeStates& room) noexcept {
    for (std::size_t c = 0; c < channelCount; ++c) {
        std::fill_n(room.x[c].begin(), energy.size(), 0.0);
        std::fill_n(room.y[c].begin(), energy.size(), 0.0);
    }
    std::int32_t last = -1;
    ModalPole after;
    for (const ModeShare& taken : shares) {
        const ModalPole before = pole(index(taken.from));
        if (std::exchange(last, taken.to) != taken.to)
            after = before;
        const bool sameKind = isOscillating(before) == isOscillating(after);
        for (std::size_t c = 0; c < channelCount; ++c) {
            const ModalState old = state(index(taken.from), c);
            const ModalState moved = sameKind ? old : stateOf(after, motionOf(before, old));
            room.x[c][index(taken.to)] += taken.share * moved.x;
            room.y[c][index(taken.to)] += taken.share * moved.y;
        }
    }
    modes.regroup(count, shares);
    for (std::size_t c = 0; c < channelCount; ++c) {
        std::copy_n(room.x[c].begin(), energy.size(), states.x[c].begin());
        std::copy_n(room.y[c].begin(), energy.size(), states.y[c].begin());
    }
    for (std::size_t g = 0; g < energy.size(); ++g)
        energy[g] = states.energy(g, pole(g), channelCount);
}

void ModalBank::movePoles(std::span<const double> referenceEigenvalues,
                          const PoleLaw& law,
                          double lowestHz,
                          double highestHz,
                          std::span<const ModeDamping> dampings,
                          std::span<const std::uint8_t> silenced) noexcept {
    const bool hadHeavy = modes.hadHeavy();
    modes.set(law, referenceEigenvalues, dampings);
    modes.update({lowestHz, highestHz}, silenced);
    for (std::size_t g = 0; g < size() && (hadHeavy || modes.hadHeavy()); ++g) {
        const ModalPole former = modes.formerPole(g), moved = pole(g);
        if (energy[g] > 0 && isOscillating(moved) != isOscillating(former))
            for (std::size_t c = 0; c < channelCount; ++c)
                states.set(g, c, stateOf(moved, motionOf(former, state(g, c))));
    }
    modes.heavy().measure(0, size(), states, channelCount, energy);
}

void ModalBank::prepare(std::span<const ModeRun> runs) noexcept {
    for (const ModeRun& run : runs)
        for (std::size_t block = index(run.first) / modeBlock;
             block * modeBlock < index(run.first + run.count); ++block)
            modes.prepare(block);
}

void ModalBank::setState(std::size_t g, const ModalState& state, std::size_t channel) noexcept {
    states.set(g, channel, state);
    energy[g] = states.energy(g, pole(g), channelCount);
}

void ModalBank::silence(std::size_t g) noexcept {
    for (std::size_t c = 0; c < channelCount; ++c)
        states.set(g, c, {});
    energy[g] = 0;
}

float ModalBank::energyOfLoudest(std::size_t block) const noexcept {
    const float* first = energy.data() + block * modeBlock;
    return *std::max_element(first, first + modeBlock);
}

void ModalBank::clearFaint(std::size_t block) noexcept {
    for (std::size_t g = block * modeBlock; g < (block + 1) * modeBlock; ++g)
        if (!(static_cast<double>(energy[g]) > faintestVelocity * faintestVelocity &&
              energy[g] < largestEnergy))
            silence(g);
}

void ModalBank::advanceBlock(std::size_t block, double seconds, double factor) noexcept {
    const std::size_t first = block * modeBlock;
    const std::size_t end = first + modeBlock;
    modes.heavy().save(states, first, end, channelCount);
    moveStates(modes.arrays(), {seconds, seconds / modes.sampleSeconds(), -std::log2(factor)},
               first, modeBlock, channelCount, states, energy);
    modes.heavy().advance(first, end, seconds, factor, channelCount, states);
    modes.heavy().measure(first, end, states, channelCount, energy);
    clearFaint(block);
}

void ModalBank::renderFrom(ModeStates& from,
                           std::span<const ModeRun> runs,
                           const ChannelOutputs& outputs) noexcept {
    if (runs.empty())
        return;
    prepare(runs);
    const std::size_t first = index(runs.front().first) / modeBlock;
    const std::size_t last = index(runs.back().first + runs.back().count - 1) / modeBlock;
    renderStates(from, nullptr, std::span(blockNumbers).subspan(first, last - first + 1), runs, 1,
                 outputs, {}, {});
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
        modes.heavy().save(from, first, end, channelCount);
        while (!runs.empty() && index(runs.front().first + runs.front().count) <= first)
            runs = runs.subspan(1);
        const MixBatch batch{modes.arrays().tables.data(), first, end, subBlocks};
        for (std::size_t c = 0; c < channelCount; ++c) {
            advanceBatch(from, c, first, end, scale, energies, ahead);
            batch.mix(runs, ahead, outputs[c]);
            batch.mix(parts, ahead, partOutputs[c]);
        }
    }
}

void ModalBank::advanceBatch(ModeStates& from,
                             std::size_t channel,
                             std::size_t first,
                             std::size_t end,
                             double scale,
                             float* energies,
                             SubBlockStates& ahead) noexcept {
    // Keep the energy of the louder channel.
    alignas(64) std::array<float, batchModes> others;
    float* here = energies != nullptr && channel == 0 ? energies + first : others.data();
    advanceModes(modes.rotations(first), end - first, scale, from.x[channel].data() + first,
                 from.y[channel].data() + first, here, ahead);
    modes.heavy().advanceCell(first, end, scale, channel, from, here, ahead);
    if (energies != nullptr && channel > 0)
        for (std::size_t g = first; g < end; ++g)
            energies[g] = std::max(energies[g], here[g - first]);
}

void ModalBank::join(const StateIncrements& increments, const IncrementMove& move) noexcept {
    modes.heavy().save(states, 0, size(), channelCount);
    joinIncrements(modes.arrays(), move, increments, paddedSize(), channelCount, states, energy);
    modes.heavy().join(increments, move, channelCount, states);
    modes.heavy().measure(0, size(), states, channelCount, energy);
}

void ModalBank::force(std::span<const float, cellSize> impulses,
                      const ModeResidues& startResidues,
                      const ModeResidues& endResidues,
                      double dampingPerSecond) noexcept {
    // The damper has attenuated each impulse by the end of the cell.
    alignas(64) std::array<float, cellSize> fallen;
    std::ranges::copy(impulses, fallen.begin());
    if (dampingPerSecond > 0) {
        const double fall = std::exp(-dampingPerSecond * modes.sampleSeconds());
        double factor = 1;
        for (std::size_t k = cellSize; k-- > 0;)
            fallen[k] *= static_cast<float>(factor *= fall);
    }
    modes.heavy().save(states, 0, size(), channelCount);
    for (const std::int32_t block : allBlocks())
        modes.prepare(index(block));
    forceModes(modes.arrays(), fallen.data(), startResidues, endResidues, paddedSize(),
               channelCount, states, energy);
    modes.heavy().force(fallen, startResidues, endResidues, channelCount, states);
    modes.heavy().measure(0, size(), states, channelCount, energy);
}

} // namespace idiophone
