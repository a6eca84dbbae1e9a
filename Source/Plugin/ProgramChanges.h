// Carries MIDI program changes from the audio thread to the session, and answers in return.
#pragma once

#include "Instrument/LatestValue.h"
#include "Plugin/HostParameters.h"
#include "Plugin/PendingKeys.h"

#include <atomic>
#include <cstdint>
#include <juce_audio_basics/juce_audio_basics.h>
#include <optional>
#include <span>

namespace idiophone {

class ProgramChanges {
public:
    /// The program, with a serial number in the upper bits, because MIDI may ask for the same
    /// program again.
    using Request = std::int64_t;
    static constexpr Request none = -1;
    static constexpr int programOf(Request request) { return int(request % programsOfMidi); }

    /// The values when MIDI asked for a program, and how often each had been set. Values set later
    /// belong to the program.
    struct Moment {
        Request request = none;
        std::uint32_t soundChanges = 0; ///< if unchanged, no other sound was loaded since
        HostParameters::Moves moves{};
        ParameterValues values;
    };

    /// Follows changes to programs 0 to `programCount` - 1 and ignores others.
    explicit ProgramChanges(int programCount) : keys(programCount) {}

    // [audio thread] Neither allocates, locks nor throws.

    /// Returns the place behind the block's last program change, or its start.
    juce::MidiBufferIterator behindLast(const juce::MidiBuffer& midi) const noexcept;
    /// Keeps the current values for the next request.
    void keepMoment(const HostParameters& parameters, std::uint32_t soundChanges) noexcept;
    /// Takes channel messages, in order of time, and requests the last program among them.
    void follow(std::span<const MidiEvent> events) noexcept;
    /// Returns the keys to strike at once: those held since the request that this new player
    /// answers. Call it once a callback, with nullptr if there is no new player.
    std::span<const MidiEvent> takeKeys(const Player* next) noexcept;
    /// Forgets the keys held now. A requested program stays pending.
    void forgetKeys() noexcept { keys.forgetKeys(); }

    /// [message side] Forgets the keys that no answer will strike. Call while no callback runs.
    void prepare() noexcept;

    // [session] One thread at a time.

    /// Returns the last request, until it is answered, refused or cancelled.
    Request pending() const noexcept { return requested; }
    /// Returns the moment of this request if it is the newest one, else nullptr.
    const Moment* momentOf(Request request) noexcept;
    /// The next players answer this request.
    void answer(Request request) noexcept { answered = request; }
    /// Returns the label that a player gets when it is handed over: the request that it answers.
    Request label() const noexcept { return answered; }
    /// Ends a request, unless a newer one has come. Without an answer its keys are forgotten.
    void end(Request request, bool isAnswered) noexcept;
    /// A state overrides a pending request.
    void cancel() noexcept;

private:
    static constexpr Request programsOfMidi = 128;

    std::atomic<Request> requested{none}, refused{none};
    LatestValue<Moment> moments{{}};

    // Members of the audio thread.
    PendingKeys keys;
    Moment atLastChange;
    Request requests = 0;      ///< number of requests
    Request unanswered = none; ///< the last request

    // Members of the session.
    Request answered = none;
    Moment newest;
};

} // namespace idiophone
