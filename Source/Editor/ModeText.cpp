#include "Editor/ModeText.h"

#include "Editor/FigureText.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <cmath>
#include <juce_audio_basics/juce_audio_basics.h>

namespace idiophone {
double decibelsOf(double metresPerSecond) {
    return juce::Decibels::gainToDecibels(metresPerSecond, faintestDecibels);
}

juce::String frequencyText(double frequencyHz) {
    if (frequencyHz >= 9999.5)
        return threeDigits(frequencyHz / 1000) + " kHz";
    return (frequencyHz < 999.95 ? juce::String(frequencyHz, 1)
                                 : juce::String(juce::roundToInt(frequencyHz))) +
           " Hz";
}

juce::String secondsText(double seconds) {
    return seconds < 0.9995 ? juce::String(juce::roundToInt(seconds * 1000)) + " ms"
                            : threeDigits(seconds) + " s";
}

juce::String noteName(int midiNote) {
    return juce::MidiMessage::getMidiNoteName(midiNote, true, true, 4);
}

juce::String keysText(InstrumentView::KeyRange keys) {
    return keys.lowest == keys.highest
               ? noteName(keys.lowest)
               : noteName(keys.lowest) + fromUtf8("\xe2\x80\x93") + noteName(keys.highest); // –
}

std::optional<int> parseNoteName(const juce::String& text) {
    const auto typed = text.trim();
    for (int note = 0; note < 128; ++note)
        for (const auto& name : {juce::String(note), noteName(note),
                                 juce::MidiMessage::getMidiNoteName(note, false, true, 4)})
            if (name.equalsIgnoreCase(typed))
                return note;
    return std::nullopt;
}

juce::String objectText(const InstrumentView::PlayedObject& played) {
    const auto name = fromUtf8(played.object->name);
    return played.lowestNote == played.highestNote ? noteName(played.lowestNote) + "  " + name
                                                   : name;
}

juce::String noteText(double frequencyHz) {
    const double note = 69 + 12 * std::log2(frequencyHz / 440);
    if (!(note > -0.5 && note < 127.5))
        return {};
    const int nearest = juce::roundToInt(note);
    const int cents = juce::roundToInt(100 * (note - nearest));
    return noteName(nearest) + (cents < 0 ? " " : " +") + juce::String(cents) + " ct";
}

juce::String standingText(const ModeNow& mode) {
    switch (mode.standing) {
    case ModeStanding::sounding:
        return "sounding";
    case ModeStanding::beyondBudget:
        return "excluded by the budget";
    case ModeStanding::outOfBand:
        return "outside the audible band";
    case ModeStanding::silenced:
        return mode.isMuted ? "muted" : "silenced by a solo";
    case ModeStanding::belowTau:
        break;
    }
    return mode.amplitude > 0 ? "below the threshold" : "silent";
}

juce::StringArray describeMode(const SoundFrame& frame, std::size_t index) {
    const ModeNow& mode = frame.modes[index];
    const auto note = noteText(static_cast<double>(mode.frequencyHz));
    const auto sameGroup = std::ranges::count(frame.modes, mode.group, &ModeNow::group);
    const double decibels = decibelsOf(static_cast<double>(mode.amplitude));
    juce::StringArray lines;
    lines.add("Mode " + juce::String(index + 1) + ": " +
              frequencyText(static_cast<double>(mode.frequencyHz)) +
              (note.isEmpty() ? juce::String() : ", " + note) + ", T60 " +
              secondsText(static_cast<double>(mode.t60Seconds)));
    lines.add((decibels > faintestDecibels ? juce::String(juce::roundToInt(decibels)) + " dB, "
                                           : juce::String()) +
              standingText(mode) + (mode.isHeardAlone ? ", solo" : "") +
              (sameGroup > 1 ? ", merged with " + juce::String(sameGroup - 1) +
                                   (sameGroup == 2 ? " other" : " others")
                             : juce::String()));
    return lines;
}

} // namespace idiophone
