// SPDX-License-Identifier: Apache-2.0
// An object's response to an impulse of 1 N s at one point, kept from cell to cell while a contact
// is near.
#pragma once

#include "Synth/ForceCell.h"
#include "Synth/Listening.h"
#include "Synth/ModeResidues.h"

#include <array>
#include <cstdint>

namespace idiophone {

struct ForceResponse {
    const void* owner = nullptr; ///< ForceResponses that the response belongs to
    std::uint64_t version = 0;   ///< version of everything else that the response depends on
    std::uint64_t lastUse = 0;
    ForcePoint at;
    Listening listening;
    bool isImpulses = false;       ///< ForceCell::isImpulses
    ModeResidues residues;         ///< [G]
    alignas(64) CellSound sound{}; ///< over one cell
    alignas(64) CellSound tube{};  ///< the tube's part of `sound`
    bool knowsTube = false;
};

/// The cached responses of one contact: two points around its place at the cell's start and two at
/// its end.
using CachedResponses = std::array<ForceResponse, 4>;

} // namespace idiophone
