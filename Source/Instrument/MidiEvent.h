// A MIDI channel message in a block of samples.
#pragma once

#include <array>
#include <cstdint>

namespace idiophone {

/// `sampleOffset` counts from the start of the block.
struct MidiEvent {
    int sampleOffset = 0;
    std::array<std::uint8_t, 3> bytes{};

    int kind() const { return bytes[0] & 0xf0; }
    int channel() const { return bytes[0] & 0x0f; }
    int first() const { return bytes[1] & 0x7f; }  ///< the note or controller
    int second() const { return bytes[2] & 0x7f; } ///< the velocity, pressure or value

    bool isNoteOn() const { return kind() == 0x90 && second() > 0; }
    bool isNoteOff() const { return kind() == 0x80 || (kind() == 0x90 && !isNoteOn()); }
};

} // namespace idiophone
