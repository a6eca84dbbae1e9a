// A host that plays a processor at random: notes, controllers, automation, presets, states, blocks
// of any size. The same seed does the same.
#pragma once

#include "Plugin/Processor.h"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace idiophone::test {

class RandomSession {
public:
    enum class Changes {
        parameters, ///< by automation, on the thread that plays
        all         ///< and sounds, sample rates and resets, offline
    };
    /// Prepares the processor to play.
    explicit RandomSession(Processor& played, Changes whatChanges = Changes::all);

    /// Plays so many seconds of music; throws a sentence on a sample that is not finite.
    void play(double seconds, std::uint64_t seed);

    /// Loads a preset, or keeps, restores or resets a state.
    void changeSound();

    /// Releases everything, and throws a sentence where it is not silent within `longestSeconds`.
    void settle(double longestSeconds = 60);

    /// Root mean square of a reference phrase, played in the state that the processor had at first.
    double referenceLevel();

    std::int64_t notesPlayed() const { return notes; }
    std::int64_t samplesPlayed() const { return samples; }

private:
    int below(int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); }
    double share() { return static_cast<double>(random()) / 4294967296.0; }
    void addMusic(juce::MidiBuffer& midi, int length);
    void moveParameter();
    void changeHost();
    void render(juce::MidiBuffer& midi, int length);

    Processor& processor;
    Changes changes;
    std::mt19937 random;
    juce::AudioBuffer<float> buffer;
    std::vector<std::string> states; ///< kept on the way, to come back to
    std::string reference;
    double rateHz = 48000;
    double loudest = 0;      ///< of what was rendered last
    double sumOfSquares = 0; ///< likewise
    std::int64_t notes = 0, samples = 0;
};

} // namespace idiophone::test
