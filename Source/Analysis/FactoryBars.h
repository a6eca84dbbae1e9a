// The bars of the factory instruments before tuning. docs/instruments.md lists the sources of their
// dimensions.
#pragma once

#include "Analysis/BarTuning.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// A row of bars, one per note.
struct BarInstrument {
    std::string_view name;                 ///< "xylophone": its bars are "xylophone-65" and so on
    int lowestNote = 60, highestNote = 72; ///< MIDI
    BarSpecification (*bar)(double frequencyHz, double keyboardShare) = nullptr;

    /// Returns the bar of a note. `frequencyHz` may belong to another scale.
    BarSpecification barAt(int midiNote, double frequencyHz) const;
    std::string barName(int midiNote) const;
};

std::span<const BarInstrument> barInstruments();

/// Returns the instrument with this name, or nullptr.
const BarInstrument* findBarInstrument(std::string_view name);

/// Returns the equal-tempered frequency of a MIDI note; A4 (69) is 440 Hz.
double noteFrequencyHz(double midiNote);

} // namespace idiophone
