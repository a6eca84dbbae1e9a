// SPDX-License-Identifier: Apache-2.0
#include "Synth/AwakeSlots.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace idiophone {

namespace {

/// The share of every slot while the budget suffices.
constexpr std::int32_t unlimited = std::numeric_limits<std::int32_t>::max();

/// An object with a share ranks as if it were this much louder. Otherwise objects of similar
/// amplitude would take turns, and each turn costs two fades.
constexpr double advantageOfShare = 2;

} // namespace

AwakeSlots::AwakeSlots(std::deque<ModalResonator>& ofSlots,
                       std::span<AmplitudeEnvelope> envelopesOfSlots)
    : objects(ofSlots), envelopes(envelopesOfSlots), awake(ofSlots.size()),
      isAwake(ofSlots.size(), 1), statusOf(ofSlots.size()), division(ofSlots.size()),
      shares(ofSlots.size(), unlimited) {
    std::iota(awake.begin(), awake.end(), 0);
    ranked.reserve(ofSlots.size());
    demands.reserve(ofSlots.size());
}

void AwakeSlots::letAllSleep() noexcept {
    awake.clear();
    std::ranges::fill(isAwake, 0);
}

void AwakeSlots::wake(std::size_t slot) noexcept {
    if (std::exchange(isAwake[slot], 1) != 0)
        return;
    const auto number = static_cast<std::int32_t>(slot);
    awake.insert(std::ranges::lower_bound(awake, number), number);
}

void AwakeSlots::beginCell(const SynthesisSettings& settings, bool settingsChanged) noexcept {
    ++cellIndex;
    budget = wholeBudget(settings.modeBudget);
    if (settingsChanged) {
        awake.resize(objects.size());
        std::iota(awake.begin(), awake.end(), 0);
        std::ranges::fill(isAwake, 1);
    }
    const std::int64_t wanted = dropIdle(settings, settingsChanged);
    if (division.sufficient()) {
        if (wanted > budget)
            rank(settings, true);
    } else if (--cellsToRanking == 0 || settingsChanged) {
        rank(settings, cellsToRanking == 0);
    } else {
        limit(wanted);
    }
}

/// Returns how many modes the slots that stay awake would mix.
std::int64_t AwakeSlots::dropIdle(const SynthesisSettings& settings,
                                  bool settingsChanged) noexcept {
    std::int64_t wanted = 0;
    std::erase_if(awake, [&](std::int32_t number) {
        const std::size_t slot = index(number);
        if (objects[slot].beginCell(cellIndex, settings, settingsChanged)) {
            wanted += modesWanted(slot);
            return false;
        }
        isAwake[slot] = 0;
        statusOf[slot].modesMixed = statusOf[slot].share = 0;
        if (!objects[slot].asleep()) {
            envelopes[slot].clear();
            statusOf[slot] = {};
        }
        return true;
    });
    return wanted;
}

void AwakeSlots::rank(const SynthesisSettings& settings, bool periodBegins) noexcept {
    if (periodBegins)
        cellsToRanking = AmplitudeEnvelope::periodCells;
    listRinging(std::max(settings.tau * pascalsPerTau, faintestVelocity), periodBegins);
    division.divide(demands, settings.modeBudget, settings.qualitySlope);
    std::ranges::fill(shares, division.sufficient() ? unlimited : 0);
    for (const BudgetShares::Rank& rank : division.ranked())
        shares[index(ranked[rank.object])] = division.shares()[rank.object];
    for (const std::int32_t number : ranked) {
        const std::size_t slot = index(number);
        if (shares[slot] == 0 || isAwake[slot] != 0)
            continue;
        wake(slot);
        objects[slot].moveTo(cellIndex);
        objects[slot].wake();
    }
}

/// Lists the awake objects with their present amplitudes, and the sleeping ones with the bounds for
/// this time. Those whose bound has fallen to τ are silent from now on.
void AwakeSlots::listRinging(double tauPascals, bool periodBegins) noexcept {
    for (const std::int32_t slot : awake)
        objects[index(slot)].measure();
    ranked.clear();
    demands.clear();
    for (std::size_t slot = 0; slot < envelopes.size(); ++slot) {
        AmplitudeEnvelope& envelope = envelopes[slot];
        const double amplitude = envelope.amplitude();
        if (isAwake[slot] != 0 || amplitude > tauPascals) {
            ranked.push_back(static_cast<std::int32_t>(slot));
            demands.push_back({amplitude * advantage(slot), envelope.modesRinging()});
            statusOf[slot].amplitude = static_cast<float>(amplitude);
            statusOf[slot].modesRinging = envelope.modesRinging();
            if (periodBegins)
                envelope.fall();
        } else if (amplitude > 0) {
            envelope.clear();
            objects[slot].fallSilent();
            statusOf[slot] = {};
        }
    }
}

/// Takes the shares of the quietest objects if strikes since the ranking mix more than the budget.
void AwakeSlots::limit(std::int64_t mixed) noexcept {
    while (mixed > budget) {
        std::size_t quietest = objects.size();
        double least = std::numeric_limits<double>::infinity();
        for (const std::int32_t number : awake) {
            const std::size_t slot = index(number);
            if (shares[slot] > 0 && envelopes[slot].amplitude() < least) {
                quietest = slot;
                least = envelopes[slot].amplitude();
            }
        }
        if (quietest == objects.size())
            return;
        mixed -= modesWanted(quietest);
        shares[quietest] = 0;
        division.dropUpTo(least * advantageOfShare);
    }
}

void AwakeSlots::report() noexcept {
    mixedNow = 0;
    for (const std::int32_t number : awake) {
        const std::size_t slot = index(number);
        statusOf[slot] = objects[slot].status();
        statusOf[slot].share = modesWanted(slot);
        mixedNow += statusOf[slot].modesMixed;
    }
}

std::int32_t AwakeSlots::modesWanted(std::size_t slot) const noexcept {
    return std::min(shares[slot], objects[slot].demand().modes);
}

double AwakeSlots::advantage(std::size_t slot) const noexcept {
    return shares[slot] > 0 ? advantageOfShare : 1;
}

std::int32_t AwakeSlots::ownAllowance(std::size_t slot) const noexcept {
    const std::int64_t unused = std::max<std::int64_t>(budget - mixedNow, 0);
    return std::max(statusOf[slot].share,
                    objects[slot].modesMixed() + static_cast<std::int32_t>(unused));
}

StrikeAllowance AwakeSlots::strikeAllowance(std::size_t slot) const noexcept {
    if (division.sufficient())
        return {.modes = forceAllowance(slot)};
    return {.modes = isAwake[slot] != 0 ? ownAllowance(slot) : 0,
            .ranking = &division,
            .advantage = advantage(slot)};
}

std::int32_t AwakeSlots::forceAllowance(std::size_t slot) const noexcept {
    const std::size_t sounding = division.sufficient() ? awake.size() : ranked.size();
    const bool isNew = isAwake[slot] == 0 && !objects[slot].asleep();
    const auto objectsThen = static_cast<std::int64_t>(sounding + (isNew ? 1 : 0));
    const std::int64_t equalShare = budget / std::max<std::int64_t>(objectsThen, 1);
    return std::max(ownAllowance(slot), static_cast<std::int32_t>(equalShare));
}

void AwakeSlots::update(std::size_t slot, std::int32_t modesBefore) noexcept {
    const std::int32_t modes = objects[slot].modesMixed();
    mixedNow += modes - modesBefore;
    shares[slot] = std::max(shares[slot], modes);
    if (!objects[slot].idle())
        wake(slot);
}

void AwakeSlots::reset() noexcept {
    std::ranges::fill(envelopes, AmplitudeEnvelope());
    std::ranges::fill(statusOf, SlotStatus());
    std::ranges::fill(shares, unlimited);
    division.reset();
    mixedNow = 0;
}

} // namespace idiophone
