// Loads and saves what the host and MIDI ask for: states and programs.
#pragma once

#include "Plugin/SoundSession.h"
#include "Plugin/State.h"
#include "Plugin/TuningSession.h"

#include <string>
#include <string_view>

namespace idiophone {

/// For any thread except the audio thread. An offline render also follows requests between two
/// blocks.
class HostSession {
public:
    HostSession(SharedParts& sharedParts, SoundSession& soundSession, TuningSession& tuningSession)
        : shared(sharedParts), session(soundSession), tuning(tuningSession) {}

    /// Returns the state as bytes.
    std::string save();
    /// Returns with the instrument ready: the next block plays it. A state that cannot be restored
    /// changes nothing and shows one sentence in the status line.
    void restore(std::string_view bytes);

    /// Loads a factory preset for the host. Ignores other indices.
    void chooseProgram(int index) { chooseProgram(index, ProgramChanges::none); }
    /// Loads the program that MIDI has asked for, if any.
    void followRequest();

private:
    Result<void> play(const State& state);
    void chooseProgram(int index, ProgramChanges::Request request);
    Result<bool> loadProgram(int index, ProgramChanges::Request request);

    SharedParts& shared;
    SoundSession& session;
    TuningSession& tuning;
};

} // namespace idiophone
