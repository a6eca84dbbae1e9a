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
    /// Returns the share of the target's range, 0 for one that notes do not have for themselves.
    double of(ParameterId target, int note) const noexcept {
        const auto index = indexOf(target);
        return index < noteTargetCount ? ofNotes[static_cast<std::size_t>(note)][index] : 0;
    }
    /// Returns whether it moves any note.
    bool moves(ParameterId target) const noexcept {
        const auto index = indexOf(target);
        return index < noteTargetCount && movedNotes[index] > 0;
    }

private:
    /// Wraps round for the choice 0, none.
    static std::size_t indexOf(ParameterId target) noexcept {
        return static_cast<std::size_t>(modulationTargetChoice(target)) - 1;
    }

    std::array<Shares, 128> ofNotes{};
    std::array<int, noteTargetCount> movedNotes{}; ///< their number
};

} // namespace idiophone
