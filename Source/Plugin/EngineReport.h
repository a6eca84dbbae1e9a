// Everything that the audio engine reports to other threads, except program changes.
#pragma once

#include "Instrument/HeldContacts.h"
#include "Plugin/LastSound.h"
#include "Plugin/SoundMonitor.h"
#include "Plugin/StageCapture.h"

#include <atomic>
#include <cstdint>

namespace idiophone {

/// The audio thread writes every field once per callback, and any thread reads it. Comments name
/// the exceptions.
struct EngineReport {
    SoundMonitor monitor; ///< the sound as the window shows it; for the message thread
    StageCapture capture; ///< the impacts of a stage's bodies; for the message thread
    LastSound lastSound;  ///< the output, except of an offline render

    std::atomic<std::uint32_t> callbacks{0}; ///< one more for each `prepare`
    std::atomic<std::int64_t> notFinite{0};  ///< how often output that was not finite was silenced
    std::atomic<float> peak{0};              ///< of the output; the reader sets it to 0
    std::atomic<int> modulationWheel{HeldContacts::controllerAtRest};
    std::atomic<std::int64_t> modesMixed{0};
    std::atomic<std::int64_t> lateEvents{0};
    std::atomic<double> tempo{0}; ///< last reported by the host, or 0
    /// [semitones] How far any key may sound below equal temperament, by tunings and wheels.
    std::atomic<double> semitonesBelowEqual{0};
    /// Whether the player has played keys without an object of their own. A new sound clears it.
    std::atomic<bool> playedResizedKeys{false};
};

} // namespace idiophone
