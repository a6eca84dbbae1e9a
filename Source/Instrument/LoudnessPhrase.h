// Plays the phrase that PhrasePrediction predicts, to measure the loudness of presets.
#pragma once

#include "Instrument/PhraseMeter.h"
#include "Instrument/Player.h"
#include "Instrument/Preset.h"

#include <vector>

namespace idiophone {

/// Loudness in LUFS (ITU-R BS.1770) of both channels of the phrase at velocity 100, with `level`
/// and room. Factory presets whose keys play objects have it within 1 LU.
inline constexpr double factoryLufs = -26;
/// The loudness of one of two equal channels of the phrase, as PhrasePrediction predicts it.
inline constexpr double factoryChannelLufs = factoryLufs - 3.01;

inline constexpr int loudnessPhraseVelocity = 100;
inline constexpr double loudnessPhraseSeconds = (PhraseMeter::notes + 1) * PhraseMeter::noteSeconds;

/// Returns the notes of PhraseMeter, spread over the keys, in order of time.
std::vector<MidiEvent> loudnessPhrase(const KeyMap& keyMap, int velocity, double sampleRateHz);

/// Two channels of equal length.
struct PlayedPhrase {
    std::vector<float> left, right;
};

/// Returns the player's output, without `level` and room, which the output stage adds. The
/// instrument must be the preset's, without a stage. Not for the audio thread.
PlayedPhrase playLoudnessPhrase(const Preset& preset,
                                const std::shared_ptr<const Instrument>& instrument,
                                double sampleRateHz);

} // namespace idiophone
