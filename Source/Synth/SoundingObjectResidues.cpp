// What is heard of each group of modes when a sounding object is struck at a place.
#include "Synth/AllFinite.h"
#include "Synth/Listening.h"
#include "Synth/ModeCompression.h"
#include "Synth/PointShapes.h"
#include "Synth/SoundingObject.h"

#include <algorithm>

namespace idiophone {

/// Residues of all groups in each channel. What is heard is a mean of the velocity at the struck
/// point, along the listening direction there, and of what the whole surface radiates. False, and
/// all of them 0, where one of them is beyond all reason.
bool SoundingObject::computeResidues(const Contact& contact) noexcept {
    const StrikePoint& struck = contact.strike.point;
    projectShapes(pointShapes(*object, struck), contact.strike.impulseNewtonSeconds,
                  listeningDirection(struck), object->modeCount(), scratch.struckGains.data(),
                  scratch.heardGains.data());
    const auto near = static_cast<float>(contact.gainRatio * (1 - contact.listening));
    const auto far = static_cast<float>(weightScale * contact.gainRatio * contact.listening);
    if (far > 0)
        findRadiation(struck.heardFrom);
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        if (far > 0)
            for (std::size_t i = 0; i < object->modeCount(); ++i)
                scratch.modeResidues[i] = scratch.struckGains[i] * (near * scratch.heardGains[i] +
                                                                    far * radiationWeights[c][i]);
        else
            for (std::size_t i = 0; i < object->modeCount(); ++i)
                scratch.modeResidues[i] = near * scratch.struckGains[i] * scratch.heardGains[i];
        mergeResidues(c);
    }
    const auto residuesOf = [this](std::size_t c) {
        return std::span(scratch.groupResidues[c]).first(bank.paddedSize());
    };
    bool reasonable = true;
    for (std::size_t c = 0; c < bank.channels(); ++c)
        reasonable = reasonable && allWithin(residuesOf(c), largestResidue);
    if (!reasonable)
        for (std::size_t c = 0; c < bank.channels(); ++c)
            std::ranges::fill(residuesOf(c), 0.0f);
    return reasonable;
}

void SoundingObject::mergeResidues(std::size_t channel) noexcept {
    auto& residues = scratch.groupResidues[channel];
    const std::span<const float> modes(scratch.modeResidues);
    if (bank.size() == object->modeCount()) {
        std::copy_n(modes.begin(), bank.size(), residues.begin());
    } else {
        if (lostSharesLaw != law)
            findLost();
        std::span<const float> shares(lostShares);
        for (std::size_t g = 0; g < bank.size(); ++g) {
            const auto first = static_cast<std::size_t>(groupStarts[g]);
            const auto count = static_cast<std::size_t>(groupStarts[g + 1]) - first;
            residues[g] =
                count == 1 ? modes[first] : mergedResidue(modes.subspan(first, count), shares);
            shares = shares.subspan(pairsOf(count));
        }
    }
    std::fill(residues.begin() + static_cast<std::ptrdiff_t>(bank.size()),
              residues.begin() + static_cast<std::ptrdiff_t>(bank.paddedSize()), 0.0f);
}

void SoundingObject::findLost() noexcept {
    lostSharesLaw = law;
    std::span<float> shares(lostShares);
    for (std::size_t g = 0; g < bank.size(); ++g) {
        const auto first = static_cast<std::size_t>(groupStarts[g]);
        const auto count = static_cast<std::size_t>(groupStarts[g + 1]) - first;
        findLostShares(std::span(modeEigenvalues).subspan(first, count), law, shares,
                       dampingScales.empty()
                           ? std::span<const double>()
                           : std::span<const double>(dampingScales).subspan(first, count));
        shares = shares.subspan(pairsOf(count));
    }
}

/// Reads the table where frequencies, size or the direction changed. One channel hears the mean of
/// its own directions.
void SoundingObject::findRadiation(std::int32_t heardFrom) noexcept {
    if (radiationRatio == wantedRadiationRatio && radiationHeardFrom == heardFrom)
        return;
    radiationRatio = wantedRadiationRatio;
    radiationHeardFrom = heardFrom;
    const RadiationTable& table = object->radiation;
    auto& [first, second] = radiationWeights;
    if (heardFrom >= 0) {
        table.weightsAt(static_cast<std::size_t>(heardFrom), radiationRatio, first);
        if (outputChannels > 1)
            std::ranges::copy(first, second.begin());
        return;
    }
    table.weightsAt(0, radiationRatio, first);
    table.weightsAt(std::min<std::size_t>(table.directions.size(), mostChannels) - 1,
                    radiationRatio, second);
    if (outputChannels == 1)
        std::ranges::transform(first, second, first.begin(),
                               [](float l, float r) { return (l + r) / 2; });
}

} // namespace idiophone
