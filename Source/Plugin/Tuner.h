// Chooses the tuning of the keys: this instance's own, or that of a session master (MTS-ESP) or of
// MIDI Tuning Standard messages.
#pragma once

#include "Instrument/KeyTuning.h"
#include "Instrument/LatestValue.h"
#include "Instrument/MidiTuning.h"

#include <atomic>
#include <juce_audio_basics/juce_audio_basics.h>
#include <memory>
#include <optional>
#include <span>
#include <string>

struct MTSClient;

namespace idiophone {

class Player;

/// Construct and destroy off the audio thread. While it lives, a tuner is a client of MTS-ESP.
class Tuner {
public:
    Tuner();

    /// [message side, one at a time] Sets the own tuning from the next callback on. Without an own
    /// tuning, that of the session acts.
    void setOwn(const std::optional<KeyTuning>& tuning) noexcept;

    /// [any thread except the audio thread] Returns whether a master tunes the session's plugins.
    bool hasMaster() const;
    /// [any thread except the audio thread] Returns the name of the master's scale; may be empty.
    std::string masterScaleName() const;

    /// [any thread] Returns whether messages of the MIDI Tuning Standard have tuned keys.
    bool isTunedByMessages() const noexcept { return tunedByMessages && !forgetsMessages; }
    /// [any thread] Drops the tuning by messages from the next callback on.
    void forgetMessages() noexcept { forgetsMessages = true; }

    /// [audio thread] Call once a callback and after `retune`: gives the tuning in effect to the
    /// player, if there is one. Neither allocates, locks nor throws.
    void tune(Player* player) noexcept;
    /// [audio thread] Reads a system exclusive message; ignores those that are not for tuning.
    /// Neither allocates, locks nor throws.
    void retune(std::span<const juce::uint8> message) noexcept;

private:
    struct Deregister {
        void operator()(MTSClient* client) const;
    };

    void followForgetting() noexcept;
    void readSession() noexcept;

    std::unique_ptr<MTSClient, Deregister> client;
    LatestValue<std::optional<KeyTuning>> handoff{std::nullopt}; ///< message side to audio thread
    std::atomic<bool> tunedByMessages{false};
    std::atomic<bool> forgetsMessages{false}; ///< until the next callback

    // Owned by the audio thread.
    std::optional<KeyTuning> own;
    MidiTuning messages;
    KeyTuning session;
};

} // namespace idiophone
