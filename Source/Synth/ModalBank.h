// SPDX-License-Identifier: Apache-2.0
// The states of one object's modes (or groups of merged modes). The bank moves and renders modes;
// its owner decides which of them sound.
#pragma once

#include "Synth/ModePoles.h"

#include <cstdint>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread.
class ModalBank {
public:
    /// Starts with `capacity` silent modes. Call `movePoles` next, which sets their poles.
    ModalBank(std::size_t capacity, std::size_t channelCapacity, double sampleRateHz);

    std::size_t size() const noexcept { return modes.size(); }
    std::size_t blockCount() const noexcept { return modes.blockCount(); }
    std::size_t paddedSize() const noexcept { return modes.paddedSize(); }
    /// 0 to blockCount − 1.
    std::span<const std::int32_t> allBlocks() const noexcept {
        return std::span(blockNumbers).first(blockCount());
    }
    const ModePoles& poles() const noexcept { return modes; }
    ModalPole pole(std::size_t g) const noexcept { return modes.pole(g); }
    StateIncrements emptyIncrements() const; ///< allocates

    /// Number of channels in use, at most the capacity. New channels start as copies of the first.
    /// Functions read and write passed states in this many channels.
    std::size_t channels() const noexcept { return channelCount; }
    void setChannels(std::size_t wanted) noexcept;

    /// Replaces the modes by `count` new ones, which take over the states as `shares` say (both
    /// indices ascend). If the shares of each old mode sum to 1, no velocity steps. Every new mode
    /// needs a share. `room` is scratch for states of this bank. Call `movePoles` next.
    void regroup(std::size_t count, std::span<const ModeShare> shares, ModeStates& room) noexcept;

    /// Sets every mode's pole by `law`, from its reference eigenvalue [size] and damping ([size],
    /// or empty: the law's). The states are kept, so that the velocity does not step. If the
    /// coordinates change near critical damping, velocity and displacement are kept. Modes outside
    /// `lowestHz` ≤ f < `highestHz` (natural frequency) become inaudible, and so do modes with
    /// `silenced` ≠ 0 ([size], or empty: none).
    void movePoles(std::span<const double> referenceEigenvalues,
                   const PoleLaw& law,
                   double lowestHz,
                   double highestHz,
                   std::span<const ModeDamping> dampings = {},
                   std::span<const std::uint8_t> silenced = {}) noexcept;

    /// Computes the rotations of these modes, unless they belong to the poles already. Members that
    /// render or force do so themselves.
    void prepare(std::span<const ModeRun> runs) noexcept;

    ModalState state(std::size_t g, std::size_t channel = 0) const noexcept {
        return states.at(g, channel);
    }
    void setState(std::size_t g, const ModalState& state, std::size_t channel = 0) noexcept;
    void silence(std::size_t g) noexcept;
    void clear() noexcept;

    /// Energies [paddedSize]: |s|² in the louder channel; for heavy modes `amplitudeBound`². They
    /// belong to the current states. After `render`, those of oscillating modes belong to the start
    /// of the cell, times `scale`.
    const float* energies() const noexcept { return energy.data(); }
    float energyOfLoudest(std::size_t block) const noexcept;

    /// Moves one block by free motion over any time, times `factor`, with a relative error of
    /// single precision; then `clearFaint`.
    void advanceBlock(std::size_t block, double seconds, double factor) noexcept;
    /// Sets states to zero that are below `faintestVelocity`, not finite or absurdly large.
    void clearFaint(std::size_t block) noexcept;

    /// Adds a cell of the modes in `runs` to `output`. Moves the states of `blocks` (ascending,
    /// containing all of `runs`) by a cell, times `scale`. Also adds `parts` (ascending) of these
    /// modes to `partOutputs`.
    void render(std::span<const std::int32_t> blocks,
                std::span<const ModeRun> runs,
                double scale,
                const ChannelOutputs& outputs,
                std::span<const ModePart> parts = {},
                const ChannelOutputs& partOutputs = {}) noexcept {
        for (const std::int32_t block : blocks)
            modes.prepare(index(block));
        renderStates(states, energy.data(), blocks, runs, scale, outputs, parts, partOutputs);
    }

    /// Renders other states in the same way and moves those. Stores no energies.
    void renderFrom(ModeStates& from,
                    std::span<const ModeRun> runs,
                    const ChannelOutputs& outputs) noexcept;

    /// Moves the increments and adds them to the states.
    void join(const StateIncrements& increments, const IncrementMove& move) noexcept;

    /// Adds the effect of 64 impulses, one per sample, to the states at the end of a cell. The
    /// residues move from start to end (ForceKernel.h).
    void force(std::span<const float, cellSize> impulses,
               const ModeResidues& startResidues,
               const ModeResidues& endResidues,
               double dampingPerSecond) noexcept;

private:
    void renderStates(ModeStates& from,
                      float* energies,
                      std::span<const std::int32_t> blocks,
                      std::span<const ModeRun> runs,
                      double scale,
                      const ChannelOutputs& outputs,
                      std::span<const ModePart> parts,
                      const ChannelOutputs& partOutputs) noexcept;
    void advanceBatch(ModeStates& from,
                      std::size_t channel,
                      std::size_t first,
                      std::size_t end,
                      double scale,
                      float* energies,
                      SubBlockStates& ahead) noexcept;

    ModePoles modes;
    std::size_t channelCount = 1;
    std::size_t channelCapacity;
    ModeStates states;
    AlignedVector<float> energy;
    std::vector<std::int32_t> blockNumbers; ///< 0, 1, 2, …
};

} // namespace idiophone
