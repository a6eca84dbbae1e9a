// Free decays of recorded strikes with what is known of their noise. ModeSearch finds their modes.
#pragma once

#include "Analysis/DampedSinusoid.h"
#include "Analysis/NoiseFloor.h"
#include "Analysis/RecordingFit.h"

#include <span>
#include <string>
#include <vector>

namespace idiophone {

struct RecordedStrike {
    DecayRecording decay; ///< peak 1
    double peak = 0;      ///< of the free decay, relative to full scale
    double contactSeconds = 0;
    std::size_t begin = 0;      ///< first sample of the free decay
    std::vector<double> before; ///< what sounds before the strike, in units of `peak`; may be empty
    NoiseFloor noise;           ///< in units of `peak`

    /// Returns true if the tone does not come from the strike: it sounds before. If nothing is
    /// recorded before, it is steady if it hardly decays and is alone. One of several tones at a
    /// frequency stands for the beats of a mode.
    bool isSteady(const DecayPole& pole, double amplitude, bool isAlone) const;
};

/// Finds the strikes and adds sentences for the user to `remarks`. A noise of −90 dB is added.
/// An error names the recording and the fault.
Result<std::vector<RecordedStrike>> recordedStrikes(std::span<const StrikeRecording> recordings,
                                                    const RecordingFitSettings& settings,
                                                    std::vector<std::string>& remarks);

} // namespace idiophone
