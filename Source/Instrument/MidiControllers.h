// Numbers of the MIDI controllers and channel mode messages that a player follows (MIDI 1.0).
#pragma once

#include <cstdint>
#include <span>

namespace idiophone::midi {

enum Controller {
    modulation = 1,
    dataEntryMsb = 6,
    dataEntryLsb = 38,
    sustainPedal = 64,
    sostenutoPedal = 66,
    softPedal = 67,
    place = 74, ///< "brightness", and MPE's third dimension
    unregisteredLsb = 98,
    unregisteredMsb = 99,
    registeredLsb = 100,
    registeredMsb = 101,
    allSoundOff = 120,
    resetControllers = 121,
    allNotesOff = 123,
    // The following messages imply all notes off.
    omniOff = 124,
    omniOn = 125,
    monoOn = 126,
    polyOn = 127
};

/// Returns whether the message is a channel mode message, on any channel.
inline bool isChannelMode(std::span<const std::uint8_t> message) {
    return message.size() == 3 && (message[0] & 0xf0) == 0xb0 && (message[1] & 0x7f) >= allSoundOff;
}

/// Returns whether the message is All Sound Off, on any channel.
inline bool isAllSoundOff(std::span<const std::uint8_t> message) {
    return isChannelMode(message) && (message[1] & 0x7f) == allSoundOff;
}

/// Returns whether the channel mode message with this number ends all notes.
inline bool releasesAllNotes(int number) {
    return number == allSoundOff || number >= allNotesOff;
}

} // namespace idiophone::midi
