// SPDX-License-Identifier: Apache-2.0
// Computes the residue of each group of modes for a strike at a point: near, far or a blend.
#pragma once

#include "Synth/Listening.h"
#include "Synth/ModalBank.h"
#include "Synth/ModeGroups.h"
#include "Synth/Strike.h"

#include <array>
#include <complex>
#include <vector>

namespace idiophone {

/// An impulse at a point, as it is heard.
struct HeardImpulse {
    StrikePoint point;
    std::array<float, 3> newtonSeconds{};
    Listening listening;
};

/// Returns the ratio of the residues to the other ones, or 0 if it differs from mode to mode.
double residueRatio(const HeardImpulse& impulse, const HeardImpulse& other) noexcept;

/// Memory is reserved by the constructor; every other member is for the audio thread.
class GroupResidues {
public:
    /// The arguments must outlive this object. The bank has the modes of `groups`.
    GroupResidues(const ModalObject& object,
                  ModeGroups& groups,
                  const ModalBank& bank,
                  std::size_t outputChannels,
                  SynthesisScratch& scratch);

    /// Computes the scratch's `groupResidues` in each channel of the bank for a valid point. If one
    /// of them is absurdly large, sets all to 0 and returns false. Residues in proportion to those
    /// computed last are taken from these: a strike acts several times at one point.
    bool compute(const StrikePoint& point,
                 const std::array<float, 3>& impulseNewtonSeconds,
                 const Listening& listening) noexcept;
    /// Call it when poles, groups or channels change.
    void invalidate() noexcept { isKnown = false; }

    /// The radiation table's argument: frequency times size, relative to the reference.
    double radiationRatio() const noexcept { return wantedRatio; }
    void setRadiationRatio(double ratio) noexcept {
        isKnown = isKnown && ratio == wantedRatio;
        wantedRatio = ratio;
    }

private:
    void computeAnew(const HeardImpulse& impulse) noexcept;
    void blendNear(float farShare, ChannelResidues& residues) const noexcept;
    void findRadiation(std::int32_t direction) noexcept;

    const ModalObject& object;
    ModeGroups& groups;
    const ModalBank& bank;
    std::size_t outputChannels;
    SynthesisScratch& scratch;
    double wantedRatio = 1;
    ModeResidues known; ///< [G] computed last
    HeardImpulse knownImpulse;
    bool isKnown = false;
    // The weights as last read from the radiation table.
    std::array<std::vector<std::complex<float>>, maximumChannels> weights; ///< [M]
    double weightsRatio = 0;
    std::int32_t weightsDirection = -1; ///< StrikePoint::radiationDirection
    bool weightsOfPairs = false;        ///< with rotated pairs
};

} // namespace idiophone
