// What MIDI asks for by program changes, and keys that go down before it plays.
#pragma once

#include "Instrument/Player.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace idiophone {

/// [audio thread] throughout; neither allocates, locks nor throws.
class AwaitingKeys {
public:
    /// Programs from 0 up to, and without, this number are waited for; changes to others are none.
    explicit AwaitingKeys(int programCount) : programs(programCount) {}

    /// Whether a MIDI message is a change to a program that is waited for.
    bool isAwaited(std::span<const std::uint8_t> message) const noexcept;

    /// Channel messages in order of time.
    void follow(std::span<const MidiEvent> messages) noexcept;

    /// The program of the last change since this was asked, if any.
    std::optional<int> takeProgram() noexcept { return std::exchange(program, std::nullopt); }

    /// The note-ons since the last program change whose keys are still down, in order of time, and
    /// waits no longer; valid until the next `follow`.
    std::span<const MidiEvent> take() noexcept;

    /// All keys are up, and those that go down from now on are still waited for.
    void forgetKeys() noexcept { count = 0; }

private:
    static constexpr std::size_t capacity = 256; ///< keys beyond it are not struck again

    void follow(const MidiEvent& event) noexcept;
    void release(const MidiEvent& event) noexcept;

    int programs;
    std::optional<int> program;
    bool isWaiting = false;
    std::array<MidiEvent, capacity> noteOns{};
    std::size_t count = 0;
};

} // namespace idiophone
