// The tuning of the keys by messages of the MIDI Tuning Standard.
#pragma once

#include "Instrument/KeyTuning.h"

#include <cstdint>
#include <span>

namespace idiophone {

/// One tuning for all programs, banks and channels; at first equal temperament. Neither allocates,
/// locks nor throws, for the audio thread.
class MidiTuning {
public:
    /// Returns whether a system exclusive message, from F0 on, belongs to the standard: a bulk
    /// dump, a change of single notes or an octave scale. Requests do not.
    static bool isFor(std::span<const std::uint8_t> message) noexcept;

    /// Retunes the keys that the message names. Returns false, and changes nothing, if it is not
    /// for tuning. Ignores a checksum, and what is cut off.
    bool read(std::span<const std::uint8_t> message) noexcept;
    /// Returns to equal temperament.
    void reset() noexcept { tuning = {}; }

    const KeyTuning& keys() const noexcept { return tuning; }

private:
    void readKeys(std::span<const std::uint8_t> pitches) noexcept;
    void readNamedKeys(std::span<const std::uint8_t> changes) noexcept;
    void readKey(std::size_t key, std::span<const std::uint8_t> pitch) noexcept;
    void readOctave(std::span<const std::uint8_t> offsets, std::size_t bytesOfNote) noexcept;

    KeyTuning tuning;
};

} // namespace idiophone
