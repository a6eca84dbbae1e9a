// Follows the host's transport: the tempo and the song position.
#pragma once

#include <juce_audio_basics/juce_audio_basics.h>
#include <optional>

namespace idiophone {

/// For the audio thread; neither allocates, locks nor throws. If the host reports nothing for a
/// block, the last report stays valid: LV2 hosts report only changes.
class HostTransport {
public:
    /// Call once per callback, with its number of samples; `host` is nullptr if there is no play
    /// head. A block without samples is ignored. A position reported twice in a row counts as none,
    /// because some hosts report whole beats.
    void follow(const juce::AudioPlayHead* host, int blockSamples, double sampleRateHz) noexcept;

    /// Forgets the position but keeps the tempo; the next song position counts as a start.
    void forgetPlace() noexcept { placeNow = reported = lastPlace = std::nullopt; }
    void forget() noexcept { *this = {}; }

    /// Returns beats per minute, or 0 if the host reports no valid tempo.
    double tempo() const noexcept { return beatsPerMinute; }
    /// Returns the song position of the callback's first sample in beats, if the song plays and the
    /// host reports position and tempo.
    std::optional<double> songPlace() const noexcept { return placeNow; }
    /// Returns whether the song starts or jumps back in this callback. A jump forward is no start:
    /// many hosts skip callbacks while a plugin is silent.
    bool begins() const noexcept { return beginsNow; }

private:
    double extrapolated(double inBeatsPerMinute) const noexcept;

    double beatsPerMinute = 0;
    std::optional<double> placeNow;
    std::optional<double> reported;  ///< position reported for the last callback
    std::optional<double> lastPlace; ///< position of the last callback while the song plays,
                                     ///< extrapolated if not reported
    double secondsSince = 0;         ///< length of the last callback
    bool beginsNow = false;
};

} // namespace idiophone
