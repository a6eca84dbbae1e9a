#include "Synth/ActiveModes.h"

#include "Synth/ModeIndex.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

namespace {

constexpr float faintEnergy = 1e-36f; // faintestVelocity²

/// This level is far below hearing and far above the rounding error of sums of shares.
constexpr float smallestFade = 1e-6f;

} // namespace

ActiveModes::ActiveModes(ModalBank& ownBank, BankOutput& ownOutput, SynthesisScratch& sharedScratch)
    : bank(ownBank), output(ownOutput), scratch(sharedScratch), states(ownBank.blockCount()) {
    activeBlocks.reserve(states.size());
    mixed.reserve(bank.size());
    runs.reserve(bank.size());
}

float ActiveModes::amplitude(std::size_t g, std::int64_t grid) const noexcept {
    const double held = std::sqrt(static_cast<double>(bank.energies()[g]));
    const Block& block = states[g / modeBlock];
    if (block.active || held == 0)
        return static_cast<float>(held);
    const double seconds = output.cellSeconds() * static_cast<double>(grid - block.restsSince);
    return static_cast<float>(held * std::exp(block.restsAtDampingLog - output.dampingLog(grid) -
                                              decayBound(bank.pole(g)) * seconds));
}

bool ActiveModes::holdsAboveTau() const noexcept {
    return std::any_of(bank.energies(), bank.energies() + bank.paddedSize(),
                       [&](float energy) { return energy > tauEnergy(); });
}

// The amplitude decays as e^{−αt} and reaches τ at t_c. A comparison at every grid point finds t_c
// without a logarithm per struck mode.
void ActiveModes::survey(Change allowed) noexcept {
    const EnergySurvey found =
        surveyEnergies(bank.energies(), bank.poles().audibleWeights(), tauEnergy(), faintEnergy,
                       activeBlocks, scratch.aboveTau.data());
    std::int32_t ringing = found.modes;
    for (const std::int32_t number : activeBlocks) {
        Block& block = states[index(number)];
        const std::uint16_t above = scratch.aboveTau[index(number)];
        if (block.rings == above)
            continue;
        const unsigned kept = allowed == Change::joinOnly ? block.rings : 0u;
        const unsigned rings = allowed == Change::none ? block.rings : above | kept;
        ringing += std::popcount(rings) - std::popcount(above);
        mixedIsRinging = mixedIsRinging && rings == block.rings;
        block.rings = static_cast<std::uint16_t>(rings);
    }
    if (found.faint)
        for (const std::int32_t b : activeBlocks)
            bank.clearFaint(index(b), faintestVelocity);
    demanded = {found.amplitudes, ringing};
}

void ActiveModes::choose(std::int32_t share, std::int64_t grid) noexcept {
    const bool all = share >= demanded.modes;
    if (all && mixedIsRinging)
        return;
    if (all)
        for (const std::int32_t b : activeBlocks)
            scratch.wanted[index(b)] = states[index(b)].rings;
    else
        selectStrongest(static_cast<std::size_t>(std::max(share, 0)));
    scratch.leaving.clear();
    scratch.joining.clear();
    for (const std::int32_t number : activeBlocks) {
        const std::size_t b = index(number);
        const unsigned before = states[b].mixed;
        const unsigned now = scratch.wanted[b];
        appendModes(b, before & ~now, scratch.leaving);
        appendModes(b, now & ~before, scratch.joining);
        states[b].mixed = scratch.wanted[b];
    }
    mixedIsRinging = all;
    output.fade(scratch.leaving, 1);
    output.fade(scratch.joining, -1);
    if (!scratch.leaving.empty() || !scratch.joining.empty())
        listMixed();
    retireBlocks(grid);
}

void ActiveModes::selectStrongest(std::size_t maximum) noexcept {
    scratch.candidates.clear();
    for (const std::int32_t number : activeBlocks) {
        scratch.wanted[index(number)] = 0;
        appendModes(index(number), states[index(number)].rings, scratch.candidates);
    }
    keepLoudest(scratch.candidates, bank.energies(), maximum);
    for (const std::int32_t g : scratch.candidates)
        scratch.wanted[index(g) / modeBlock] |= bitOf(index(g));
}

void ActiveModes::listMixed() noexcept {
    mixed.clear();
    for (const std::int32_t number : activeBlocks)
        appendModes(index(number), states[index(number)].mixed, mixed);
    findRuns(mixed, runs);
    ++changes;
}

void ActiveModes::rest(Block& block, std::int64_t grid) const noexcept {
    block.restsSince = grid;
    block.restsAtDampingLog = output.dampingLog(grid);
}

void ActiveModes::retireBlocks(std::int64_t grid) noexcept {
    std::erase_if(activeBlocks, [&](std::int32_t number) {
        Block& block = states[index(number)];
        if ((block.rings | block.mixed) != 0)
            return false;
        block.active = false;
        rest(block, grid);
        return true;
    });
}

/// Returns whether the block holds anything but zeros.
bool ActiveModes::bringUpToDate(std::size_t b, std::int64_t grid) noexcept {
    if (!(bank.energyOfLoudest(b) > 0))
        return false;
    Block& block = states[b];
    bank.advanceBlock(b, output.cellSeconds() * static_cast<double>(grid - block.restsSince),
                      std::exp(block.restsAtDampingLog - output.dampingLog(grid)),
                      faintestVelocity);
    rest(block, grid);
    return bank.energyOfLoudest(b) > 0;
}

void ActiveModes::wake(std::int64_t grid) noexcept {
    const auto isLoud = [&](std::size_t b) { return bank.energyOfLoudest(b) > tauEnergy(); };
    for (std::size_t b = 0; b < bank.blockCount(); ++b)
        if (!states[b].active && isLoud(b) && bringUpToDate(b, grid) && isLoud(b))
            activate(b);
}

void ActiveModes::activate(std::size_t b) noexcept {
    if (states[b].active)
        return;
    states[b].active = true;
    mixedIsRinging = false;
    const auto number = static_cast<std::int32_t>(b);
    activeBlocks.insert(std::ranges::lower_bound(activeBlocks, number), number);
}

/// Mixes the audible modes of `energies` above `threshold`. If the allowance is too small for all,
/// takes the loudest.
bool ActiveModes::join(const float* energies,
                       float threshold,
                       const float* loudness,
                       std::int32_t allowance,
                       bool duringContact,
                       std::int64_t grid) noexcept {
    if (allMixed())
        return false;
    surveyEnergies(energies, bank.poles().audibleWeights(), threshold, 0, bank.allBlocks(),
                   scratch.wanted.data());
    scratch.joining.clear();
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        const unsigned barred = states[b].mixed | (duringContact ? states[b].rings : 0u);
        appendModes(b, scratch.wanted[b] & ~barred, scratch.joining);
    }
    keepLoudest(scratch.joining, loudness,
                static_cast<std::size_t>(std::max(allowance - mixedCount(), 0)));
    std::ranges::sort(scratch.joining);
    if (scratch.joining.empty())
        return false;
    scratch.leaving.clear();
    for (const std::int32_t mode : scratch.joining)
        admit(index(mode), grid);
    // Modes that the budget had left out fade in from the next grid point on.
    output.fade(scratch.leaving, -1);
    findRuns(scratch.joining, scratch.joiningRuns);
    listMixed();
    mixedIsRinging = false;
    return true;
}

/// Mixes a struck mode. Earlier motion that τ had cut stays cut.
void ActiveModes::admit(std::size_t g, std::int64_t grid) noexcept {
    const std::size_t b = g / modeBlock;
    if (!states[b].active) {
        bringUpToDate(b, grid);
        activate(b);
    }
    if (rings(g))
        scratch.leaving.push_back(static_cast<std::int32_t>(g));
    else
        bank.silence(g);
    states[b].rings |= bitOf(g);
    states[b].mixed |= bitOf(g);
}

void ActiveModes::bringRestingUpToDate(std::int64_t grid) noexcept {
    for (std::size_t b = 0; b < bank.blockCount(); ++b)
        if (!states[b].active && !bringUpToDate(b, grid))
            rest(states[b], grid);
}

void ActiveModes::listRinging() noexcept {
    surveyEnergies(bank.energies(), bank.poles().audibleWeights(), tauEnergy(), 0, bank.allBlocks(),
                   scratch.aboveTau.data());
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        states[b].rings = scratch.aboveTau[b] | states[b].mixed;
        if (states[b].rings != 0)
            activate(b);
    }
    mixedIsRinging = false;
}

void ActiveModes::fadeInaudible(const ModeGroups& groups, std::int64_t grid) noexcept {
    scratch.leaving.clear();
    for (const std::int32_t mode : mixed) {
        const std::size_t g = index(mode);
        if (groups.audible(g))
            continue;
        scratch.leaving.push_back(mode);
        Block& block = states[g / modeBlock];
        block.mixed = static_cast<std::uint16_t>(block.mixed & ~bitOf(g));
        block.rings = static_cast<std::uint16_t>(block.rings & ~bitOf(g));
    }
    if (scratch.leaving.empty())
        return;
    output.fade(scratch.leaving, 1);
    listMixed();
    retireBlocks(grid);
}

void ActiveModes::regroup(const ModeGroups& groups, std::int64_t grid) noexcept {
    handOnFlags(groups);
    fadeChanges(groups.shares());
    bank.regroup(groups.size(), groups.shares(), scratch.states);
    output.findTubeParts(groups.starts());
    activeBlocks.clear();
    for (std::size_t b = 0; b < states.size(); ++b) {
        const bool active = (scratch.aboveTau[b] | scratch.wanted[b]) != 0;
        states[b] = {.rings = scratch.aboveTau[b], .mixed = scratch.wanted[b], .active = active};
        rest(states[b], grid);
        if (active)
            activeBlocks.push_back(static_cast<std::int32_t>(b));
    }
    mixedIsRinging = false;
    listMixed();
}

/// Collects the flags of the new groups in `scratch`, because the fades need the old ones. A new
/// group rings or is mixed if any old part of the group was.
void ActiveModes::handOnFlags(const ModeGroups& groups) noexcept {
    std::ranges::fill(scratch.aboveTau, std::uint16_t{0});
    std::ranges::fill(scratch.wanted, std::uint16_t{0});
    for (const ModeShare& taken : groups.shares()) {
        const std::size_t from = index(taken.from);
        const std::size_t to = index(taken.to);
        if (!(rings(from) || isMixed(from)) || !groups.audible(to))
            continue;
        if (rings(from))
            scratch.aboveTau[to / modeBlock] |= bitOf(to);
        if (isMixed(from))
            scratch.wanted[to / modeBlock] |= bitOf(to);
    }
}

/// Fades the changes, still with the old poles. Unmixed modes that join a mixed group fade in, and
/// modes that become inaudible fade out.
void ActiveModes::fadeChanges(std::span<const ModeShare> shares) noexcept {
    auto& fading = scratch.fadingShares;
    for (std::size_t g = 0; g < bank.size(); ++g)
        fading[g] = isMixed(g) ? 1.0f : 0.0f;
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
    std::ranges::fill(states, Block{});
    activeBlocks.clear();
    mixed.clear();
    runs.clear();
    mixedIsRinging = true;
    demanded = {};
    ++changes;
}

} // namespace idiophone
