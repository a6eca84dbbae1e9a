// The bytes that a host saves with its project: versioned JSON ("format", "version", "parameters",
// "preset", "objects", "controllers", "tuning"). Plain data; applying it is the processor's.
#pragma once

#include "Instrument/Preset.h"
#include "Instrument/ScalaTuning.h"
#include "Object/Result.h"
#include "Plugin/ControllerAssignments.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

inline constexpr int stateFormatVersion = 1;

/// The .modal files of all objects that a state can carry, together.
inline constexpr std::int64_t largestEmbeddedBytes = std::int64_t{1} << 30;

/// A modal object that is not part of the program and so travels with the state.
struct EmbeddedObject {
    std::string name;             ///< by which the preset's key map knows it
    std::vector<std::byte> modal; ///< the .modal file; not needed where `packed` is given
    std::shared_ptr<const std::string> packed = {}; ///< the same as the state has it, or null

    bool operator==(const EmbeddedObject& other) const {
        return name == other.name && modal == other.modal;
    }
};

/// A .modal file as states have it: as text. Takes some tenths of a second for a large one.
std::string packedModal(std::span<const std::byte> modal);

struct State {
    ParameterValues parameters;
    Preset preset;
    std::vector<EmbeddedObject> objects;
    ControllerAssignments controllers; ///< none in states that say none
    ScalaTuning tuning;                ///< none in states that say none; the files' text as it is

    bool operator==(const State&) const = default;
};

/// The same state always gives the same bytes; values are exact to the last bit.
std::string encodeState(const State& state);

/// Trusts nothing, and ignores members and parameters that it does not know. The error is one
/// sentence that begins "The saved state". States of older formats are migrated here, and nowhere
/// else; there are none yet.
Result<State> parseState(std::string_view bytes);

} // namespace idiophone
