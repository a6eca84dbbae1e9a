// SPDX-License-Identifier: Apache-2.0
// Spreads grouping after a change of material or pitch over the cells, counted in modes, so that no
// cell groups all slots.
#pragma once

#include <cstddef>

namespace idiophone {

/// Slots have turns in ascending order, around and around. Neither allocates, locks nor throws.
class RegroupTurns {
public:
    /// A cell gives turns until they have regrouped this many modes or visited this many slots.
    static constexpr std::size_t modesPerCell = 128, slotsPerCell = 32;

    explicit RegroupTurns(std::size_t slotCount) : slots(slotCount) {}

    /// Gives every slot a turn in this cell and the next ones.
    void restart() noexcept { waiting = slots; }

    /// Calls `visit(slot)`, which returns the number of modes that it regroups, and returns their
    /// sum.
    template <class Visit>
    std::size_t give(Visit visit) noexcept {
        std::size_t modes = 0;
        for (std::size_t k = 0; k < slotsPerCell && waiting > 0 && modes < modesPerCell; ++k) {
            modes += visit(next);
            next = (next + 1) % slots;
            --waiting;
        }
        return modes;
    }

private:
    std::size_t slots;
    std::size_t next = 0;
    std::size_t waiting = 0; ///< slots that have not had a turn since `restart`
};

} // namespace idiophone
