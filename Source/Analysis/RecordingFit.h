// Recordings of strikes to the modes that they share: frequencies, decays and a gain of each mode
// in each recording (van den Doel, Kry & Pai 2001, section 4). What the recordings are of, and
// where it was struck, is MeasuredObject's.
#pragma once

#include "Object/Result.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

struct StrikeRecording {
    std::string name; ///< stands for it in errors
    std::span<const float> samples;
    double sampleRateHz = 0;
};

struct RecordingFitSettings {
    std::size_t modeCount = 50; ///< at most; those of the greatest energy are kept
    double contactSeconds = 0;  ///< how long the striker touched; 0: unknown
    double longestSeconds = 8;  ///< of each recording, from the strike on
};

struct MeasuredMode {
    double frequencyHz = 0;    ///< damped, as it sounds
    double decayPerSecond = 0; ///< α of e^{−αt}
    /// [R] of full scale, in the middle of the contact; where its length is unknown at its onset.
    std::vector<double> amplitudes;
};

struct RecordingFit {
    std::vector<MeasuredMode> modes;   ///< ascending in frequency
    std::size_t modesFound = 0;        ///< before the strongest were chosen
    std::vector<std::string> remarks;  ///< sentences for people: clipping, several strikes
    std::vector<double> noiseDecibels; ///< [R] what the modes found leave, against the free decay
};

/// Fits at least one recording, of any sample rates. Bands of frequency from narrow to wide are
/// searched for the poles that the recordings share (BandPoles), slow decays before fast; all found
/// so far are fitted together and taken out before the next (PoleRefinement).
///
/// A contact's pulse shapes what it excites: where its length is given, amplitudes are divided by
/// the spectrum of a raised cosine of that length, as far as that lies within 20 dB of its start.
///
/// The error names the recording and what it lacks.
Result<RecordingFit> fitRecordings(std::span<const StrikeRecording> recordings,
                                   const RecordingFitSettings& settings = {});

} // namespace idiophone
