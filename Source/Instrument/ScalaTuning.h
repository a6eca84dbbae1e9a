// Reads tunings from Scala files: a scale (.scl) and a keyboard mapping (.kbm) give the pitch of
// every key (https://www.huygens-fokker.org/scala/scl_format.html). Any thread; allocates.
#pragma once

#include "Instrument/KeyTuning.h"
#include "Object/Result.h"

#include <cstdint>
#include <string>

namespace idiophone {

/// The content of a file; both fields are empty if there is no file.
struct ScalaFile {
    std::string name; ///< used in errors
    std::string text;

    bool isGiven() const { return !name.empty() || !text.empty(); }
    bool operator==(const ScalaFile&) const = default;
};

struct ScalaTuning {
    static constexpr std::uintmax_t largestFileBytes = 1 << 18;
    static constexpr int maximumDegrees = 1024;

    ScalaFile scale;   ///< without a file: twelve equal steps
    ScalaFile mapping; ///< without a file: the scale begins at note 60 with 261.6 Hz

    bool isGiven() const { return scale.isGiven() || mapping.isGiven(); }
    bool operator==(const ScalaTuning&) const = default;
};

/// Returns the pitch of every key. A key with a pitch outside 1 Hz to 100 kHz has none. Text after
/// a number on its line is ignored, as the format asks. Keys beyond the mapping's first and last
/// note are tuned too. The error names the file and its line.
Result<KeyTuning> keyTuning(const ScalaTuning& tuning);

/// Returns the scale's own description, its file's name if it has none, or "Equal temperament".
std::string scaleTitle(const ScalaTuning& tuning);

} // namespace idiophone
