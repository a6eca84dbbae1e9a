// What parameters that were set by name come to on what is played: figures make their material or
// mallet custom, and what cannot act is told.
#pragma once

#include "Parameters/ParameterTable.h"
#include "Synth/Synthesiser.h"

#include <span>

namespace idiophone {

enum class PlayedBy {
    mallets,  ///< keys strike, scrape and roll
    stage,    ///< keys set a scene in motion
    scene,    ///< bodies by themselves
    impulses, ///< contacts of a list
};

struct Played {
    PlayedBy by = PlayedBy::mallets;
    std::span<const SynthesiserSlot> slots; ///< one at least
    bool isOnePoint = false;                ///< all keys strike at the same
    bool isPressed = false;                 ///< pressure of keys comes
};

/// The values with which `assigned` act: where one is a figure of the custom material or mallet and
/// another one is chosen, that becomes custom with its other figures, as it does in the window. On
/// standard error it has a line for each that has no effect and what it would have it with.
ParameterValues
withAssigned(ParameterValues values, std::span<const ParameterId> assigned, const Played& played);

} // namespace idiophone
