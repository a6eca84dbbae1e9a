// The poles, coefficients and states of one object's modes (or groups of merged modes), in arrays
// for the SIMD loops. The bank moves and renders modes; its owner decides which of them sound.
#pragma once

#include "Synth/AlignedVector.h"
#include "Synth/IncrementKernel.h"
#include "Synth/ModalBankKernel.h"
#include "Synth/ModalPole.h"
#include "Synth/StrikeKernel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Modes first to first + count − 1.
struct ModeRun {
    std::int32_t first = 0;
    std::int32_t count = 0;
};

/// Replaces `runs` by the runs of consecutive numbers in ascending `modes`.
void findRuns(std::span<const std::int32_t> modes, std::vector<ModeRun>& runs) noexcept;

/// A share of a mode's sound.
struct ModePart {
    std::int32_t mode = 0;
    float share = 1;
};

struct ModeStates {
    std::array<AlignedVector<double>, maximumChannels> x;
    std::array<AlignedVector<double>, maximumChannels> y;
};

/// Complex residues of the modes in one channel, zero in the padding. A mode of state s sounds Re(r
/// s), so the imaginary part hears the acceleration over the frequency.
struct ChannelResidues {
    AlignedVector<float> re;
    AlignedVector<float> im;

    void resize(std::size_t modes) {
        re.resize(modes);
        im.resize(modes);
    }
    /// Copies the first `modes`, which must fit.
    void copyFrom(const ChannelResidues& other, std::size_t modes) noexcept {
        std::copy_n(other.re.begin(), modes, re.begin());
        std::copy_n(other.im.begin(), modes, im.begin());
    }
};
using ModeResidues = std::array<ChannelResidues, maximumChannels>;

/// State increments that a contact adds to all modes of a bank. `energies` is their |s|² in the
/// louder channel; for heavy modes it is the square of `amplitudeBound`.
struct StateIncrements {
    std::array<AlignedVector<float>, maximumChannels> x;
    std::array<AlignedVector<float>, maximumChannels> y;
    AlignedVector<float> energies;
};

/// The response of modes of residue 1 to a contact: the state of the forced part at one instant,
/// and its amplitudes (StrikeKernel.h).
struct UnitContact {
    AlignedVector<float> x;
    AlignedVector<float> y;
    AlignedVector<float> steady;
    AlignedVector<float> swingRe;
    AlignedVector<float> swingIm;
    AlignedVector<float> quadratureRe;
    AlignedVector<float> quadratureIm;

    ForcedAmplitudes amplitudes() const noexcept {
        return {steady.data(), swingRe.data(), swingIm.data(), quadratureRe.data(),
                quadratureIm.data()};
    }
};

/// The share of one mode's state that another mode takes over.
struct ModeShare {
    std::int32_t from = 0;
    std::int32_t to = 0;
    double share = 0;
};

/// A time between two samples. `samples` is the part of a sample up to the later one (below 1).
/// `factor` multiplies states on the way there, besides their free motion.
struct BeforeSample {
    double samples = 0;
    double factor = 1;
};

/// The buffers that each channel is added to.
using ChannelOutputs = std::array<float*, maximumChannels>;

using CellSound = std::array<std::array<float, cellSize>, maximumChannels>;

inline ChannelOutputs outputsOf(CellSound& sound) noexcept {
    return {sound[0].data(), sound[1].data()};
}

/// Memory is reserved by the constructor; every other member is for the audio thread. Modes are
/// stored in blocks of `modeBlock`; the padding beyond `size` is silent.
class ModalBank {
public:
    ModalBank(std::size_t capacity, std::size_t channelCapacity, double sampleRateHz);

    std::size_t size() const noexcept { return count; }
    std::size_t blockCount() const noexcept { return (count + modeBlock - 1) / modeBlock; }
    /// 0 to blockCount − 1.
    std::span<const std::int32_t> allBlocks() const noexcept {
        return std::span(blockNumbers).first(blockCount());
    }
    std::size_t paddedSize() const noexcept { return blockCount() * modeBlock; }
    ModeStates emptyStates() const;          ///< allocates
    StateIncrements emptyIncrements() const; ///< allocates

    /// Number of channels in use, at most the capacity. New channels start as copies of the first.
    /// States passed in are read and written for this many.
    std::size_t channels() const noexcept { return channelCount; }
    void setChannels(std::size_t wanted) noexcept;

    /// Starts again with `modes` modes, all silent. Call `movePoles` next, which sets their poles.
    void resize(std::size_t modes) noexcept;

    /// Replaces the modes by `modes` new ones, which take over the states as `shares` say (both
    /// indices ascend). If the shares of each old mode sum to 1, no velocity steps. Every new mode
    /// needs a share. `room` is scratch for states of this bank. Call `movePoles` next.
    void regroup(std::size_t modes, std::span<const ModeShare> shares, ModeStates& room) noexcept;

    /// Sets every mode's pole by `law`, from its reference eigenvalue [size] and damping ([size],
    /// or empty: the law's). States stay, so that the velocity does not step. If the coordinates
    /// change near critical damping, velocity and displacement stay. Modes outside `lowestHz` ≤ f <
    /// `highestHz` (natural frequency) become inaudible, and so do modes with `silenced` ≠ 0
    /// ([size], or empty: none).
    void movePoles(std::span<const double> referenceEigenvalues,
                   const PoleLaw& law,
                   double lowestHz,
                   double highestHz,
                   std::span<const ModeDamping> dampings = {},
                   std::span<const std::uint8_t> silenced = {}) noexcept;

    ModalPole pole(std::size_t g) const noexcept { return {stiffness[g], damping[g]}; }
    bool audible(std::size_t g) const noexcept { return audibles[g] != 0; }
    std::size_t audibleCount() const noexcept { return audibleModes; }
    ModalState state(std::size_t g, std::size_t channel = 0) const noexcept {
        return {states.x[channel][g], states.y[channel][g]};
    }
    void setState(std::size_t g, const ModalState& state, std::size_t channel = 0) noexcept;
    void silence(std::size_t g) noexcept;
    void clear() noexcept;

    /// Energies [paddedSize]: |s|² in the louder channel; for heavy modes `amplitudeBound`². They
    /// belong to the current states. After `render`, those of oscillating modes belong to the start
    /// of the cell, times `scale`.
    const float* energies() const noexcept { return energy.data(); }
    const float* audibleWeights() const noexcept { return audibles.data(); }
    float energyOfLoudest(std::size_t block) const noexcept;

    /// Moves one block by exact free motion over any time, times `factor`; then `clearFaint`.
    void advanceBlock(std::size_t block, double seconds, double factor, double faintest) noexcept;
    /// Sets states to zero that are below `faintest` [m/s], not finite or absurdly large.
    void clearFaint(std::size_t block, double faintest) noexcept;

    /// Adds a cell of the modes in `runs` to `output`. Moves the states of `blocks` (ascending,
    /// containing all of `runs`) by a cell, times `scale`. Also adds `parts` (ascending) of these
    /// modes to `partOutputs`.
    void render(std::span<const std::int32_t> blocks,
                std::span<const ModeRun> runs,
                double scale,
                const ChannelOutputs& outputs,
                std::span<const ModePart> parts = {},
                const ChannelOutputs& partOutputs = {}) noexcept;

    /// Does the same with other states and moves those; stores no energies.
    void renderFrom(ModeStates& from,
                    std::span<const ModeRun> runs,
                    const ChannelOutputs& outputs) noexcept;

    // ModalBankContact.cpp. Increments, residues and contacts must have room for this bank.

    /// Makes the residues of heavy modes real with the same magnitude, as these modes have no
    /// phase.
    void makeHeavyReal(ModeResidues& residues) const noexcept;

    /// Returns the immediate sound of an impulse in each channel, to be added to the motion of the
    /// modes in `runs`. Together with half of the motion's first sample it makes a constant force
    /// silent, as velocity and acceleration are then 0. About Σ Im r/(ω × sample time).
    std::array<float, maximumChannels> directSound(const ModeResidues& residues,
                                                   std::span<const ModeRun> runs) const noexcept;

    /// Computes the forced part of a contact, or the motion after an impulse.
    void forcedStates(const PulseInstant& pulse, UnitContact& unit) const noexcept;
    void impulseStates(UnitContact& unit) const noexcept;

    /// Sets the increments to residues times the unit's states, moved to a whole sample.
    void startIncrements(const UnitContact& unit,
                         const ModeResidues& residues,
                         const BeforeSample& before,
                         StateIncrements& increments) const noexcept;

    void clearIncrements(StateIncrements& increments) const noexcept;
    /// Adds residues times the unit's states times `factor`, with the immediate sound of the
    /// contact's force `share` (0 to 2, in units of 1/T).
    void gatherIncrements(const UnitContact& unit,
                          const ModeResidues& residues,
                          double factor,
                          double share,
                          StateIncrements& increments) const noexcept;

    /// Sets the increments to those of a whole contact, from start to end. Does not set their
    /// energies.
    void finishIncrements(const UnitContact& unit,
                          const ModeResidues& residues,
                          const BeforeSample& before,
                          const IncrementMove& contact,
                          StateIncrements& increments) const noexcept;

    /// Moves the increments and adds them to the states.
    void join(const StateIncrements& increments, const IncrementMove& move) noexcept;

    /// Adds the first 16 · `subBlockCount` samples (at most a cell) of the increments' sound over
    /// `runs`, and `parts` of them as `render` does.
    void sound(const StateIncrements& increments,
               std::span<const ModeRun> runs,
               std::size_t subBlockCount,
               const ChannelOutputs& outputs,
               std::span<const ModePart> parts = {},
               const ChannelOutputs& partOutputs = {}) noexcept;

    /// Adds the effect of 64 impulses, one per sample, to the states at the end of a cell. The
    /// residues move from start to end (ForceKernel.h).
    void force(std::span<const float, cellSize> impulses,
               const ModeResidues& startResidues,
               const ModeResidues& endResidues,
               double dampingPerSecond) noexcept;

    /// Frequencies of lightly damped modes within the band in Hz, ascending, silenced or not. A
    /// contact time must keep clear of them.
    std::span<const double> resonances() const noexcept { return resonancesHz; }

private:
    /// A mode near or beyond critical damping: a 2 × 2 propagator each over 16 and 64 samples.
    struct HeavyMode {
        std::int32_t mode = 0;
        Propagator subBlock;
        Propagator cell;
        std::array<ModalState, maximumChannels>
            aside; ///< its states while the SIMD loops pass over them
    };

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
                      std::size_t modes,
                      double scale,
                      float* energies,
                      SubBlockStates& ahead) noexcept;
    IncrementModes incrementModes() const noexcept;
    void forgetHeavy() noexcept;
    /// Returns the heavy modes among `first` to `end` − 1, which are whole blocks.
    std::span<HeavyMode> heavyIn(std::size_t first, std::size_t end) noexcept {
        const std::size_t from = firstHeavy[first / modeBlock];
        return std::span(heavyModes).subspan(from, firstHeavy[end / modeBlock] - from);
    }
    /// Saves the states of heavy modes, from any kind of states.
    template <class States>
    void setAside(const States& from, std::span<HeavyMode> modes) const noexcept {
        for (HeavyMode& heavy : modes)
            for (std::size_t c = 0; c < channelCount; ++c) {
                const auto g = static_cast<std::size_t>(heavy.mode);
                heavy.aside[c] = {from.x[c][g], from.y[c][g]};
            }
    }
    void forceHeavy(const HeavyMode& heavy,
                    std::span<const float, cellSize> impulses,
                    const ModeResidues& startResidues,
                    const ModeResidues& endResidues) noexcept;
    static void fillHeavyAhead(const HeavyMode& heavy,
                               std::size_t channel,
                               std::size_t place,
                               SubBlockStates& ahead) noexcept;
    void mixRuns(std::span<const ModeRun> runs,
                 std::size_t first,
                 std::size_t end,
                 const SubBlockStates& ahead,
                 std::size_t subBlockCount,
                 float* output) const noexcept;
    void mixParts(std::span<const ModePart> parts,
                  std::size_t first,
                  std::size_t end,
                  SubBlockStates& ahead,
                  std::size_t subBlockCount,
                  float* output) const noexcept;
    ModeRotations rotations(std::size_t first) const noexcept;
    void correctHeavy(std::size_t g) noexcept;
    void measure(std::size_t g) noexcept;
    void measureModes(std::size_t first, std::size_t end) noexcept;

    double sampleSeconds;
    std::size_t count = 0;
    std::size_t channelCount = 1;
    std::size_t audibleModes = 0;

    AlignedVector<double> stiffness, damping, decay, frequency, velocityShare;
    std::vector<double> resonancesHz;
    AlignedVector<float> audibles;
    AlignedVector<float> tables; ///< [G,2,16]
    AlignedVector<float> halfTurnsPerSample, octavesPerSample;
    AlignedVector<float> sampleRe, sampleIm, subBlockRe, subBlockIm;
    AlignedVector<double> cellRe, cellIm;
    ModeStates states;
    AlignedVector<float> energy;

    std::vector<HeavyMode> heavyModes; ///< ascending
    std::vector<std::size_t>
        firstHeavy; ///< index in `heavyModes` of the first one in each block or after it
    std::vector<std::int32_t> blockNumbers; ///< 0, 1, 2, …
};

} // namespace idiophone
