// SPDX-License-Identifier: Apache-2.0
#include "Synth/GroupResidues.h"

#include "Synth/AllFinite.h"
#include "Synth/PhasorKernel.h"
#include "Synth/PointShapes.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

namespace {

/// RadiationTable::weightsAt, with SIMD between two ratios.
void readWeights(const RadiationTable& table,
                 std::size_t direction,
                 double ratio,
                 std::span<std::complex<float>> modeWeights) noexcept {
    const auto& ratios = table.frequencyRatios;
    const auto above = std::ranges::lower_bound(ratios, ratio);
    if (above == ratios.begin() || above == ratios.end() || *above == ratio)
        return table.weightsAt(direction, ratio, modeWeights);
    const double below = *(above - 1);
    const auto share = static_cast<float>(std::log(ratio / below) / std::log(*above / below));
    const auto row = direction * ratios.size() + static_cast<std::size_t>(above - ratios.begin());
    const auto* const to = table.weights.data() + row * modeWeights.size();
    phasorsBetween(to - modeWeights.size(), to, share, modeWeights);
}

} // namespace

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
    for (std::size_t c = 0; c < (object.radiation.empty() ? 1 : channels); ++c)
        known[c].resize(bank.paddedSize());
}

double residueRatio(const HeardImpulse& impulse, const HeardImpulse& other) noexcept {
    const Listening &own = impulse.listening, &others = other.listening;
    if (own.farShare != others.farShare || impulse.point != other.point ||
        own.nearGain * others.farGain != own.farGain * others.nearGain)
        return 0;
    double along = 0;
    double square = 0;
    double otherSquare = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto component = static_cast<double>(impulse.newtonSeconds[k]);
        const auto otherComponent = static_cast<double>(other.newtonSeconds[k]);
        along += component * otherComponent;
        square += component * component;
        otherSquare += otherComponent * otherComponent;
    }
    if (!(otherSquare > 0) || along * along < (1 - 1e-12) * square * otherSquare)
        return 0;
    return along / otherSquare * own.nearGain / others.nearGain;
}

bool GroupResidues::compute(const StrikePoint& point,
                            const std::array<float, 3>& newtonSeconds,
                            const Listening& listening) noexcept {
    const HeardImpulse impulse{point, newtonSeconds, listening};
    const double share = isKnown ? residueRatio(impulse, knownImpulse) : 0;
    if (share == 0) {
        computeAnew(impulse);
        knownImpulse = impulse;
    }
    const auto factor = share == 0 ? 1.0f : static_cast<float>(share);
    const auto used = std::span(scratch.groupResidues).first(bank.channels());
    bool areSmall = true;
    for (std::size_t c = 0; c < used.size(); ++c)
        for (const auto part : {&ChannelResidues::re, &ChannelResidues::im}) {
            float* const values = (used[c].*part).data();
            const float* const from = (known[c].*part).data();
            for (std::size_t g = 0; g < bank.paddedSize(); ++g)
                values[g] = factor * from[g];
            areSmall = areSmall && allWithin({values, bank.paddedSize()}, largestResidue);
        }
    isKnown = areSmall;
    if (areSmall)
        return true;
    for (ChannelResidues& residues : used) {
        std::fill_n(residues.re.begin(), bank.paddedSize(), 0.0f);
        std::fill_n(residues.im.begin(), bank.paddedSize(), 0.0f);
    }
    return false;
}

void GroupResidues::computeAnew(const HeardImpulse& impulse) noexcept {
    const auto& [point, newtonSeconds, listening] = impulse;
    const std::size_t modeCount = object.modeCount();
    projectShapes(pointShapes(object, point), newtonSeconds, listeningDirection(point), modeCount,
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
        groups.merge(modes, known[0]);
    }
    if (farShare > 0) {
        findRadiation(point.radiationDirection);
        if (farShare < 1)
            scratch.nearResidues.copyFrom(known[0], bank.paddedSize());
    }
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        ChannelResidues& residues = known[c];
        if (farShare > 0) {
            for (std::size_t i = 0; i < modeCount; ++i)
                modes[i] = far * scratch.struckGains[i] * weights[c][i];
            groups.merge(modes, residues);
            if (farShare < 1)
                blendNear(static_cast<float>(farShare), residues);
        } else if (c > 0) {
            residues.copyFrom(known[0], bank.paddedSize());
        }
    }
    bank.poles().heavy().makeReal(known, bank.channels());
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
        readWeights(table, static_cast<std::size_t>(direction), weightsRatio, first);
        second = first;
    } else {
        readWeights(table, 0, weightsRatio, first);
        readWeights(table, std::min<std::size_t>(table.directions.size(), maximumChannels) - 1,
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
