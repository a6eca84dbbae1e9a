// The on-screen keyboard over the notes that the instrument has; the computer's keys play it too.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_audio_utils/juce_audio_utils.h>

namespace idiophone {

/// The C from which the computer's keys, an octave and a half, reach most of a range of notes.
int computerKeysBase(ProcessorView::KeyRange range);

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
    void releaseKeys();
    /// Z and X let the computer's keys play an octave lower or higher, within the keys that are
    /// shown: once until they come up, however often they are repeated. False for other keys.
    bool pressOctaveKey(const juce::KeyPress& key);
    /// The C that the computer's first key plays.
    int computerKeysNote() const { return baseNote; }

    void resized() override;
    void lookAndFeelChanged() override;

private:
    void handleNoteOn(juce::MidiKeyboardState*, int channel, int note, float velocity) override;
    void handleNoteOff(juce::MidiKeyboardState*, int channel, int note, float velocity) override;

    /// Those that play nothing are greyed, and those that play another key's object are dimmed.
    class Keys final : public juce::MidiKeyboardComponent {
    public:
        explicit Keys(KeyboardPanel& panel)
            : MidiKeyboardComponent(panel.state, horizontalKeyboard), owner(panel) {}

        bool keyStateChanged(bool isDown) override;

        void drawWhiteNote(int note,
                           juce::Graphics& g,
                           juce::Rectangle<float> area,
                           bool isDown,
                           bool isOver,
                           juce::Colour lineColour,
                           juce::Colour textColour) override;
        void drawBlackNote(int note,
                           juce::Graphics& g,
                           juce::Rectangle<float> area,
                           bool isDown,
                           bool isOver,
                           juce::Colour fillColour) override;

    private:
        void shadeUnlessOwn(int note, juce::Graphics& g, juce::Rectangle<float> area) const;

        KeyboardPanel& owner;
    };

    void showRange();
    void shiftComputerKeys(int octaves);

    ProcessorView& view;
    ProcessorView::KeyRange shown{.lowest = -1, .highest = -1};
    std::array<ProcessorView::KeySound, 128> sounds{};
    int lowest = 0, highest = 127;  ///< of the keys drawn
    int baseNote = 0;               ///< of the computer's keys
    juce::juce_wchar octaveKey = 0; ///< 'z' or 'x' while it is held
    juce::MidiKeyboardState state;  // never seen by the audio thread: it locks
    Keys keyboard{*this};
};

} // namespace idiophone
