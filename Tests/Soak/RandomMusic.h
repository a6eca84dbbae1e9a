// Makes random music on sixteen channels: notes of any length, controllers, pedals, tunings. Tracks
// the pending note-offs and pedal releases.
#pragma once

#include "Editor/ProcessorView.h"
#include "Soak/Chance.h"

#include <cstdint>
#include <juce_audio_basics/juce_audio_basics.h>
#include <map>
#include <utility>

namespace idiophone::test {

/// Adds messages that undo changes by music: equal temperament, no MPE zones, pitch wheels centred
/// at a range of two semitones, controllers at rest.
void addDefaults(juce::MidiBuffer& midi);
/// Adds all notes off and a controller reset on every channel, as hosts do when they stop.
void addEndOfNotes(juce::MidiBuffer& midi);

class RandomMusic {
public:
    struct Block {
        std::int64_t start; ///< first sample, counted from the start of the music
        int length;         ///< samples
        double rateHz;
        InstrumentView::KeyRange keys;
    };

    explicit RandomMusic(Chance& drawnFrom) : chance(drawnFrom) {}

    /// Adds the events of a block in order of time, and records pending releases.
    void add(juce::MidiBuffer& midi, const Block& block, double expectedNotes);

    /// Holds a key of the last channel softly until the sample `end`. Meanwhile no other note is
    /// long, so that the slide is not cut for a new voice, and no controller ends it.
    void slide(juce::MidiBuffer& midi, InstrumentView::KeyRange keys, std::int64_t end);
    bool isSliding() const { return slides; }
    /// Treats the slide as an ordinary note from now on.
    void endSlide() { slides = false; }

    /// Adds all pending note-offs and pedal releases.
    void addOwed(juce::MidiBuffer& midi) const;
    /// Forgets pending releases.
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
    /// Keys held, by channel and note, with the sample of their release.
    std::map<std::pair<int, int>, std::int64_t> keysDown;
    std::map<int, Pedals> pedalsDown; ///< by channel
    bool slides = false;
    std::int64_t notes = 0;
};

} // namespace idiophone::test
