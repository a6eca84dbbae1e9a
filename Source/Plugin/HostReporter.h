// Reports to the host what changes in the plugin: new sounds, moved parameters, other state.
#pragma once

#include "Plugin/HostParameters.h"
#include "Plugin/MidiLearn.h"
#include "Plugin/Vst3Edits.h"

#include <atomic>
#include <functional>
#include <juce_audio_processors/juce_audio_processors.h>

namespace idiophone {

/// Call it without the session's lock: a host may call back at once.
class HostReporter {
public:
    /// `pollSoon` makes the message thread call `poll` as soon as it can.
    HostReporter(juce::AudioProcessor& processor,
                 HostParameters& parameters,
                 std::function<void()> pollSoon);

    /// [any thread except the audio thread, offline any] Reports all values and the program to the
    /// host.
    void reportSound();
    /// [thread on which the host chose a program] Reports all values and the program. An offline
    /// VST3 host knows the values on return, also where no message loop runs: it may send the
    /// values that it knows back with the next block.
    void reportChosenProgram();
    /// [message thread] Reports another program, or its name.
    void reportProgram();
    /// [message thread] Reports that the state has changed outside the parameters.
    void reportState();
    /// [any thread except the audio thread] Keep one while a state is restored. JUCE's VST3 reports
    /// nothing meanwhile, so `poll` delays the reports of the sound.
    class Restoring {
    public:
        explicit Restoring(HostReporter& ofHost) noexcept : reporter(ofHost) {
            ++reporter.restorings;
        }
        ~Restoring() { --reporter.restorings; }
        Restoring(const Restoring&) = delete;
        Restoring& operator=(const Restoring&) = delete;

    private:
        HostReporter& reporter;
    };
    /// [message thread] Drops all further reports, before the host has asked for anything.
    void forget() noexcept { soundsToReport = movesToReport = 0; }

    /// [message thread] Reports the moves of controllers and the remaining reports of
    /// `reportSound`. Do not call it during an offline render: a late echo from the host would make
    /// the render depend on time.
    void poll(MidiLearn& controllers);

    /// For the wrapper.
    Vst3Edits& vst3() noexcept { return edits; }

private:
    juce::AudioProcessor& processor;
    HostParameters& parameters;
    std::function<void()> pollSoon;
    Vst3Edits edits;
    std::atomic<int> soundsToReport{0}; ///< further reports of the sound
    int movesToReport = 0; ///< further reports of moved values; only for the message thread
    std::atomic<int> restorings{0};
};

} // namespace idiophone
