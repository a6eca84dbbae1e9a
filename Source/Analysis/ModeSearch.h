// Searches recorded strikes for the modes that they share. RecordingFit uses it.
#pragma once

#include "Analysis/JointFit.h"
#include "Analysis/RecordedStrikes.h"
#include "Object/WorkControl.h"

#include <span>
#include <vector>

namespace idiophone {

class ModeSearch {
public:
    /// The arguments must outlive this object.
    ModeSearch(std::span<const RecordedStrike> strikes, const WorkControl& control);

    /// Keeps at most `modeCount` modes, those that explain most. The error is a cancellation.
    Result<void> run(std::size_t modeCount);

    /// Amplitudes are those at the begin of the decay, relative to its peak.
    std::vector<DampedSinusoid> modes;
    std::vector<DampedSinusoid> steady; ///< tones that do not come from the strike
    std::size_t found = 0;              ///< modes before the strongest were selected

private:
    void sort(const JointFit& fit);
    Result<void> separateRoom(const WorkControl& watch);
    JointFit withMore(const JointFit& fit, double share, const WorkControl& watch) const;
    std::vector<DecayPole>
    polesOf(std::span<const DecayRecording> rests, double share, const WorkControl& watch) const;
    std::vector<DecayPole> plausible(const std::vector<DecayPole>& poles) const;
    Eigen::MatrixXd floors(const JointFit& fit, const std::vector<bool>& isSteady) const;
    std::vector<bool> steadyOnes(const JointFit& fit) const;

    std::span<const RecordedStrike> strikes;
    const WorkControl& control;
    std::vector<DecayRecording> recordings;
    double highestHz;
};

} // namespace idiophone
