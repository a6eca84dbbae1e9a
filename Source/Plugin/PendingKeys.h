// Follows MIDI program changes, and keys pressed before the requested program plays.
#pragma once

#include "Instrument/Player.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws.
class PendingKeys {
public:
    /// Follows changes to programs 0 to `programCount` - 1 and ignores others.
    explicit PendingKeys(int programCount) : programs(programCount) {}

    /// Returns whether a MIDI message changes to a program below the count.
    bool isProgramChange(std::span<const std::uint8_t> message) const noexcept;

    /// Takes channel messages, in order of time.
    void follow(std::span<const MidiEvent> messages) noexcept;

    /// Returns the program of the last change since the previous call, if any.
    std::optional<int> takeProgram() noexcept { return std::exchange(program, std::nullopt); }

    /// Returns the note-ons since the last program change whose keys are still down, in order of
    /// time. Stops collecting keys. Valid until the next `follow`.
    std::span<const MidiEvent> take() noexcept;

    /// Forgets the keys held now, but still collects keys pressed from now on.
    void forgetKeys() noexcept { count = 0; }

private:
    static constexpr std::size_t capacity = 256; ///< further keys are not struck again

    void release(const MidiEvent& event) noexcept;

    int programs;
    std::optional<int> program;
    bool isPending = false;
    std::array<MidiEvent, capacity> noteOns{};
    std::size_t count = 0;
};

} // namespace idiophone
