// Keys that go down after MIDI has asked for a program and before it plays.
#pragma once

#include "Instrument/Player.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// [audio thread] throughout; neither allocates, locks nor throws.
class AwaitingKeys {
public:
    /// Programs from 0 up to, and without, this number are waited for.
    explicit AwaitingKeys(int programCount) : programs(programCount) {}

    /// Channel messages in order of time.
    void follow(std::span<const MidiEvent> messages) noexcept;

    /// The note-ons since the last program change whose keys are still down, in order of time, and
    /// waits no longer; valid until the next `follow`.
    std::span<const MidiEvent> take() noexcept;

private:
    static constexpr std::size_t capacity = 256; ///< keys beyond it are not struck again

    void follow(const MidiEvent& event) noexcept;
    void release(const MidiEvent& event) noexcept;

    int programs;
    bool isWaiting = false;
    std::array<MidiEvent, capacity> noteOns{};
    std::size_t count = 0;
};

} // namespace idiophone
