#include "Synth/GroupResidues.h"

#include "Synth/AllFinite.h"
#include "Synth/PointShapes.h"

#include <algorithm>

namespace idiophone {

GroupResidues::GroupResidues(const ModalObject& modalObject,
                             ModeGroups& ownGroups,
                             const ModalBank& ownBank,
                             std::size_t channels,
                             SynthesisScratch& sharedScratch)
    : object(modalObject), groups(ownGroups), bank(ownBank), outputChannels(channels),
      scratch(sharedScratch) {
    if (!object.radiation.empty())
        for (auto& channel : weights)
            channel.resize(object.modeCount());
}

bool GroupResidues::compute(const StrikePoint& point,
                            const std::array<float, 3>& impulse,
                            const Listening& listening) noexcept {
    const std::size_t modeCount = object.modeCount();
    projectShapes(pointShapes(object, point), impulse, listeningDirection(point), modeCount,
                  scratch.struckGains.data(), scratch.listeningGains.data());
    if (groups.conditions().imperfection > 0)
        for (auto* gains : {&scratch.struckGains, &scratch.listeningGains})
            rotatePairs(groups.pairs(), std::span(*gains));
    const double farShare = listening.farShare;
    const auto near = static_cast<float>(listening.nearGain);
    const auto far = static_cast<float>(listening.farGain);
    const auto modes = std::span(scratch.modeResidues).first(modeCount);
    if (farShare < 1) {
        for (std::size_t i = 0; i < modeCount; ++i)
            modes[i] = near * scratch.struckGains[i] * scratch.listeningGains[i];
        for (std::size_t i = 0; i < object.gains.size(); ++i)
            modes[i] *= object.gains[i];
        groups.merge(modes, scratch.groupResidues[0]);
    }
    if (farShare > 0) {
        findRadiation(point.radiationDirection);
        if (farShare < 1)
            scratch.nearResidues.copyFrom(scratch.groupResidues[0], bank.paddedSize());
    }
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        ChannelResidues& residues = scratch.groupResidues[c];
        if (farShare > 0) {
            for (std::size_t i = 0; i < modeCount; ++i)
                modes[i] = far * scratch.struckGains[i] * weights[c][i];
            groups.merge(modes, residues);
            if (farShare < 1)
                blendNear(static_cast<float>(farShare), residues);
        } else if (c > 0) {
            residues.copyFrom(scratch.groupResidues[0], bank.paddedSize());
        }
    }
    bank.poles().heavy().makeReal(scratch.groupResidues, bank.channels());
    const auto used = std::span(scratch.groupResidues).first(bank.channels());
    const auto areSmall = [this](const AlignedVector<float>& values) {
        return allWithin(std::span(values).first(bank.paddedSize()), largestResidue);
    };
    if (std::ranges::all_of(used, areSmall, &ChannelResidues::re) &&
        std::ranges::all_of(used, areSmall, &ChannelResidues::im))
        return true;
    for (ChannelResidues& residues : used) {
        std::fill_n(residues.re.begin(), bank.paddedSize(), 0.0f);
        std::fill_n(residues.im.begin(), bank.paddedSize(), 0.0f);
    }
    return false;
}

/// Blends near into far residues by magnitude and phase, so that no mode cancels between the two.
/// It blends groups, whose sums do not depend on the basis of equal poles.
void GroupResidues::blendNear(float farShare, ChannelResidues& residues) const noexcept {
    for (std::size_t g = 0; g < bank.size(); ++g) {
        const auto between = phasorBetween({scratch.nearResidues.re[g], scratch.nearResidues.im[g]},
                                           {residues.re[g], residues.im[g]}, farShare);
        residues.re[g] = between.real();
        residues.im[g] = between.imag();
    }
}

/// Reads the table if frequency, size, direction or imperfection has changed. A mono output gets
/// the mean of both directions.
void GroupResidues::findRadiation(std::int32_t direction) noexcept {
    const bool ofPairs = groups.conditions().imperfection > 0;
    if (weightsRatio == wantedRatio && weightsDirection == direction && weightsOfPairs == ofPairs)
        return;
    weightsRatio = wantedRatio;
    weightsDirection = direction;
    weightsOfPairs = ofPairs;
    const RadiationTable& table = object.radiation;
    auto& [first, second] = weights;
    if (direction >= 0) {
        table.weightsAt(static_cast<std::size_t>(direction), weightsRatio, first);
        second = first;
    } else {
        table.weightsAt(0, weightsRatio, first);
        table.weightsAt(std::min<std::size_t>(table.directions.size(), maximumChannels) - 1,
                        weightsRatio, second);
    }
    if (ofPairs)
        for (auto* channel : {&first, &second})
            rotatePairs(groups.pairs(), std::span(*channel));
    if (outputChannels == 1 && direction < 0)
        std::ranges::transform(
            first, second, first.begin(),
            [](std::complex<float> l, std::complex<float> r) { return (l + r) / 2.0f; });
}

} // namespace idiophone
