// The on-screen keyboard with the instrument's notes. The computer's keys play it too.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_audio_utils/juce_audio_utils.h>

namespace idiophone {

/// The C from which the computer's keys, an octave and a half, cover most of the range.
int computerKeysBase(InstrumentView::KeyRange range);

class KeyboardPanel final : public juce::Component, private juce::MidiKeyboardState::Listener {
public:
    explicit KeyboardPanel(ProcessorView& view);
    ~KeyboardPanel() override;

    /// Shows the current instrument's range and the pressed keys.
    void refresh();
    void takeFocus() { keyboard.grabKeyboardFocus(); }
    /// Plays the computer's keys that no other component took. Returns whether any key plays.
    bool followKeys(bool isDown) { return keyboard.keyStateChanged(isDown); }
    /// Releases the notes that the computer's keys hold, as a loss of focus does.
    void releaseKeys();
    /// Z and X shift the computer's keys by an octave, within the visible keys. Key repeats are
    /// ignored until the key is released. Returns false for other keys.
    bool pressOctaveKey(const juce::KeyPress& key);
    /// The note of the computer's first key, a C.
    int computerKeysNote() const { return baseNote; }

    void resized() override;
    void lookAndFeelChanged() override;

private:
    void handleNoteOn(juce::MidiKeyboardState*, int channel, int note, float velocity) override;
    void handleNoteOff(juce::MidiKeyboardState*, int channel, int note, float velocity) override;

    /// Greys keys that play nothing, and dims keys that play another key's object.
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
    InstrumentView::KeyRange shown{.lowest = -1, .highest = -1};
    std::array<InstrumentView::KeySound, 128> sounds{};
    int lowest = 0, highest = 127;  ///< MIDI notes, of the drawn keys
    int baseNote = 0;               ///< MIDI note of the computer's first key
    juce::juce_wchar octaveKey = 0; ///< the pressed one of the keys 'z' and 'x', or 0
    juce::MidiKeyboardState state;  // locked by its functions, so never used on the audio thread
    Keys keyboard{*this};
};

} // namespace idiophone
