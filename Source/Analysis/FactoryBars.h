// The bars of the factory's instruments, before they are tuned. docs/instruments.md has the sources
// of their measures.
#pragma once

#include "Analysis/BarTuning.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// A row of bars, one a note.
struct BarInstrument {
    std::string_view name;                 ///< "xylophone": its bars are "xylophone-65" and so on
    int lowestNote = 60, highestNote = 72; ///< MIDI
    BarSpecification (*bar)(double frequencyHz, double keyboardShare) = nullptr;

    /// The bar of a note; `frequencyHz` may be that of another scale.
    BarSpecification barAt(int midiNote, double frequencyHz) const;
    std::string barName(int midiNote) const;
};

/// All of them.
std::span<const BarInstrument> barInstruments();

/// The instrument of that name, or nullptr.
const BarInstrument* findBarInstrument(std::string_view name);

/// The equal-tempered frequency of a MIDI note, A4 (69) = 440 Hz.
double noteFrequencyHz(double midiNote);

} // namespace idiophone
