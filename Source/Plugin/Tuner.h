// Which tuning the keys have: the user's own for this instance, or else what a master of the
// session (MTS-ESP) or MIDI Tuning Standard messages say.
#pragma once

#include "Instrument/KeyTuning.h"
#include "Plugin/LatestValue.h"

#include <atomic>
#include <juce_audio_basics/juce_audio_basics.h>
#include <memory>
#include <optional>
#include <span>
#include <string>

struct MTSClient;

namespace idiophone {

class Player;

/// Constructed and destroyed off the audio thread; a client of MTS-ESP for as long as it lives.
class Tuner {
public:
    Tuner();

    /// [message side, one at a time] Holds from the next callback on; nothing leaves the tuning to
    /// the session.
    void setOwn(const std::optional<KeyTuning>& tuning) noexcept;

    /// [any thread but the audio thread] Whether a master tunes the plugins of the session.
    bool hasMaster() const;
    /// [any thread but the audio thread] The master's scale, which may have no name.
    std::string masterScaleName() const;

    /// [any thread] Whether messages of the MIDI Tuning Standard have tuned keys.
    bool isTunedByMessages() const noexcept { return tunedByMessages && !forgetsMessages; }
    /// [any thread] From the next callback on keys are as without the messages before.
    void forgetMessages() noexcept { forgetsMessages = true; }

    /// [audio thread] Once a callback, and after `retune`: gives the tuning that holds to the
    /// player, if there is one. Neither allocates, locks nor throws, as the next one.
    void tune(Player* player) noexcept;
    /// [audio thread] Takes in a system exclusive message, whatever it is.
    void retune(std::span<const juce::uint8> message) noexcept;

private:
    struct Own {
        bool isGiven = false;
        KeyTuning keys;
    };
    struct Deregister {
        void operator()(MTSClient* client) const;
    };

    void retuneKeys(std::span<const juce::uint8> keys, bool areNamed) noexcept;
    void followForgetting() noexcept;
    void readSession() noexcept;

    std::unique_ptr<MTSClient, Deregister> client;
    LatestValue<Own> handoff{Own{}}; ///< message side to audio thread
    std::atomic<bool> tunedByMessages{false};
    std::atomic<bool> forgetsMessages{false}; ///< the client has not forgotten them yet

    // The audio thread's.
    Own own;
    KeyTuning session;
};

} // namespace idiophone
