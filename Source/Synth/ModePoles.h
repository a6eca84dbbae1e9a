// The poles of an object's modes (or groups of merged modes), with their rotations and tables, in
// arrays for the SIMD loops.
#pragma once

#include "Synth/HeavyModes.h"
#include "Synth/ModalPole.h"
#include "Synth/ModeRun.h"
#include "Synth/PoleKernel.h"

#include <span>
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
    /// Frequencies of lightly damped modes within the band in Hz, ascending, silenced or not. A
    /// contact time must keep clear of them.
    std::span<const double> resonances() const noexcept { return resonancesHz; }

    const PoleArrays& arrays() const noexcept { return coefficients; }
    ModeRotations rotations(std::size_t first) const noexcept {
        return {coefficients.subBlockRe.data() + first, coefficients.subBlockIm.data() + first,
                coefficients.cellRe.data() + first, coefficients.cellIm.data() + first};
    }
    const HeavyModes& heavy() const noexcept { return heavyModes; }
    HeavyModes& heavy() noexcept { return heavyModes; }

    /// Replaces the modes by `modes` new ones, each with the pole of the first mode that it takes
    /// from (ModalBank::regroup).
    void regroup(std::size_t modes, std::span<const ModeShare> shares) noexcept;
    void set(std::size_t g, const ModalPole& pole) noexcept {
        coefficients.stiffness[g] = pole.stiffness;
        coefficients.damping[g] = pole.damping;
    }
    /// Computes everything else from the poles. Modes outside `lowestHz` ≤ f < `highestHz` are
    /// inaudible, and so are modes with `silenced` ≠ 0 ([size], or empty: none).
    void update(double lowestHz, double highestHz, std::span<const std::uint8_t> silenced) noexcept;

private:
    void forget() noexcept;

    double secondsPerSample;
    std::size_t count;
    std::size_t audibleModes = 0;
    HeavyModes heavyModes;
    PoleArrays coefficients;
    AlignedVector<float> audibles;
    std::vector<double> resonancesHz;
};

} // namespace idiophone
