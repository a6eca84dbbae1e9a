// Computes the residue of each group of modes for a strike on a resonator.
#include "Synth/AllFinite.h"
#include "Synth/Listening.h"
#include "Synth/ModalResonator.h"
#include "Synth/ModeCompression.h"
#include "Synth/PointShapes.h"

#include <algorithm>

namespace idiophone {

/// Computes the residues of all groups in each channel: near, far or a blend. If one of them is
/// absurdly large, sets all to 0 and returns false.
bool ModalResonator::computeResidues(const Contact& contact) noexcept {
    const StrikePoint& struck = contact.strike.point;
    projectShapes(pointShapes(*object, struck), contact.strike.impulseNewtonSeconds,
                  listeningDirection(struck), object->modeCount(), scratch.struckGains.data(),
                  scratch.listeningGains.data());
    if (imperfection > 0)
        for (auto* gains : {&scratch.struckGains, &scratch.listeningGains})
            turnPairs(pairs, std::span(*gains));
    const double farShare = contact.heard.farShare;
    const auto near = static_cast<float>(contact.heard.nearGain);
    const auto far = static_cast<float>(contact.heard.farGain);
    auto& modes = scratch.modeResidues;
    if (farShare < 1) {
        for (std::size_t i = 0; i < object->modeCount(); ++i)
            modes[i] = near * scratch.struckGains[i] * scratch.listeningGains[i];
        for (std::size_t i = 0; i < object->gains.size(); ++i)
            modes[i] *= object->gains[i];
        mergeResidues(scratch.groupResidues[0]);
    }
    if (farShare > 0) {
        findRadiation(struck.radiationDirection);
        if (farShare < 1)
            scratch.nearResidues.copyFrom(scratch.groupResidues[0], bank.paddedSize());
    }
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        ChannelResidues& residues = scratch.groupResidues[c];
        if (farShare > 0) {
            for (std::size_t i = 0; i < object->modeCount(); ++i)
                modes[i] = far * scratch.struckGains[i] * radiationWeights[c][i];
            mergeResidues(residues);
            if (farShare < 1)
                blendNear(static_cast<float>(farShare), residues);
        } else if (c > 0) {
            residues.copyFrom(scratch.groupResidues[0], bank.paddedSize());
        }
    }
    bank.poles().heavy().makeReal(scratch.groupResidues, bank.channels());
    const auto firstGroups = [this](AlignedVector<float>& values) {
        return std::span(values).first(bank.paddedSize());
    };
    bool reasonable = true;
    for (std::size_t c = 0; c < bank.channels(); ++c)
        reasonable = reasonable &&
                     allWithin(firstGroups(scratch.groupResidues[c].re), largestResidue) &&
                     allWithin(firstGroups(scratch.groupResidues[c].im), largestResidue);
    if (!reasonable)
        for (std::size_t c = 0; c < bank.channels(); ++c) {
            std::ranges::fill(firstGroups(scratch.groupResidues[c].re), 0.0f);
            std::ranges::fill(firstGroups(scratch.groupResidues[c].im), 0.0f);
        }
    return reasonable;
}

/// Merges the residues of modes in `scratch` into those of groups.
void ModalResonator::mergeResidues(ChannelResidues& residues) noexcept {
    const std::span<const std::complex<float>> modes(scratch.modeResidues);
    const auto set = [&residues](std::size_t g, std::complex<float> residue) {
        residues.re[g] = residue.real();
        residues.im[g] = residue.imag();
    };
    if (bank.size() == object->modeCount()) {
        for (std::size_t g = 0; g < bank.size(); ++g)
            set(g, modes[g]);
    } else {
        if (lostSharesLaw != law)
            findLost();
        std::span<const float> shares(lostShares);
        for (std::size_t g = 0; g < bank.size(); ++g) {
            const auto first = static_cast<std::size_t>(groupStarts[g]);
            const auto count = static_cast<std::size_t>(groupStarts[g + 1]) - first;
            set(g, count == 1 ? modes[first] : mergedResidue(modes.subspan(first, count), shares));
            shares = shares.subspan(pairsOf(count));
        }
    }
    for (std::size_t g = bank.size(); g < bank.paddedSize(); ++g)
        set(g, 0);
}

/// Blends near into far residues by magnitude and phase, so that no mode cancels between the two.
/// It blends groups, whose sums do not depend on the basis of equal poles.
void ModalResonator::blendNear(float farShare, ChannelResidues& residues) const noexcept {
    for (std::size_t g = 0; g < bank.size(); ++g) {
        const auto between = phasorBetween({scratch.nearResidues.re[g], scratch.nearResidues.im[g]},
                                           {residues.re[g], residues.im[g]}, farShare);
        residues.re[g] = between.real();
        residues.im[g] = between.imag();
    }
}

void ModalResonator::findLost() noexcept {
    lostSharesLaw = law;
    std::span<float> shares(lostShares);
    for (std::size_t g = 0; g < bank.size(); ++g) {
        const auto first = static_cast<std::size_t>(groupStarts[g]);
        const auto count = static_cast<std::size_t>(groupStarts[g + 1]) - first;
        findLostShares(std::span(modeEigenvalues).subspan(first, count), law, shares,
                       dampings.empty()
                           ? std::span<const ModeDamping>()
                           : std::span<const ModeDamping>(dampings).subspan(first, count));
        shares = shares.subspan(pairsOf(count));
    }
}

/// Reads the table if frequency, size, direction or imperfection has changed. A mono output gets
/// the mean of both directions.
void ModalResonator::findRadiation(std::int32_t radiationDirection) noexcept {
    if (radiationRatio == wantedRadiationRatio && radiationHeardFrom == radiationDirection)
        return;
    radiationRatio = wantedRadiationRatio;
    radiationHeardFrom = radiationDirection;
    const RadiationTable& table = object->radiation;
    auto& [first, second] = radiationWeights;
    if (radiationDirection >= 0) {
        table.weightsAt(static_cast<std::size_t>(radiationDirection), radiationRatio, first);
        second = first;
    } else {
        table.weightsAt(0, radiationRatio, first);
        table.weightsAt(std::min<std::size_t>(table.directions.size(), maximumChannels) - 1,
                        radiationRatio, second);
    }
    if (imperfection > 0)
        for (auto* weights : {&first, &second})
            turnPairs(pairs, std::span(*weights));
    if (outputChannels == 1 && radiationDirection < 0)
        std::ranges::transform(
            first, second, first.begin(),
            [](std::complex<float> l, std::complex<float> r) { return (l + r) / 2.0f; });
}

} // namespace idiophone
