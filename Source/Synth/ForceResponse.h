// What an object answers to an impulse of 1 N s at one point: kept from cell to cell while a
// contact is near.
#pragma once

#include "Synth/ForceCell.h"
#include "Synth/ModalBank.h"

#include <array>
#include <cstdint>

namespace idiophone {

/// How the object is heard: what the residues near and from afar are multiplied by, and the share
/// of the latter, 0 to 1.
struct Hearing {
    double nearGain = 1; ///< [Pa per m/s]
    double farGain = 1;
    double farShare = 0;

    bool operator==(const Hearing&) const = default;
};

struct ForceResponse {
    const void* object = nullptr; ///< whose it is
    std::uint64_t version = 0;    ///< of what it depends on besides
    std::uint64_t lastUse = 0;
    ForcePoint at;
    Hearing heard;
    ModeResidues residues;         ///< [G]
    alignas(64) CellSound sound{}; ///< within a cell
    alignas(64) CellSound tube{};  ///< of this, what the tube adds
    bool knowsTube = false;
};

/// A contact's at the two points around where it starts a cell, and where it ends it.
using ForceResponses = std::array<ForceResponse, 4>;

} // namespace idiophone
