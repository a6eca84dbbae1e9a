// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModeGroups.h"

#include "Synth/ModeCompression.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace idiophone {

namespace {

double sum(std::span<const double> weights) noexcept {
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

} // namespace

ModeGroups::ModeGroups(const ModalObject& modalObject,
                       ModeWeights weights,
                       std::uint32_t seed,
                       double sampleRateHz,
                       SynthesisScratch& sharedScratch)
    : object(modalObject), scratch(sharedScratch), rateHz(sampleRateHz),
      modeWeights(std::move(weights)), count(object.modeCount()), groupStarts(count + 1),
      modeEigenvalues(object.eigenvalues), groupEigenvalues(object.eigenvalues),
      modePairs(idiophone::modePairs(object, seed)), modeDampings(object.dampings()),
      groupDampings(modeDampings),
      lostShares(count * (maximumGroup - 1) / 2) { // for groups of the maximum size
    std::iota(groupStarts.begin(), groupStarts.end(), 0);
    mergedGroups.reserve(count / 2);
    requestedSilences.reserve(count);
    silencedModes.reserve(count);
}

bool ModeGroups::requestSilenced(std::span<const std::uint8_t> silenced) noexcept {
    const bool any = std::ranges::any_of(silenced, [](std::uint8_t is) { return is != 0; });
    if (any && silenced.size() != object.modeCount())
        return false;
    const auto wanted = any ? silenced : std::span<const std::uint8_t>();
    if (std::ranges::equal(wanted, requestedSilences))
        return false;
    requestedSilences.assign(wanted.begin(), wanted.end());
    silencesChange = true;
    return true;
}

void ModeGroups::set(const GroupConditions& wanted) noexcept {
    const bool differs = differFrom(wanted);
    behind = behind || differs;
    outdated = outdated || differs;
    mixesKinds = mixesKinds || silencesChange;
    eigenvaluesAreBehind = eigenvaluesAreBehind ||
                           wanted.thicknessRatio != current.thicknessRatio ||
                           wanted.imperfection != current.imperfection;
    current = wanted;
    if (std::exchange(silencesChange, false))
        silencedModes.assign(requestedSilences.begin(), requestedSilences.end());
}

bool ModeGroups::follow() noexcept {
    behind = outdated = mixesKinds = false;
    groupedLaw = current.law;
    if (eigenvaluesAreBehind)
        moveModes();
    const std::size_t groups =
        groupModes(modeEigenvalues, current.law, current.compression, scratch.groupStarts,
                   modeDampings, silencedModes, object.gains);
    const bool same =
        groups == count &&
        std::ranges::equal(starts().first(groups), std::span(scratch.groupStarts).first(groups));
    if (!same) {
        findShares(groups);
        count = groups;
        std::copy_n(scratch.groupStarts.begin(), groups + 1, groupStarts.begin());
    }
    if (std::exchange(eigenvaluesAreBehind, false) || !same)
        computeValues();
    return !same;
}

void ModeGroups::keep() noexcept {
    behind = false;
    if (!std::exchange(eigenvaluesAreBehind, false))
        return;
    moveModes();
    computeValues();
}

void ModeGroups::moveModes() noexcept {
    for (std::size_t mode = 0; mode < modeEigenvalues.size(); ++mode)
        modeEigenvalues[mode] = object.eigenvalueAt(mode, current.thicknessRatio);
    splitPairs(modePairs, current.imperfection, modeEigenvalues);
}

/// Divides a group's state among its modes by their mean-square shapes, as if the object had been
/// struck everywhere. The struck points are not stored.
void ModeGroups::findShares(std::size_t groups) noexcept {
    scratch.groupShares.clear();
    const std::span<const double> weights(*modeWeights);
    const auto& newStarts = scratch.groupStarts;
    for (std::size_t from = 0, to = 0; from < count && to < groups;) {
        const std::size_t start = index(groupStarts[from]), end = index(groupStarts[from + 1]);
        const std::size_t newEnd = index(newStarts[to + 1]);
        const std::size_t first = std::max(start, index(newStarts[to]));
        const std::size_t modes = std::min(end, newEnd) - first;
        const double total = sum(weights.subspan(start, end - start));
        const double share = total > 0 ? sum(weights.subspan(first, modes)) / total
                                       : static_cast<double>(modes) / double(end - start);
        scratch.groupShares.push_back(
            {static_cast<std::int32_t>(from), static_cast<std::int32_t>(to), share});
        from += end <= newEnd ? 1 : 0;
        to += newEnd <= end ? 1 : 0;
    }
}

/// Computes the values of each group from its modes.
void ModeGroups::computeValues() noexcept {
    lostSharesLaw.reset();
    mergedGroups.clear();
    for (std::size_t g = 0; g < count; ++g) {
        if (groupStarts[g + 1] - groupStarts[g] > 1)
            mergedGroups.push_back(static_cast<std::int32_t>(g));
        const auto weights = ofGroup<double>(g, *modeWeights);
        groupEigenvalues[g] = mergedEigenvalue(ofGroup<double>(g, modeEigenvalues), weights);
        if (!modeDampings.empty())
            groupDampings[g] = mergedDamping(ofGroup<ModeDamping>(g, modeDampings), weights);
    }
}

std::span<const std::uint8_t> ModeGroups::silences() const noexcept {
    if (silencedModes.empty())
        return {};
    const auto groups = std::span(scratch.silencedGroups).first(count);
    for (std::size_t g = 0; g < count; ++g)
        groups[g] = silenced(g) ? 1 : 0;
    return groups;
}

void ModeGroups::merge(std::span<const std::complex<float>> modes,
                       ChannelResidues& residues) noexcept {
    float* const re = residues.re.data();
    float* const im = residues.im.data();
    for (std::size_t g = 0; g < count; ++g) {
        const std::complex<float> first = modes[index(groupStarts[g])];
        re[g] = first.real();
        im[g] = first.imag();
    }
    if (lostSharesLaw != groupedLaw && !mergedGroups.empty())
        findLostShares();
    std::span<const float> shares(lostShares);
    for (const std::int32_t g : mergedGroups) {
        const auto members = ofGroup(index(g), modes);
        const std::complex<float> residue = mergedResidue(members, shares);
        re[g] = residue.real();
        im[g] = residue.imag();
        shares = shares.subspan(pairsOf(members.size()));
    }
    for (std::size_t g = count; g % modeBlock != 0; ++g)
        re[g] = im[g] = 0;
}

void ModeGroups::findLostShares() noexcept {
    lostSharesLaw = groupedLaw;
    std::span<float> shares(lostShares);
    for (const std::int32_t g : mergedGroups) {
        const auto eigenvaluesOfModes = ofGroup<double>(index(g), modeEigenvalues);
        idiophone::findLostShares(eigenvaluesOfModes, groupedLaw, shares,
                                  ofGroup<ModeDamping>(index(g), modeDampings));
        shares = shares.subspan(pairsOf(eigenvaluesOfModes.size()));
    }
}

} // namespace idiophone
