// The phrase by which the loudness of presets is judged: what PhrasePrediction predicts, played.
#pragma once

#include "Instrument/PhraseMeter.h"
#include "Instrument/Player.h"
#include "Instrument/Preset.h"

#include <vector>

namespace idiophone {

/// LUFS (ITU-R BS.1770) of both channels of the phrase at velocity 100, with `level` and room. The
/// factory presets whose keys play objects have it within 1 LU.
inline constexpr double factoryLufs = -26;
/// The same of one of two equal channels, as PhrasePrediction predicts it.
inline constexpr double factoryChannelLufs = factoryLufs - 3.01;

inline constexpr int loudnessPhraseVelocity = 100;
inline constexpr double loudnessPhraseSeconds = (PhraseMeter::notes + 1) * PhraseMeter::noteSeconds;

/// The notes of PhraseMeter, spread over the keys. In order of time.
std::vector<MidiEvent> loudnessPhrase(const KeyMap& keyMap, int velocity, double sampleRateHz);

/// Both channels of one length.
struct PlayedPhrase {
    std::vector<float> left, right;
};

/// As the player has it: without `level` and room, which are the output stage's. The instrument is
/// the preset's and no stage. Not for the audio thread.
PlayedPhrase playLoudnessPhrase(const Preset& preset,
                                const std::shared_ptr<const Instrument>& instrument,
                                double sampleRateHz);

} // namespace idiophone
