// The poles, coefficients and states of one object's modes (groups of merged modes) in arrays for
// the SIMD loops. It moves and renders them; which of them sound is decided elsewhere.
#pragma once

#include "Synth/AlignedVector.h"
#include "Synth/KickKernel.h"
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

/// A part of what a mode sounds.
struct ModePart {
    std::int32_t mode = 0;
    float share = 1;
};

/// States of all modes of a bank for each channel.
struct ModeStates {
    std::array<AlignedVector<double>, mostChannels> x;
    std::array<AlignedVector<double>, mostChannels> y;
};

/// Complex residues of the modes in one channel, zero in the padding: a mode whose state is s
/// sounds Re(r s), so that the imaginary part hears the acceleration over the frequency.
struct ChannelResidues {
    AlignedVector<float> re;
    AlignedVector<float> im;

    void resize(std::size_t modes) {
        re.resize(modes);
        im.resize(modes);
    }
    /// Copies the first `modes`, for which there is room.
    void copyFrom(const ChannelResidues& other, std::size_t modes) noexcept {
        std::copy_n(other.re.begin(), modes, re.begin());
        std::copy_n(other.im.begin(), modes, im.begin());
    }
};
using ModeResidues = std::array<ChannelResidues, mostChannels>;

/// States that a contact adds to all modes of a bank, and their |s|² (or the square of their bound)
/// in the louder channel.
struct ModeKicks {
    std::array<AlignedVector<float>, mostChannels> x;
    std::array<AlignedVector<float>, mostChannels> y;
    AlignedVector<float> energies;
};

/// What a contact does to modes of residue 1: the state of its forced part at one instant, and the
/// amplitudes of what of it is heard (StrikeKernel.h).
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

/// What of one mode's state goes to another: its share of it.
struct ModeShare {
    std::int32_t from = 0;
    std::int32_t to = 0;
    double share = 0;
};

/// A time between two samples: the share of a sample that is left to the later one (below 1), and
/// what states are multiplied by on the way there beside their free motion.
struct BeforeSample {
    double samples = 0;
    double factor = 1;
};

/// Where each channel is added to.
using ChannelOutputs = std::array<float*, mostChannels>;

/// A cell of each channel.
using CellSound = std::array<std::array<float, cellSize>, mostChannels>;

inline ChannelOutputs outputsOf(CellSound& sound) noexcept {
    return {sound[0].data(), sound[1].data()};
}

/// Memory is reserved by the constructor; every other member is for the audio thread. Modes are
/// held in blocks of `modeBlock`; those beyond `size` are silent.
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
    ModeStates emptyStates() const; ///< allocates
    ModeKicks emptyKicks() const;   ///< allocates

    /// Channels in use, at most the capacity; those that join start as copies of the first. States
    /// elsewhere are read and written for as many.
    std::size_t channels() const noexcept { return channelCount; }
    void setChannels(std::size_t wanted) noexcept;

    /// Starts anew with so many modes, all silent; `movePoles` gives them their poles.
    void resize(std::size_t modes) noexcept;

    /// The modes become `modes` others, each of which takes over what `shares` (ascending in both)
    /// give it: where those of each mode sum to 1 nothing steps. Every mode to come has a share.
    /// `room` is for states of this bank, and left with anything; `movePoles` is to follow.
    void regroup(std::size_t modes, std::span<const ModeShare> shares, ModeStates& room) noexcept;

    /// Gives every mode the pole that `law` makes of its reference eigenvalue [size] and damping
    /// ([size], or empty: the law's). States stay, so that the velocity does not step; where the
    /// coordinates change near critical damping, velocity and displacement stay. Modes outside
    /// `lowestHz` ≤ f < `highestHz` (natural frequency) become inaudible, and so do `silenced` ones
    /// ([size] not 0, or empty: none).
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

    /// |s|² in the louder channel [paddedSize], and (`amplitudeBound`)² of modes that do not
    /// oscillate: of the states as they are, but after `render`, for modes that oscillate, of those
    /// at the start of the cell times `scale`.
    const float* energies() const noexcept { return energy.data(); }
    const float* audibleWeights() const noexcept { return audibles.data(); }
    float energyOfLoudest(std::size_t block) const noexcept;

    /// Free motion of one block over any time, times `factor`, exact, then `clearFaint`.
    void advanceBlock(std::size_t block, double seconds, double factor, double faintest) noexcept;
    /// States below `faintest` [m/s], or beyond all reason, become zero.
    void clearFaint(std::size_t block, double faintest) noexcept;

    /// Adds a cell of the modes in `runs` to `output` and takes the states of `blocks` (ascending,
    /// holding all of `runs`) on by a cell, times `scale`. `parts` (ascending) of these modes are
    /// added to `partOutputs` besides.
    void render(std::span<const std::int32_t> blocks,
                std::span<const ModeRun> runs,
                double scale,
                const ChannelOutputs& outputs,
                std::span<const ModePart> parts = {},
                const ChannelOutputs& partOutputs = {}) noexcept;

    /// The same from other states, which are taken on; their energies are not kept.
    void renderFrom(ModeStates& from,
                    std::span<const ModeRun> runs,
                    const ChannelOutputs& outputs) noexcept;

    // ModalBankContact.cpp. Kicks, residues and contacts have room for this bank.

    /// Modes that do not oscillate have no phase: their residues become real, of the same size.
    void makeHeavyReal(ModeResidues& residues) const noexcept;

    /// Returns the sound of an impulse at once in each channel, beside the motion of the modes in
    /// `runs`: with it, and half of the first sample of that motion, a force that rests sounds
    /// nothing, as velocity and acceleration are 0. About Σ Im r/(ω × the sample's time).
    std::array<float, mostChannels> directSound(const ModeResidues& residues,
                                                std::span<const ModeRun> runs) const noexcept;

    /// The forced part of a contact, or the motion after an impulse.
    void forcedStates(const PulseInstant& pulse, UnitContact& unit) const noexcept;
    void impulseStates(UnitContact& unit) const noexcept;

    /// Kicks become residues times the unit's states, taken on to a whole sample.
    void startKicks(const UnitContact& unit,
                    const ModeResidues& residues,
                    const BeforeSample& before,
                    ModeKicks& kicks) const noexcept;

    /// Kicks become none, and grow by residues times the unit's states times `factor`.
    void clearKicks(ModeKicks& kicks) const noexcept;
    /// With what the contact's force `share` (0 to 2, of 1/T) sounds at once.
    void gatherKicks(const UnitContact& unit,
                     const ModeResidues& residues,
                     double factor,
                     double share,
                     ModeKicks& kicks) const noexcept;

    /// Kicks become those of the whole contact, started and ended. Their energies stay behind.
    void finishKicks(const UnitContact& unit,
                     const ModeResidues& residues,
                     const BeforeSample& before,
                     const KickMove& contact,
                     ModeKicks& kicks) const noexcept;

    /// Adds moved kicks to the states.
    void join(const ModeKicks& kicks, const KickMove& move) noexcept;

    /// Adds the first 16 · `subBlockCount` samples (at most a cell) that `runs` sound from kicks,
    /// and `parts` of them as `render` does.
    void sound(const ModeKicks& kicks,
               std::span<const ModeRun> runs,
               std::size_t subBlockCount,
               const ChannelOutputs& outputs,
               std::span<const ModePart> parts = {},
               const ChannelOutputs& partOutputs = {}) noexcept;

    /// Adds to the states, at the end of a cell, what 64 impulses did to them, one at each sample,
    /// with residues that go from start to end (ForceKernel.h).
    void force(std::span<const float, cellSize> impulses,
               const ModeResidues& startResidues,
               const ModeResidues& endResidues,
               double dampingPerSecond) noexcept;

    /// Frequencies of lightly damped modes within the band in Hz, ascending, silenced or not: those
    /// that a contact time must keep clear of.
    std::span<const double> resonances() const noexcept { return resonancesHz; }

private:
    /// Modes that do not oscillate: a 2 × 2 propagator over 16 and 64 samples each.
    struct HeavyMode {
        std::int32_t mode = 0;
        Propagator subBlock;
        Propagator cell;
        std::array<ModalState, mostChannels> aside; ///< its states while SIMD passes over them
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
    KickModes kickModes() const noexcept;
    void forgetHeavy() noexcept;
    /// Those of modes `first` to `end` − 1, which are whole blocks.
    std::span<HeavyMode> heavyIn(std::size_t first, std::size_t end) noexcept {
        const std::size_t from = firstHeavy[first / modeBlock];
        return std::span(heavyModes).subspan(from, firstHeavy[end / modeBlock] - from);
    }
    /// Keeps the states of heavy modes, of any kind of states.
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
    static void lookAtHeavy(const HeavyMode& heavy,
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

    std::vector<HeavyMode> heavyModes;      ///< ascending
    std::vector<std::size_t> firstHeavy;    ///< of each block and those after it, in `heavyModes`
    std::vector<std::int32_t> blockNumbers; ///< 0, 1, 2, …
};

} // namespace idiophone
