// The on-screen keyboard over the notes that the instrument has; the computer's keys play it too.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_audio_utils/juce_audio_utils.h>

namespace idiophone {

class KeyboardPanel final : public juce::Component, private juce::MidiKeyboardState::Listener {
public:
    explicit KeyboardPanel(ProcessorView& view);
    ~KeyboardPanel() override;

    /// Shows the range of the instrument that is loaded now, and which keys are down.
    void refresh();
    void takeFocus() { keyboard.grabKeyboardFocus(); }
    /// Keys of the computer are down or up that nothing else has taken; whether they play.
    bool followKeys(bool isDown) { return keyboard.keyStateChanged(isDown); }
    /// As when it loses the focus: what the computer's keys hold is let go.
    void releaseKeys() { keyboard.focusLost(focusChangedDirectly); }

    void resized() override;
    void lookAndFeelChanged() override;

private:
    void handleNoteOn(juce::MidiKeyboardState*, int channel, int note, float velocity) override;
    void handleNoteOff(juce::MidiKeyboardState*, int channel, int note, float velocity) override;

    void showRange();

    ProcessorView& view;
    ProcessorView::KeyRange shown{.lowest = -1, .highest = -1};
    int lowest = 0, highest = 127; ///< of the keys drawn
    juce::MidiKeyboardState state; // never seen by the audio thread: it locks
    juce::MidiKeyboardComponent keyboard{state, juce::MidiKeyboardComponent::horizontalKeyboard};
};

} // namespace idiophone
