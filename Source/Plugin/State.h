// What a host saves with its project, as bytes: versioned JSON (docs: "format", "version",
// "engine", "parameters", "preset", "objects", "controllers", "tuning"). Plain data; applying it is
// the processor's.
#pragma once

#include "Instrument/Preset.h"
#include "Instrument/ScalaTuning.h"
#include "Object/Result.h"
#include "Plugin/ControllerAssignments.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace idiophone {

inline constexpr int stateFormatVersion = 1;

/// A modal object that is not part of the program and so travels with the state.
struct EmbeddedObject {
    std::string name;             ///< by which the preset's key map knows it
    std::vector<std::byte> modal; ///< the .modal file

    bool operator==(const EmbeddedObject&) const = default;
};

struct State {
    std::string engineVersion; ///< of the Idiophone that saved it
    ParameterValues parameters;
    /// Parameters that this version does not know: kept, and saved again, so that a project from a
    /// newer version loses nothing here.
    std::vector<std::pair<std::string, double>> unknownParameters;
    Preset preset;
    std::vector<EmbeddedObject> objects;
    ControllerAssignments controllers; ///< none in states that say none
    ScalaTuning tuning;                ///< none in states that say none; the files' text as it is

    bool operator==(const State&) const = default;
};

/// The same state always gives the same bytes; values are exact to the last bit.
std::string encodeState(const State& state);

/// Trusts nothing. The error is one sentence that begins "The saved state".
Result<State> parseState(std::string_view bytes);

} // namespace idiophone
