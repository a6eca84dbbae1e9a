// A host that plays a processor at random: notes of any length, controllers, automation, tunings,
// presets, states, blocks of any size. The same seed does the same.
#pragma once

#include "Plugin/Processor.h"
#include "Soak/RandomMusic.h"

#include <cstdint>
#include <string>
#include <vector>

namespace idiophone::test {

/// Left and right in turn.
using PlayedPhrase = std::vector<float>;
double rmsLevel(const PlayedPhrase& phrase);

class RandomSession {
public:
    enum class Changes {
        parameters, ///< by automation, on the thread that plays: the player stays the same one
        all         ///< and sounds, sample rates and resets, offline: no player lasts long
    };
    /// Prepares the processor to play.
    explicit RandomSession(Processor& played, Changes whatChanges = Changes::all);

    /// Has a new player of a factory program, at 48 kHz; scenes are passed over.
    void load(int program);

    /// Plays so many seconds of music, from the first of which on a key may be held to the last of
    /// them. Throws a sentence on a sample that is not finite.
    void play(double seconds, std::uint64_t seed, double notesPerSecond = 12);

    /// Loads a preset, or keeps, restores or resets a state.
    void changeSound();

    /// Releases what is down: mostly by the note-offs and pedals that are owed and nothing else, at
    /// times as hosts do who stop (all notes off, or a reset). Then plays every key there is, in
    /// turn. Throws a sentence where either is not soon followed by silence, though nothing but
    /// dampers ends what rings.
    void settle();

    /// A phrase, struck: with parameters, controllers and tuning put back, by the player there is
    /// and with whatever it remembers.
    PlayedPhrase phrase();
    /// The same after a reset, and by a new player of the state that the processor had at first.
    PlayedPhrase phraseAfterReset();
    PlayedPhrase phraseAnew();

    /// The depth of the motor's tremolo in a key that is held for ten seconds and rolls, from
    /// parameters put back: the part of the sound's power that comes and goes with its discs,
    /// over all of it.
    double tremolo();

    std::int64_t notesPlayed() const { return music.notesPlayed(); }
    std::int64_t samplesPlayed() const { return samples; }

private:
    void moveParameter();
    void changeHost();
    void prepare(double newRateHz);
    void putBack();
    PlayedPhrase renderPhrase();
    void releaseAll();
    void awaitSilence(const char* after);
    void render(juce::MidiBuffer& midi, int length);

    Processor& processor;
    Changes changes;
    Chance chance;
    RandomMusic music{chance};
    juce::AudioBuffer<float> buffer;
    std::vector<std::string> states; ///< kept on the way, to come back to
    std::string reference;
    double rateHz = 48000;
    double loudest = 0; ///< of what was rendered last
    std::int64_t samples = 0;
};

} // namespace idiophone::test
