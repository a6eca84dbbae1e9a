#include "Editor/KeyboardPanel.h"

#include "Editor/Look.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

bool isWhite(int note) {
    return !juce::MidiMessage::isMidiNoteBlack(note);
}

int whiteKeys(int lowest, int highest) {
    int count = 0;
    for (int note = lowest; note <= highest; ++note)
        count += isWhite(note) ? 1 : 0;
    return count;
}

/// Extends the range to all keys that sound.
InstrumentView::KeyRange soundingRange(InstrumentView::KeyRange range,
                                       const std::array<InstrumentView::KeySound, 128>& sounds) {
    for (int note = 0; note < 128; ++note)
        if (sounds[static_cast<std::size_t>(note)] != InstrumentView::KeySound::silent) {
            range.lowest = std::min(range.lowest, note);
            range.highest = std::max(range.highest, note);
        }
    return range;
}

} // namespace

int computerKeysBase(InstrumentView::KeyRange range) {
    constexpr int keys = 17; // the computer's keys A to ;
    const auto reached = [&](int base) {
        return std::min(range.highest, base + keys - 1) - std::max(range.lowest, base);
    };
    const int below = range.lowest - range.lowest % 12;
    return reached(below + 12) > reached(below) ? below + 12 : below;
}

KeyboardPanel::KeyboardPanel(ProcessorView& processor) : view(processor) {
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

void KeyboardPanel::lookAndFeelChanged() {
    using Keyboard = juce::MidiKeyboardComponent;
    const auto accent = colourOf(*this, LookColour::accent);
    keyboard.setColour(Keyboard::whiteNoteColourId, juce::Colour(0xffd9d6cf));
    keyboard.setColour(Keyboard::blackNoteColourId, juce::Colour(0xff23262c));
    keyboard.setColour(Keyboard::keySeparatorLineColourId, juce::Colour(0xff2e333c));
    keyboard.setColour(Keyboard::keyDownOverlayColourId, accent);
    keyboard.setColour(Keyboard::mouseOverKeyOverlayColourId, accent.withAlpha(0.35f));
    keyboard.setColour(Keyboard::shadowColourId, juce::Colours::transparentBlack);
}

KeyboardPanel::~KeyboardPanel() {
    state.allNotesOff(0);
    state.removeListener(this);
}

void KeyboardPanel::refresh() {
    keyboard.timerCallback();
    showRange();
}

void KeyboardPanel::showRange() {
    const auto range = view.instrument.keyRange();
    const auto now = view.instrument.keySounds();
    if (range.lowest == shown.lowest && range.highest == shown.highest && now == sounds)
        return;
    shown = range;
    sounds = now;
    const auto drawn = soundingRange(range, sounds);
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

void KeyboardPanel::releaseKeys() {
    octaveKey = 0;
    keyboard.focusLost(focusChangedDirectly);
}

bool KeyboardPanel::pressOctaveKey(const juce::KeyPress& key) {
    const auto letter = juce::CharacterFunctions::toLowerCase(key.getTextCharacter());
    if ((letter != 'z' && letter != 'x') || key.getModifiers().isAnyModifierKeyDown())
        return false;
    if (letter != octaveKey)
        shiftComputerKeys(letter == 'z' ? -1 : 1);
    octaveKey = letter;
    return true;
}

void KeyboardPanel::shiftComputerKeys(int octaves) {
    const int shifted = baseNote + 12 * octaves;
    if (shifted < lowest || shifted > highest)
        return;
    releaseKeys();
    baseNote = shifted;
    keyboard.setKeyPressBaseOctave(baseNote / 12);
}

void KeyboardPanel::resized() {
    keyboard.setKeyWidth(static_cast<float>(getWidth()) /
                         static_cast<float>(whiteKeys(lowest, highest)));
    keyboard.setBounds(getLocalBounds());
}

void KeyboardPanel::handleNoteOn(juce::MidiKeyboardState*, int, int note, float velocity) {
    view.instrument.playNote(note, juce::jlimit(1, 127, juce::roundToInt(velocity * 127)));
}

void KeyboardPanel::handleNoteOff(juce::MidiKeyboardState*, int, int note, float) {
    view.instrument.playNote(note, 0);
}

} // namespace idiophone
