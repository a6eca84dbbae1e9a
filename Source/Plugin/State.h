// Encodes and parses the state that a host saves with its project: versioned JSON ("format",
// "version", "parameters", "preset", "origin", "objects", "controllers", "tuning"). Plain data; the
// processor applies it.
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

/// Maximum total bytes of all .modal files in one state.
inline constexpr std::int64_t largestEmbeddedBytes = std::int64_t{1} << 30;

/// A modal object that the state carries because it is not part of the program.
struct EmbeddedObject {
    std::string name;             ///< as the preset's key map names it
    std::vector<std::byte> modal; ///< the .modal file; may be empty if `packed` is given
    std::shared_ptr<const std::string> packed = {}; ///< the file packed for a state, or null

    bool operator==(const EmbeddedObject& other) const {
        return name == other.name && modal == other.modal;
    }
};

/// Packs a .modal file as text for a state. Takes some tenths of a second for a large file.
std::string packedModal(std::span<const std::byte> modal);

/// The preset on the shelf that a sound came from, so that it can be saved there again (Sound.h).
struct SavedOrigin {
    std::string presetId; ///< empty: none
    std::uint64_t presetContent = 0;
    ParameterValues stored;

    bool operator==(const SavedOrigin&) const = default;
};

struct State {
    ParameterValues parameters;
    Preset preset;
    SavedOrigin origin = {};
    std::vector<EmbeddedObject> objects;
    ControllerAssignments controllers; ///< empty if the state has none
    ScalaTuning tuning;                ///< empty if the state has none; the files' text unchanged

    bool operator==(const State&) const = default;
};

/// Encodes a state. The same state always gives the same bytes; values are exact to the last bit.
std::string encodeState(const State& state);

/// Parses untrusted bytes; ignores unknown members and parameters. The error is one sentence that
/// begins "The saved state". Only this function migrates older formats; there are none yet.
Result<State> parseState(std::string_view bytes);

} // namespace idiophone
