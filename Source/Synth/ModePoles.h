// SPDX-License-Identifier: Apache-2.0
// The poles of an object's modes (or groups of merged modes), with their rotations and tables, in
// arrays for the SIMD loops.
#pragma once

#include "Synth/HeavyModes.h"
#include "Synth/ModalPole.h"
#include "Synth/ModeRun.h"
#include "Synth/PoleKernel.h"

#include <span>
#include <utility>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread. Modes are
/// stored in blocks of `modeBlock`; the padding beyond `size` is oscillating modes.
class ModePoles {
public:
    /// Starts with `capacity` inaudible modes. Set their poles and call `update` next.
    ModePoles(std::size_t capacity, double sampleRateHz);

    std::size_t size() const noexcept { return count; }
    std::size_t blockCount() const noexcept { return (count + modeBlock - 1) / modeBlock; }
    std::size_t paddedSize() const noexcept { return blockCount() * modeBlock; }
    double sampleSeconds() const noexcept { return secondsPerSample; }

    ModalPole pole(std::size_t g) const noexcept {
        return {coefficients.stiffness[g], coefficients.damping[g]};
    }
    std::size_t audibleCount() const noexcept { return audibleModes; }
    const float* audibleWeights() const noexcept { return audibles.data(); } ///< 1 or 0
    /// Damped frequencies of lightly damped modes within the band in Hz, silenced or not. A contact
    /// time must keep clear of them.
    std::span<const double> resonances() const noexcept {
        return std::span(resonancesHz).first(resonanceCount);
    }

    /// Rotations and tables belong to the poles only where `prepare` has been called.
    const PoleArrays& arrays() const noexcept { return coefficients; }
    ModeRotations rotations(std::size_t first) const noexcept {
        return {coefficients.subBlockRe.data() + first, coefficients.subBlockIm.data() + first,
                coefficients.cellRe.data() + first, coefficients.cellIm.data() + first};
    }
    /// Returns whether the last `update` found heavy modes.
    bool hadHeavy() const noexcept { return foundHeavy; }
    const HeavyModes& heavy() const noexcept { return heavyModes; }
    HeavyModes& heavy() noexcept { return heavyModes; }

    /// Replaces the modes by `modes` new ones, each with the pole of the first mode that it takes
    /// from (ModalBank::regroup).
    void regroup(std::size_t modes, std::span<const ModeShare> shares) noexcept;
    void set(std::size_t g, const ModalPole& pole) noexcept {
        coefficients.stiffness[g] = pole.stiffness;
        coefficients.damping[g] = pole.damping;
    }
    /// Sets the poles by a law (PoleLawKernel.h). Call `update` next; until then `formerPole`
    /// returns a mode's pole from before.
    void set(const PoleLaw& law,
             std::span<const double> referenceEigenvalues,
             std::span<const ModeDamping> dampings) noexcept;
    ModalPole formerPole(std::size_t g) const noexcept {
        return {coefficients.cellRe[g], coefficients.cellIm[g]};
    }
    /// Computes everything else from the poles, except rotations and tables. Modes outside the band
    /// (natural frequency) are inaudible, and so are modes with `silenced` ≠ 0 ([size], or empty:
    /// none).
    void update(const AudibleBand& band, std::span<const std::uint8_t> silenced) noexcept;
    /// Computes the rotations and tables of a block, unless they belong to the poles already.
    void prepare(std::size_t block) noexcept {
        if (!std::exchange(isPrepared[block], true))
            findRotations(block);
    }

private:
    void forget() noexcept;
    void findRotations(std::size_t block) noexcept;

    double secondsPerSample;
    std::size_t count;
    std::size_t audibleModes = 0;
    HeavyModes heavyModes;
    PoleArrays coefficients;
    AlignedVector<float> audibles;
    std::vector<double> resonancesHz; ///< of which `resonanceCount` are used
    std::size_t resonanceCount = 0;
    std::vector<char> isPrepared; ///< of every block
    bool foundHeavy = false;
};

} // namespace idiophone
