// SPDX-License-Identifier: Apache-2.0
#include "Synth/ActiveModes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace idiophone {

namespace {

constexpr float faintEnergy = 1e-36f; // faintestVelocity²

/// This level is far below hearing and far above the rounding error of sums of shares.
constexpr float smallestFade = 1e-6f;

} // namespace

ActiveModes::ActiveModes(ModalBank& ownBank, BankOutput& ownOutput, SynthesisScratch& sharedScratch)
    : bank(ownBank), output(ownOutput), scratch(sharedScratch), activeBlocks(ownBank, ownOutput),
      flags(ownBank) {}

// The amplitude decays as e^{−αt} and reaches τ at t_c. A comparison at every grid point finds t_c
// without a logarithm per struck mode.
void ActiveModes::survey(Change allowed) noexcept {
    const EnergySurvey found =
        surveyEnergies(bank.energies(), bank.poles().audibleWeights(), tauEnergy(), faintEnergy,
                       activeBlocks.list(), scratch.aboveTau.data());
    std::int32_t ringing = found.modes;
    for (const std::int32_t number : activeBlocks.list()) {
        const unsigned before = flags[index(number)].rings;
        const std::uint16_t above = scratch.aboveTau[index(number)];
        if (before == above)
            continue;
        const unsigned kept = allowed == Change::joinOnly ? before : 0u;
        const unsigned rings = allowed == Change::none ? before : above | kept;
        ringing += std::popcount(rings) - std::popcount(above);
        if (rings != before)
            chosenFor = noChoice;
        flags[index(number)].rings = static_cast<std::uint16_t>(rings);
    }
    if (found.faint)
        for (const std::int32_t b : activeBlocks.list())
            bank.clearFaint(index(b));
    demanded = {found.amplitudes, ringing + restingModes};
}

void ActiveModes::choose(std::int32_t allowance, std::int64_t grid) noexcept {
    if (restingModes > 0 && allowance > 0 && chosenFor != allowance)
        wakeContenders(allowance, grid);
    const bool all = allowance >= demanded.modes;
    const std::int32_t choice = all ? allModes : allowance;
    if (std::exchange(chosenFor, choice) == choice)
        return;
    if (all)
        for (const std::int32_t b : activeBlocks.list())
            scratch.wanted[index(b)] = flags[index(b)].rings;
    else
        selectStrongest(static_cast<std::size_t>(std::max(allowance, 0)));
    scratch.leaving.clear();
    scratch.joining.clear();
    for (const std::int32_t number : activeBlocks.list()) {
        const std::size_t b = index(number);
        const unsigned before = flags[b].mixed;
        const unsigned now = scratch.wanted[b];
        appendModes(b, before & ~now, scratch.leaving);
        appendModes(b, now & ~before, scratch.joining);
        flags[b].mixed = scratch.wanted[b];
    }
    output.fade(scratch.leaving, 1);
    output.fade(scratch.joining, -1);
    if (!scratch.leaving.empty() || !scratch.joining.empty())
        flags.list(activeBlocks.list());
    retireBlocks(true, grid);
}

/// Activates the resting blocks that may hold a mode that belongs to the strongest ones.
void ActiveModes::wakeContenders(std::int32_t allowance, std::int64_t grid) noexcept {
    float weakest = flags.mixedCount() < allowance ? 0 : largestEnergy;
    for (const std::int32_t mode : flags.mixed())
        weakest = std::min(weakest, bank.energies()[mode]);
    activeBlocks.wake(std::max(weakest, tauEnergy()), grid);
    countResting(tauEnergy());
    survey(Change::any);
}

/// Counts the ringing modes of resting blocks that are not below the threshold altogether.
void ActiveModes::countResting(float threshold) noexcept {
    restingModes = 0;
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        if (flags[b].rings == 0 || activeBlocks.contains(b))
            continue;
        if (!(bank.energyOfLoudest(b) > threshold))
            flags[b].rings = 0;
        restingModes += std::popcount(flags[b].rings);
    }
}

void ActiveModes::selectStrongest(std::size_t maximum) noexcept {
    scratch.candidates.clear();
    for (const std::int32_t number : activeBlocks.list()) {
        scratch.wanted[index(number)] = 0;
        appendModes(index(number), flags[index(number)].rings, scratch.candidates);
    }
    keepLoudest(scratch.candidates, bank.energies(), maximum);
    for (const std::int32_t g : scratch.candidates)
        scratch.wanted[index(g) / modeBlock] |= bitOf(index(g));
}

/// Lets blocks rest in which nothing is mixed, or even ringing ones.
void ActiveModes::retireBlocks(bool evenRinging, std::int64_t grid) noexcept {
    const auto isDone = [&](std::size_t b) {
        return (flags[b].mixed | (evenRinging ? 0 : flags[b].rings)) == 0;
    };
    activeBlocks.retire(isDone, grid);
    if (evenRinging)
        countResting(tauEnergy());
}

void ActiveModes::wake(std::int64_t grid) noexcept {
    if (activeBlocks.wake(tauEnergy(), grid))
        chosenFor = noChoice;
    if (restingModes > 0)
        countResting(tauEnergy());
}

std::span<const ModeRun> ActiveModes::join(const Candidates& candidates,
                                           std::int32_t allowance,
                                           bool duringContact,
                                           std::int64_t grid) noexcept {
    if (allMixed())
        return {};
    surveyAll(candidates.energies, candidates.threshold);
    scratch.joining.clear();
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        const unsigned barred = flags[b].mixed | (duringContact ? flags[b].rings : 0u);
        appendModes(b, scratch.aboveTau[b] & ~barred, scratch.joining);
    }
    keepLoudest(scratch.joining, candidates.loudness,
                static_cast<std::size_t>(std::max(allowance - flags.mixedCount(), 0)));
    std::ranges::sort(scratch.joining);
    if (scratch.joining.empty())
        return {};
    if (restingModes > 0)
        wake(grid);
    scratch.leaving.clear();
    for (const std::int32_t mode : scratch.joining)
        admit(index(mode), grid);
    // Modes that the budget had left out fade in from the next grid point on.
    output.fade(scratch.leaving, -1);
    findRuns(scratch.joining, scratch.joiningRuns);
    flags.list(activeBlocks.list());
    chosenFor = noChoice;
    return scratch.joiningRuns;
}

/// Mixes a struck mode. Earlier motion that τ had cut stays cut.
void ActiveModes::admit(std::size_t g, std::int64_t grid) noexcept {
    const std::size_t b = g / modeBlock;
    if (!activeBlocks.contains(b)) {
        activeBlocks.bringUpToDate(b, grid);
        activeBlocks.activate(b);
    }
    if (flags.rings(g))
        scratch.leaving.push_back(static_cast<std::int32_t>(g));
    else
        bank.silence(g);
    flags[b].rings |= bitOf(g);
    flags[b].mixed |= bitOf(g);
}

/// Finds the audible modes of all blocks with energies above the threshold.
EnergySurvey ActiveModes::surveyAll(const float* energies, float threshold) noexcept {
    return surveyEnergies(energies, bank.poles().audibleWeights(), threshold, 0, bank.allBlocks(),
                          scratch.aboveTau.data());
}

void ActiveModes::listRinging() noexcept {
    surveyAll(bank.energies(), tauEnergy());
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        flags[b].rings = scratch.aboveTau[b] | flags[b].mixed;
        if (flags[b].rings != 0)
            activeBlocks.activate(b);
    }
    chosenFor = noChoice;
    restingModes = 0;
}

void ActiveModes::listResting() noexcept {
    const EnergySurvey found = surveyAll(bank.energies(), tauEnergy());
    for (std::size_t b = 0; b < bank.blockCount(); ++b)
        flags[b].rings = scratch.aboveTau[b];
    chosenFor = noChoice;
    restingModes = found.modes;
    demanded = {found.amplitudes, found.modes};
}

void ActiveModes::fadeInaudible(const ModeGroups& groups, std::int64_t grid) noexcept {
    scratch.leaving.clear();
    for (const std::int32_t mode : flags.mixed()) {
        const std::size_t g = index(mode);
        if (groups.audible(g))
            continue;
        scratch.leaving.push_back(mode);
        ModeFlags::Block& block = flags[g / modeBlock];
        block.mixed = static_cast<std::uint16_t>(block.mixed & ~bitOf(g));
        block.rings = static_cast<std::uint16_t>(block.rings & ~bitOf(g));
    }
    if (scratch.leaving.empty())
        return;
    output.fade(scratch.leaving, 1);
    chosenFor = noChoice;
    flags.list(activeBlocks.list());
    retireBlocks(false, grid);
}

void ActiveModes::regroup(const ModeGroups& groups, std::int64_t grid) noexcept {
    flags.handOn(groups, scratch); // the fades need the old flags
    fadeChanges(groups.shares());
    bank.regroup(groups.size(), groups.shares(), scratch.states);
    output.findTubeParts(groups.starts());
    activeBlocks.restAll(grid);
    for (std::size_t b = 0; b < flags.blockCount(); ++b) {
        flags[b] = {.rings = scratch.aboveTau[b], .mixed = scratch.wanted[b]};
        if ((flags[b].rings | flags[b].mixed) != 0)
            activeBlocks.activate(b);
    }
    chosenFor = noChoice;
    restingModes = 0;
    flags.list(activeBlocks.list());
}

/// Fades the changes, still with the old poles. Unmixed modes that join a mixed group fade in, and
/// modes that become inaudible fade out.
void ActiveModes::fadeChanges(std::span<const ModeShare> shares) noexcept {
    auto& fading = scratch.fadingShares;
    for (std::size_t g = 0; g < bank.size(); ++g)
        fading[g] = flags.isMixed(g) ? 1.0f : 0.0f;
    for (const ModeShare& taken : shares)
        if (isSet(scratch.wanted[index(taken.to) / modeBlock], index(taken.to)))
            fading[index(taken.from)] -= static_cast<float>(taken.share);
    scratch.leaving.clear();
    for (std::size_t g = 0; g < bank.size(); ++g)
        if (std::abs(fading[g]) > smallestFade && bank.energies()[g] > 0) {
            fading[scratch.leaving.size()] = fading[g];
            scratch.leaving.push_back(static_cast<std::int32_t>(g));
        }
    output.fade(scratch.leaving, std::span(fading).first(scratch.leaving.size()));
}

void ActiveModes::reset() noexcept {
    flags.clear();
    activeBlocks.retire([](std::size_t) { return true; }, 0);
    chosenFor = allModes;
    restingModes = 0;
    demanded = {};
}

} // namespace idiophone
