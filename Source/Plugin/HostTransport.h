// What the host's transport says: the tempo, and where in the song it plays.
#pragma once

#include <juce_audio_basics/juce_audio_basics.h>
#include <optional>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. A host that says nothing of a block
/// means that all goes on as it told last: those of LV2 speak when something changes.
class HostTransport {
public:
    /// Once a callback, with its samples; nullptr where there is no host that tells. One without
    /// samples says nothing, and a place told twice in a row is none: some hosts tell whole beats.
    void follow(const juce::AudioPlayHead* host, int blockSamples, double sampleRateHz) noexcept;

    /// As before the first callback, but for the tempo: where a song plays on it begins anew.
    void forgetPlace() noexcept { placeNow = told = reckoned = std::nullopt; }
    void forget() noexcept { *this = {}; }

    /// Beats a minute; 0 where the host tells none, or none that is one.
    double tempo() const noexcept { return beatsPerMinute; }
    /// Where the callback's first sample is in the song, in beats, while it plays and the host
    /// tells of both.
    std::optional<double> songPlace() const noexcept { return placeNow; }
    /// The song begins to play in this callback, or goes back. Where it is farther on than it
    /// could be the host has left callbacks out, as many do while a plugin is silent.
    bool begins() const noexcept { return beginsNow; }

private:
    double goneOn(double inBeatsPerMinute) const noexcept;

    double beatsPerMinute = 0;
    std::optional<double> placeNow;
    std::optional<double> told;     ///< what the host said of the last callback
    std::optional<double> reckoned; ///< where it began, while the song plays
    double secondsSince = 0;        ///< then
    bool beginsNow = false;
};

} // namespace idiophone
