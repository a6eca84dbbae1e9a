// SPDX-License-Identifier: Apache-2.0
// The path of a bank's sound into the cell: fades of modes, the damper, and a motor's discs in the
// tubes. Sounds are rendered for open discs, and then the part that the discs block is removed. So
// the states do not depend on damper and discs.
#pragma once

#include "Synth/CellOutput.h"
#include "Synth/ModalBank.h"
#include "Synth/ModeFader.h"
#include "Synth/SynthesisScratch.h"

#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread.
class BankOutput {
public:
    /// `tubeShares` [modes of the object], or empty: no tube (TubeShares.h). Bank and scratch must
    /// outlive this object.
    BankOutput(ModalBank& bank,
               std::vector<float> tubeShares,
               double sampleRateHz,
               SynthesisScratch& scratch);

    double sampleRateHz() const noexcept { return rateHz; }
    double cellSeconds() const noexcept { return secondsPerCell; }

    double damping() const noexcept { return dampingPerSecond; } ///< δ
    void setDamping(double perSecond, std::int64_t grid) noexcept;
    /// Forgets earlier damping, whose rounding would remain. All states must be 0.
    void restartDamper(std::int64_t grid) noexcept {
        dampingLogBase = 0;
        dampingSince = grid;
    }
    /// Returns −ln of the damper's gain from some time to the grid point.
    double dampingLog(std::int64_t grid) const noexcept {
        return dampingLogBase +
               dampingPerSecond * secondsPerCell * static_cast<double>(grid - dampingSince);
    }
    /// Applies the damper's decay to the first `count` samples.
    void fadeByDamper(const ChannelOutputs& sound, std::size_t count) const noexcept;

    /// Finds the groups with a tube's part. Modes that bar and tube share are separate groups.
    void findTubeParts(std::span<const std::int32_t> groupStarts) noexcept;
    /// Returns whether the discs change the sound of the current cell.
    bool tubesPulse() const noexcept { return !tubeParts.empty() && !scratch.tubes.isFull(); }
    /// Returns the tube's parts of the modes in ascending runs, valid until the next call.
    std::span<const ModePart> tubePartsOf(std::span<const ModeRun> runs) const noexcept;
    /// Returns `tubePartsOf(runs)` if the discs change the sound, otherwise nothing.
    std::span<const ModePart> pulsing(std::span<const ModeRun> runs) const noexcept {
        return tubesPulse() ? tubePartsOf(runs) : std::span<const ModePart>();
    }

    /// Fades modes out (share 1) or in (share −1).
    void fade(std::span<const std::int32_t> modes, float share) noexcept;
    /// Fades parts of modes (ModeFader::change); scales `shares`.
    void fade(std::span<const std::int32_t> modes, std::span<float> shares) noexcept;
    bool fading() const noexcept { return fader.active(); }

    /// Adds `count` samples to the cell from sample `from` on. A mono sound goes to both channels.
    void add(const CellSound& sound,
             std::size_t from,
             std::size_t count,
             const CellOutput& cell) const noexcept;
    /// Takes the part that the discs block out of the cell; overwrites `tube`, the tube's part of
    /// a sound in the cell.
    void closeTubes(CellSound& tube,
                    std::size_t from,
                    std::size_t count,
                    const CellOutput& cell) const noexcept;
    /// Moves the bank by a cell and adds the sound of `runs` and of the fades.
    void render(std::span<const std::int32_t> blocks,
                std::span<const ModeRun> runs,
                const CellOutput& cell) noexcept;

    void widen() noexcept { fader.widen(); } ///< after the bank's second channel opens
    void reset() noexcept { fader.reset(); }

private:
    void renderTo(const ChannelOutputs& outputs,
                  std::span<const std::int32_t> blocks,
                  std::span<const ModeRun> runs) noexcept;
    float openingNow(std::size_t g) const noexcept;

    ModalBank& bank;
    SynthesisScratch& scratch;
    ModeFader fader;
    double rateHz;
    double secondsPerCell;
    double dampingPerSecond = 0;
    double dampingLogBase = 0;
    std::int64_t dampingSince = 0;
    std::vector<float> tubeShares;
    std::vector<ModePart> tubeParts; ///< ascending groups
};

} // namespace idiophone
