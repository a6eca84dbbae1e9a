// Makes parameters that were set by name take effect, or says why they cannot. A figure of a
// material or mallet makes that material or mallet custom.
#pragma once

#include "Parameters/ParameterTable.h"
#include "Synth/Synthesiser.h"

#include <span>
#include <string>
#include <vector>

namespace idiophone {

enum class PlayedBy {
    mallets,  ///< keys strike, scrape and roll
    stage,    ///< keys start simulations of a scene
    scene,    ///< bodies move, and keys do nothing
    impulses, ///< a list of contacts
};

struct Played {
    PlayedBy by = PlayedBy::mallets;
    std::span<const SynthesiserSlot> slots; ///< slots that sound
    bool isOnePoint = false;                ///< all keys strike the same point
    bool isPressed = false;                 ///< the song has key pressure
};

struct AssignedEffect {
    ParameterValues values;
    /// A sentence for each parameter without effect, with the values it would need.
    std::vector<std::string> warnings;
};

/// Returns the values with which `assigned` act. If one is a figure of the custom material or
/// mallet, the selected material or mallet becomes custom. The other figures are kept, as in the
/// window. Objects of several materials keep their own figures.
AssignedEffect
assignedEffect(ParameterValues values, std::span<const ParameterId> assigned, const Played& played);

/// Prints each warning as one line to standard error.
void print(std::span<const std::string> warnings);

} // namespace idiophone
