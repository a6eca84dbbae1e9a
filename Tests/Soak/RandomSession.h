// Drives a processor at random as a host: notes of any length, controllers, automation, tunings,
// presets, states, blocks of any size. The same seed gives the same session.
#pragma once

#include "Plugin/Processor.h"
#include "Soak/RandomMusic.h"

#include <cstdint>
#include <string>
#include <vector>

namespace idiophone::test {

/// Interleaved left and right samples.
using PlayedPhrase = std::vector<float>;
double rmsLevel(const PlayedPhrase& phrase);

class RandomSession {
public:
    enum class Changes {
        parameters, ///< by automation, on the audio thread: the player is kept
        all         ///< also sounds, sample rates and resets, offline: no player lasts long
    };
    /// Prepares the processor for playing.
    explicit RandomSession(Processor& played, Changes whatChanges = Changes::all);

    /// Loads a factory program at 48 kHz with a new player; skips scenes.
    void load(int program);

    /// Plays random music of this length; one key may be held all the time. Throws a sentence if a
    /// sample is not finite.
    void play(double seconds, std::uint64_t seed, double notesPerSecond = 12);

    /// Loads a preset, or saves, restores or resets a state.
    void changeSound();

    /// Releases all keys and pedals: mostly by the pending releases alone, sometimes as hosts do
    /// when they stop (all notes off, or a reset). Then plays every key in turn. Throws a sentence
    /// if silence does not follow soon, though only dampers end the sound.
    void settle();

    /// Returns a struck phrase by the current player, after a reset of parameters, controllers and
    /// tuning only.
    PlayedPhrase phrase();
    /// Return the phrase after a reset, and by a new player of the processor's first state.
    PlayedPhrase phraseAfterReset();
    PlayedPhrase phraseAnew();

    /// Returns the depth of the motor's tremolo in a key that rolls for ten seconds, from default
    /// parameters: the power that varies with the discs, divided by all power.
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
    std::vector<std::string> states; ///< saved earlier, to restore later
    std::string reference;
    double rateHz = 48000;
    double loudest = 0; ///< of the last block
    std::int64_t samples = 0;
};

} // namespace idiophone::test
