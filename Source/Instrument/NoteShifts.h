// How far a host moves parameters of single notes, beside the instrument's own modulation.
#pragma once

#include "Parameters/ModulationTable.h"

#include <array>
#include <cstddef>

namespace idiophone {

/// Plain data of one thread; neither allocates, locks nor throws.
class NoteShifts {
public:
    /// Shares of the ranges of noteTargets(), on the parameters' own scales; 0: not moved.
    using Shares = std::array<double, noteTargetCount>;

    /// Moves a note, 0 to 127.
    void set(int note, const Shares& shares) noexcept {
        auto& former = ofNotes[static_cast<std::size_t>(note)];
        for (std::size_t i = 0; i < shares.size(); ++i)
            movedNotes[i] += (shares[i] != 0) - (former[i] != 0);
        former = shares;
    }
    /// Returns the share of a note, or 0 if notes do not have the target for themselves.
    double share(ParameterId target, int note) const noexcept {
        const auto index = noteTargetIndex(target);
        return index ? ofNotes[static_cast<std::size_t>(note)][*index] : 0;
    }
    /// Returns whether any note is moved.
    bool moves(ParameterId target) const noexcept {
        const auto index = noteTargetIndex(target);
        return index && movedNotes[*index] > 0;
    }

private:
    std::array<Shares, 128> ofNotes{};
    std::array<int, noteTargetCount> movedNotes{}; ///< number of notes with a share that is not 0
};

} // namespace idiophone
