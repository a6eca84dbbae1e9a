// Everything that the session and the window give the audio engine. The engine reads each field at
// the start of a callback; the comment names the thread that writes it.
#pragma once

#include "Instrument/Player.h"
#include "Plugin/Handoff.h"
#include "Plugin/MidiLearn.h"
#include "Plugin/ModeSilencer.h"
#include "Plugin/Tuner.h"
#include "Plugin/WindowEvents.h"

#include <atomic>
#include <cstdint>

namespace idiophone {

/// "Session" is any thread that holds the session's lock (SoundSession).
struct EngineMessages {
    Handoff<Player> players; ///< [session] new players, and the return of former ones
    /// [session] Odd while values and their player are being handed over.
    std::atomic<std::uint32_t> soundChanges{0};
    ModeSilencer silencer;                      ///< [session] muted modes
    Tuner tuner;                                ///< [session] the instance's own tuning
    MidiLearn controllers;                      ///< [message thread; session for a state]
    WindowEvents window;                        ///< [message thread] keys and hands
    std::atomic<bool> stagePaused{false};       ///< [message thread; session for a new sound]
    std::atomic<bool> stageReset{false};        ///< [message thread] until the player is reset
    std::atomic<bool> forgetsGivenBends{false}; ///< [session] until the bends are forgotten
    std::atomic<bool> reset{false};             ///< [host] until everything is silent
};

} // namespace idiophone
