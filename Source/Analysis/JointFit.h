// Least-squares fit of one set of damped sinusoids to all free decays at once.
#pragma once

#include "Analysis/DampedSinusoid.h"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// Works in time, over the whole recordings. The products of two truncated exponentials have a
/// closed form, so the cost is that of one product of each recording with each sinusoid.
class JointFit {
public:
    /// The recordings must outlive this object.
    JointFit(std::span<const DecayRecording> recordings, std::vector<DecayPole> poles);

    /// Moves all poles together towards the least residual (Gauss-Newton; the amplitudes follow).
    /// Stops early when the residual no longer falls.
    void refine(int iterations);

    /// Removes the modes that explain the least, until each explains more than its floors, summed
    /// as `BackwardElimination` does, and at most `maximum` are left.
    void eliminate(const Eigen::MatrixXd& floors, std::size_t maximum);

    /// Returns the energy that only this mode explains, of `poles()` by recordings, after
    /// `eliminate`. The samples' squares count 1 each.
    const Eigen::MatrixXd& ownEnergies() const { return energies; }

    /// Ascending in frequency.
    const std::vector<DecayPole>& poles() const { return shared; }

    /// Returns the poles with their best amplitudes at the first sample.
    std::vector<DampedSinusoid> sinusoids() const;

private:
    std::span<const DecayRecording> recordings;
    std::vector<DecayPole> shared;
    Eigen::MatrixXd energies;
};

/// Returns a recording minus sinusoids, of which it is number `index`.
std::vector<double> without(const DecayRecording& recording,
                            std::span<const DampedSinusoid> sinusoids,
                            std::size_t index);

} // namespace idiophone
