// Music at random on sixteen channels: notes of any length, controllers, pedals, tunings. Knows
// what it owes: the note-offs of keys and the ends of pedals that are down.
#pragma once

#include "Editor/ProcessorView.h"
#include "Soak/Chance.h"

#include <cstdint>
#include <juce_audio_basics/juce_audio_basics.h>
#include <map>
#include <utility>

namespace idiophone::test {

/// What music may have changed as it is at first: equal temperament, no MPE zones, wheels of two
/// semitones in the middle, controllers.
void addDefaults(juce::MidiBuffer& midi);
/// On every channel as hosts do who stop: all notes off, controllers reset.
void addEndOfNotes(juce::MidiBuffer& midi);

class RandomMusic {
public:
    struct Block {
        std::int64_t start; ///< its first sample, since the music began
        int length;         ///< samples
        double rateHz;
        ProcessorView::KeyRange keys;
    };

    explicit RandomMusic(Chance& drawnFrom) : chance(drawnFrom) {}

    /// In order of time, in which what is owed is noted as it becomes so.
    void add(juce::MidiBuffer& midi, const Block& block, double expectedNotes);

    /// Holds a key of the last channel softly until that sample. Meanwhile no other note is long,
    /// so that it never has to make room, and no controller ends it.
    void slide(juce::MidiBuffer& midi, ProcessorView::KeyRange keys, std::int64_t end);
    bool isSliding() const { return slides; }
    /// From now on a slide is none.
    void endSlide() { slides = false; }

    /// The note-offs and pedals that are owed.
    void addOwed(juce::MidiBuffer& midi) const;
    /// Nothing is owed any more.
    void forget();

    std::int64_t notesPlayed() const { return notes; }

private:
    struct Pedals {
        bool sustains = false, catches = false;
    };

    void addNote(juce::MidiBuffer& midi, const Block& block, int channel, int stamp);
    void addControllers(juce::MidiBuffer& midi, int channel, int note, int stamp);
    void addTuning(juce::MidiBuffer& midi, int stamp);
    void addDueReleases(juce::MidiBuffer& midi, const Block& block, int last);
    void control(juce::MidiBuffer& midi, int channel, int number, int value, int stamp);

    Chance& chance;
    /// Keys that are down, by channel and note, with the sample at which they go up.
    std::map<std::pair<int, int>, std::int64_t> keysDown;
    std::map<int, Pedals> pedalsDown; ///< by channel
    bool slides = false;
    std::int64_t notes = 0;
};

} // namespace idiophone::test
