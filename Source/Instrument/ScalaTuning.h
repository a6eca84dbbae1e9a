// Tunings as Scala files: a scale (.scl) and a keyboard mapping (.kbm), which say what pitch every
// key has (https://www.huygens-fokker.org/scala/scl_format.html). Any thread; allocates.
#pragma once

#include "Instrument/KeyTuning.h"
#include "Object/Result.h"

#include <cstdint>
#include <string>

namespace idiophone {

/// A file as it was read; both empty where there is none.
struct ScalaFile {
    std::string name; ///< stands for it in errors
    std::string text;

    bool isGiven() const { return !name.empty() || !text.empty(); }
    bool operator==(const ScalaFile&) const = default;
};

struct ScalaTuning {
    static constexpr std::uintmax_t largestFileBytes = 1 << 18;
    static constexpr int mostDegrees = 1024;

    ScalaFile scale;   ///< none: twelve equal steps
    ScalaFile mapping; ///< none: the scale begins at note 60, which has 261.6 Hz

    bool isGiven() const { return scale.isGiven() || mapping.isGiven(); }
    bool operator==(const ScalaTuning&) const = default;
};

/// The pitch of every key. A key whose pitch would lie outside of 1 Hz to 100 kHz has none. What
/// stands behind a number on its line is ignored, as the format asks; the mapping's first and last
/// note are read, and keys beyond them tuned all the same. The error names the file and its line.
Result<KeyTuning> keyTuning(const ScalaTuning& tuning);

/// The scale's own description, its file's name where it has none, or "Equal temperament".
std::string scaleTitle(const ScalaTuning& tuning);

} // namespace idiophone
