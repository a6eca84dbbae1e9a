// Plays a short phrase on the instrument of a preset that has just been selected.
#pragma once

#include "Editor/InstrumentView.h"
#include "Editor/PhraseNotes.h"
#include "Editor/StageView.h"

#include <cstddef>
#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

/// For the message thread. Notes go the way of the on-screen keyboard, so that they reach the sound
/// that was loaded before them. As a mouse listener it ends the phrase at a click.
class PresetPhrase final : public juce::MouseListener, private juce::Timer {
public:
    /// The references must outlive it.
    PresetPhrase(InstrumentView& instrumentView, const StageView& stageView)
        : instrument(instrumentView), stage(stageView) {}
    ~PresetPhrase() override { stop(); }

    /// Starts the phrase of the loaded sound, and ends the last one. Does nothing where notes would
    /// be silent or the host's song plays.
    void play();
    /// Releases the keys at once.
    void stop();
    bool isPlaying() const { return isTimerRunning(); }

    /// Plays what is due that long after `play`; the timer calls it. A late call delays the rest.
    /// Ends a phrase whose instrument was replaced, or when the host's song starts.
    void tick(int millisecondsSincePlay);

    void mouseDown(const juce::MouseEvent&) override { stop(); }

private:
    /// Arrows that are held down pass over presets without striking each.
    static constexpr int pauseMilliseconds = 150, tickMilliseconds = 20;

    void timerCallback() override;

    InstrumentView& instrument;
    const StageView& stage;
    std::vector<PhraseNote> notes; ///< not yet released
    std::size_t started = 0;       ///< of them
    int instrumentNumber = 0;
    int lateMilliseconds = 0; ///< how much late ticks have delayed the rest of the phrase
    juce::uint32 startMilliseconds = 0;
};

} // namespace idiophone
