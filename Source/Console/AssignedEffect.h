// What parameters that were set by name come to on what is played: figures make their material or
// mallet custom, and some cannot act.
#pragma once

#include "Parameters/ParameterTable.h"
#include "Synth/Synthesiser.h"

#include <span>
#include <string>
#include <vector>

namespace idiophone {

enum class PlayedBy {
    mallets,  ///< keys strike, scrape and roll
    stage,    ///< keys set a scene in motion
    scene,    ///< bodies by themselves
    impulses, ///< contacts of a list
};

struct Played {
    PlayedBy by = PlayedBy::mallets;
    std::span<const SynthesiserSlot> slots; ///< that are heard
    bool isOnePoint = false;                ///< all keys strike at the same
    bool isPressed = false;                 ///< pressure of keys comes
};

struct AssignedEffect {
    ParameterValues values;
    /// A sentence for each parameter without effect, with what it would have one.
    std::vector<std::string> warnings;
};

/// The values with which `assigned` act: where one is a figure of the custom material or mallet and
/// another one is chosen, that becomes custom with its other figures, as it does in the window.
/// Objects of several materials keep them.
AssignedEffect
assignedEffect(ParameterValues values, std::span<const ParameterId> assigned, const Played& played);

/// On standard error, a line each.
void print(std::span<const std::string> warnings);

} // namespace idiophone
