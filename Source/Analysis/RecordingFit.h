// Finds the modes shared by recordings of strikes: frequencies, decays and a gain of each mode in
// each recording (van den Doel, Kry & Pai 2001, section 4). MeasuredObject knows the object and the
// struck places.
#pragma once

#include "Analysis/RecordingRest.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

struct StrikeRecording {
    std::string name; ///< used in errors
    std::span<const float> samples;
    double sampleRateHz = 0;
};

struct RecordingFitSettings {
    std::size_t modeCount = 200; ///< maximum; the modes that explain most are kept
    double contactSeconds = 0;   ///< length of the mallet's contact; 0: unknown
    double longestSeconds = 8;   ///< used length of each recording, from the strike
};

struct MeasuredMode {
    double frequencyHz = 0;    ///< damped, as it sounds
    double decayPerSecond = 0; ///< α of e^{−αt}
    /// [R] relative to full scale, at the middle of the contact, or at its onset if its length is
    /// unknown.
    std::vector<double> amplitudes;
    /// [R] a of Re(a e^{(−α + 2πif)t}), relative to full scale, from the begin of the free decay
    /// on.
    std::vector<std::complex<double>> waves = {};

    /// Returns λ = ω² of the mode without damping, in rad²/s².
    double eigenvalue() const {
        const double omega = 2 * std::numbers::pi * frequencyHz;
        return omega * omega + decayPerSecond * decayPerSecond;
    }
};

struct RecordingFit {
    std::vector<MeasuredMode> modes;   ///< ascending in frequency
    std::size_t modesFound = 0;        ///< before the strongest were selected
    std::vector<std::string> remarks;  ///< sentences for the user: clipping, several strikes
    std::vector<double> noiseDecibels; ///< [R] energy of the residual, relative to the free decay
    std::vector<RecordingRest> rests = {};     ///< [R] what the modes leave
    std::vector<std::size_t> decayBegins = {}; ///< [R] first sample of the free decay
};

/// Fits one or more recordings of any sample rates. It searches narrow bands, then in what is left
/// wide ones, for shared poles, and fits all together. Poles that are not needed beside the others,
/// below the noise floor, or far below their neighbours are dropped, as are those that a room
/// explains. Tones that do not decay, such as hum, are fitted but are no modes.
///
/// A contact's pulse filters the modes. If its length is given, amplitudes are divided by the
/// spectrum of a raised cosine of that length, limited to 20 dB of correction.
///
/// An error names the recording and the fault, or is a cancellation.
Result<RecordingFit> fitRecordings(std::span<const StrikeRecording> recordings,
                                   const RecordingFitSettings& settings = {},
                                   const WorkControl& control = {});

/// Returns what the modes alone say in a recording, at its level: silence until the free decay
/// begins, then all modes.
std::vector<float>
resynthesised(const RecordingFit& fit, std::size_t recording, const StrikeRecording& original);

} // namespace idiophone
