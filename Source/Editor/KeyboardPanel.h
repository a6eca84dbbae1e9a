// The on-screen keyboard with the instrument's notes. The computer's keys play it too.
#pragma once

#include "Editor/Look.h"
#include "Editor/ProcessorView.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <juce_audio_utils/juce_audio_utils.h>
#include <optional>

namespace idiophone {

/// The C from which the computer's keys, an octave and a half, cover most of the range.
inline int computerKeysBase(InstrumentView::KeyRange range) {
    constexpr int keys = 17; // the computer's keys A to ;
    const auto reached = [&](int base) {
        return std::min(range.highest, base + keys - 1) - std::max(range.lowest, base);
    };
    const int below = range.lowest - range.lowest % 12;
    return reached(below + 12) > reached(below) ? below + 12 : below;
}

class KeyboardPanel final : public juce::Component, private juce::MidiKeyboardState::Listener {
public:
    explicit KeyboardPanel(ProcessorView& processor) : view(processor) {
        keyboard.setScrollButtonsVisible(false);
        keyboard.setOctaveForMiddleC(4);
        keyboard.setTitle("Keyboard");
        if (!juce::JUCEApplicationBase::isStandaloneApp())
            keyboard.clearKeyMappings(); // the host uses the computer's keys
        addAndMakeVisible(keyboard);
        state.addListener(this);
        // JUCE's timer polls the keys 20 times a second, even at rest. Stop it: `refresh` polls
        // instead. The cast is needed because the base class is private.
        ((juce::Timer&)keyboard).stopTimer();
        refresh();
    }
    ~KeyboardPanel() override {
        state.allNotesOff(0);
        state.removeListener(this);
    }

    /// Called when the user plays a key here.
    std::function<void(int midiNote)> onKey;

    /// Marks keys with a line at their feet, or none.
    void mark(const std::optional<InstrumentView::KeyRange>& keys) {
        marked = keys;
        keyboard.repaint();
    }

    /// Shows the current instrument's range and the pressed keys.
    void refresh() {
        keyboard.timerCallback();
        showRange();
    }
    void takeFocus() { keyboard.grabKeyboardFocus(); }
    /// Plays the computer's keys that no other component took. Returns whether any key plays.
    bool followKeys(bool isDown) { return keyboard.keyStateChanged(isDown); }
    /// Releases the notes that the computer's keys hold, as a loss of focus does.
    void releaseKeys() {
        octaveKey = 0;
        keyboard.focusLost(focusChangedDirectly);
    }
    /// Z and X shift the computer's keys by an octave, within the visible keys. Key repeats are
    /// ignored until the key is released. Returns false for other keys.
    bool pressOctaveKey(const juce::KeyPress& key) {
        const auto letter = juce::CharacterFunctions::toLowerCase(key.getTextCharacter());
        if ((letter != 'z' && letter != 'x') || key.getModifiers().isAnyModifierKeyDown())
            return false;
        if (letter != octaveKey)
            shiftComputerKeys(letter == 'z' ? -1 : 1);
        octaveKey = letter;
        return true;
    }
    /// The note of the key at a place of the panel, if there is one.
    std::optional<int> noteAt(juce::Point<int> place) const {
        for (const bool white : {false, true}) // black keys lie on top
            for (int note = lowest; note <= highest; ++note)
                if (isWhite(note) == white &&
                    keyboard.getRectangleForKey(note).contains(place.toFloat()))
                    return note;
        return std::nullopt;
    }
    /// The note of the computer's first key, a C.
    int computerKeysNote() const { return baseNote; }

    void resized() override {
        keyboard.setKeyWidth(static_cast<float>(getWidth()) / static_cast<float>(whiteKeys()));
        keyboard.setBounds(getLocalBounds());
    }
    void lookAndFeelChanged() override {
        using Keyboard = juce::MidiKeyboardComponent;
        const auto accent = colourOf(*this, LookColour::accent);
        keyboard.setColour(Keyboard::whiteNoteColourId, juce::Colour(0xffd9d6cf));
        keyboard.setColour(Keyboard::blackNoteColourId, juce::Colour(0xff23262c));
        keyboard.setColour(Keyboard::keySeparatorLineColourId, juce::Colour(0xff2e333c));
        keyboard.setColour(Keyboard::keyDownOverlayColourId, accent);
        keyboard.setColour(Keyboard::mouseOverKeyOverlayColourId, accent.withAlpha(0.35f));
        keyboard.setColour(Keyboard::shadowColourId, juce::Colours::transparentBlack);
    }

private:
    static bool isWhite(int note) { return !juce::MidiMessage::isMidiNoteBlack(note); }
    int whiteKeys() const {
        int count = 0;
        for (int note = lowest; note <= highest; ++note)
            count += isWhite(note) ? 1 : 0;
        return count;
    }

    void handleNoteOn(juce::MidiKeyboardState*, int, int note, float velocity) override {
        view.instrument.playNote(note, juce::jlimit(1, 127, juce::roundToInt(velocity * 127)));
        juce::NullCheckedInvocation::invoke(onKey, note);
    }
    void handleNoteOff(juce::MidiKeyboardState*, int, int note, float) override {
        view.instrument.playNote(note, 0);
    }

    /// Greys keys that play nothing, dims keys that play another key's object, and marks others.
    class Keys final : public juce::MidiKeyboardComponent {
    public:
        explicit Keys(KeyboardPanel& panel)
            : MidiKeyboardComponent(panel.state, horizontalKeyboard), owner(panel) {}

        bool keyStateChanged(bool isDown) override {
            if (auto& held = owner.octaveKey;
                held != 0 && !juce::KeyPress::isKeyCurrentlyDown(static_cast<int>(held)))
                held = 0;
            return MidiKeyboardComponent::keyStateChanged(isDown);
        }
        void drawWhiteNote(int note,
                           juce::Graphics& g,
                           juce::Rectangle<float> area,
                           bool isDown,
                           bool isOver,
                           juce::Colour lineColour,
                           juce::Colour textColour) override {
            MidiKeyboardComponent::drawWhiteNote(note, g, area, isDown, isOver, lineColour,
                                                 textColour);
            drawState(note, g, area);
        }
        void drawBlackNote(int note,
                           juce::Graphics& g,
                           juce::Rectangle<float> area,
                           bool isDown,
                           bool isOver,
                           juce::Colour fillColour) override {
            MidiKeyboardComponent::drawBlackNote(note, g, area, isDown, isOver, fillColour);
            drawState(note, g, area);
        }

    private:
        void drawState(int note, juce::Graphics& g, juce::Rectangle<float> area) const {
            using enum InstrumentView::KeySound;
            const auto sound = owner.sounds[static_cast<std::size_t>(note)];
            if (sound != own) {
                g.setColour(juce::Colour(sound == resized ? 0x58707a88 : 0xa0808286));
                g.fillRect(area);
            }
            if (owner.marked && owner.marked->lowest <= note && note <= owner.marked->highest) {
                g.setColour(colourOf(*this, LookColour::accent));
                g.fillRect(area.removeFromBottom(5).reduced(1, 0));
            }
        }

        KeyboardPanel& owner;
    };

    void showRange() {
        const auto range = view.instrument.keyRange();
        const auto now = view.instrument.keySounds();
        if (range == shown && now == sounds)
            return;
        shown = range;
        sounds = now;
        auto drawn = range; // and all keys that sound
        for (int note = 0; note < 128; ++note)
            if (sounds[static_cast<std::size_t>(note)] != InstrumentView::KeySound::silent) {
                drawn.lowest = std::min(drawn.lowest, note);
                drawn.highest = std::max(drawn.highest, note);
            }
        lowest = drawn.lowest - drawn.lowest % 12;
        highest = juce::jlimit(lowest, 127, juce::jmax(drawn.highest, lowest + 24));
        if (!isWhite(highest))
            ++highest;
        state.allNotesOff(0);
        keyboard.setAvailableRange(lowest, highest);
        baseNote = computerKeysBase(range);
        keyboard.setKeyPressBaseOctave(baseNote / 12);
        resized();
        keyboard.repaint();
    }
    void shiftComputerKeys(int octaves) {
        const int shifted = baseNote + 12 * octaves;
        if (shifted < lowest || shifted > highest)
            return;
        releaseKeys();
        baseNote = shifted;
        keyboard.setKeyPressBaseOctave(baseNote / 12);
    }

    ProcessorView& view;
    InstrumentView::KeyRange shown{.lowest = -1, .highest = -1};
    std::optional<InstrumentView::KeyRange> marked;
    std::array<InstrumentView::KeySound, 128> sounds{};
    int lowest = 0, highest = 127;  ///< MIDI notes, of the drawn keys
    int baseNote = 0;               ///< MIDI note of the computer's first key
    juce::juce_wchar octaveKey = 0; ///< the pressed one of the keys 'z' and 'x', or 0
    juce::MidiKeyboardState state;  // locked by its functions, so never used on the audio thread
    Keys keyboard{*this};
};

} // namespace idiophone
