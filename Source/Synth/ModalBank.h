// The poles, coefficients and states of one object's modes (groups of merged modes) in arrays for
// the SIMD loops. It moves and renders them; which of them sound is decided elsewhere.
#pragma once

#include "Synth/AlignedVector.h"
#include "Synth/ModalBankKernel.h"
#include "Synth/ModalPole.h"
#include "Synth/StrikeKernel.h"

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

/// States of all modes of a bank, apart from its own: kicks under way, copies to fade.
struct ModeStates {
    AlignedVector<double> x;
    AlignedVector<double> y;
};

/// Memory is reserved by the constructor; every other member is for the audio thread. Modes are
/// held in blocks of `modeBlock`; those beyond `size` are silent.
class ModalBank {
public:
    ModalBank(std::size_t capacity, double sampleRateHz);

    std::size_t size() const noexcept { return count; }
    std::size_t blockCount() const noexcept { return (count + modeBlock - 1) / modeBlock; }
    std::size_t paddedSize() const noexcept { return blockCount() * modeBlock; }
    ModeStates emptyStates() const; ///< allocates

    /// Starts anew with so many modes, all silent; `movePoles` gives them their poles.
    void resize(std::size_t modes) noexcept;

    /// Gives every mode the pole that `law` makes of its reference eigenvalue [size]. States stay
    /// (DESIGN 5, State: no step in the velocity); where the coordinates change near critical
    /// damping, velocity and displacement stay. Modes outside `lowestHz` ≤ f < `highestHz` (natural
    /// frequency) become inaudible.
    void movePoles(std::span<const double> referenceEigenvalues,
                   const PoleLaw& law,
                   double lowestHz,
                   double highestHz) noexcept;

    ModalPole pole(std::size_t g) const noexcept { return {stiffness[g], damping[g]}; }
    bool audible(std::size_t g) const noexcept { return audibles[g] != 0; }
    ModalState state(std::size_t g) const noexcept { return {states.x[g], states.y[g]}; }
    double amplitude(std::size_t g) const noexcept { return amplitudeBound(pole(g), state(g)); }

    void setState(std::size_t g, const ModalState& state) noexcept;
    void add(std::size_t g, const ModalState& state) noexcept;
    void clear() noexcept;

    /// |s|² as of the last cell or `setState` [paddedSize].
    const float* energies() const noexcept { return energy.data(); }
    const float* audibleWeights() const noexcept { return audibles.data(); }
    float energyOfLoudest(std::size_t block) const noexcept;

    /// Free motion of one block over any time, times `factor`, exact, then `clearFaint`.
    void advanceBlock(std::size_t block, double seconds, double factor, double floor) noexcept;
    /// States below `floor`, or beyond all reason, become zero.
    void clearFaint(std::size_t block, double floor) noexcept;

    /// Adds a cell of the modes in `runs` to `output` and takes the states of `blocks` (ascending,
    /// holding all of `runs`) on by a cell, times `scale`.
    void render(std::span<const std::int32_t> blocks,
                std::span<const ModeRun> runs,
                double scale,
                float* output) noexcept;

    /// Adds the first 16 · `subBlockCount` samples (at most a cell) that `runs` sound from other
    /// states, which are taken on by a cell.
    void renderFrom(ModeStates& from,
                    std::span<const ModeRun> runs,
                    std::size_t subBlockCount,
                    float* output) noexcept;

    /// Adds to `sum` the states `others` after `samples` (0 to 64) of free motion, to single
    /// precision of theirs, times `factor`.
    void addMoved(const ModeStates& others,
                  std::size_t samples,
                  double factor,
                  ModeStates& sum) noexcept;

    /// The same added to the bank's own states.
    void join(const ModeStates& others, std::size_t samples, double factor) noexcept;

    /// Free motion from rest after impulses: y to each velocity x of oscillating modes.
    void statesOfImpulse(ModeStates& velocities) const noexcept;

    /// |s|² of other states, or the square of their bound, into [paddedSize].
    void measureStates(const ModeStates& others, float* energies) const noexcept;

    /// Takes other states on by less than a sample, to single precision of theirs, times `factor`.
    void rotate(ModeStates& from, double seconds, double factor) noexcept;

    /// The forced part of a contact, for residues of 1 (StrikeKernel.h), into arrays
    /// [paddedSize].
    void forcedStates(const PulseInstant& pulse,
                      ModeStates& forced,
                      double* steady,
                      double* swingRe,
                      double* swingIm) const noexcept;

    /// Frequencies of lightly damped audible modes in Hz, 0 for the others: those that a contact
    /// time must keep clear of.
    std::span<const double> resonances() const noexcept { return {resonance.data(), count}; }

private:
    void renderStates(double* x,
                      double* y,
                      float* energies,
                      std::span<const std::int32_t> blocks,
                      std::span<const ModeRun> runs,
                      std::size_t subBlockCount,
                      double scale,
                      float* output) noexcept;
    void correctHeavy(std::size_t g) noexcept;
    void measure(std::size_t g) noexcept;

    double sampleSeconds;
    std::size_t count = 0;

    AlignedVector<double> stiffness, damping, decay, frequency, displacementShare, velocityShare;
    AlignedVector<double> resonance;
    AlignedVector<float> audibles;
    AlignedVector<float> tables; ///< [G,2,16]
    AlignedVector<float> turnRe, turnIm;
    AlignedVector<double> cellRe, cellIm;
    ModeStates states;
    AlignedVector<float> energy;

    /// Modes that do not oscillate: a 2 × 2 propagator over 16 and 64 samples each.
    struct HeavyMode {
        std::int32_t mode = 0;
        Propagator turn;
        Propagator cell;
        ModalState aside; ///< its state while SIMD passes over it
    };
    std::vector<HeavyMode> heavyModes;   ///< ascending
    std::vector<std::int32_t> allBlocks; ///< 0, 1, 2, …
};

} // namespace idiophone
