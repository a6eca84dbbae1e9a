// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModalResonator.h"

#include "Synth/AllFinite.h"
#include "Synth/ContactPulse.h"
#include "Synth/GroupsReport.h"
#include "Synth/LiveConditions.h"
#include "Synth/PointShapes.h"
#include "Synth/TubeShares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone {
ModalResonator::ModalResonator(SynthesiserSlot ownSlot,
                               ModeGroups::ModeWeights modeWeights,
                               std::uint32_t seed,
                               std::size_t channels,
                               double sampleRateHz,
                               SynthesisScratch& sharedScratch,
                               AmplitudeEnvelope& ownEnvelope)
    : scratch(sharedScratch), envelope(ownEnvelope), slot(std::move(ownSlot)), object(*slot.object),
      outputChannels(channels),
      bank(object.modeCount(), object.radiation.empty() ? 1 : channels, sampleRateHz),
      output(bank, tubeShares(object), sampleRateHz, scratch),
      groups(object, std::move(modeWeights), seed, sampleRateHz, scratch),
      residues(object, groups, bank, channels, scratch), active(bank, output, scratch),
      increments(bank, output, active, scratch),
      contacts(object, bank, output, active, residues, scratch),
      forces(bank, output, active, residues, scratch) {
    output.findTubeParts(groups.starts());
    applySettings({});
    movePoles(true);
}

void ModalResonator::setSilencedModes(std::span<const std::uint8_t> silenced) noexcept {
    if (groups.requestSilenced(silenced))
        controlsChanged = true;
}

bool ModalResonator::beginCell(std::int64_t cell,
                               const SynthesisSettings& settings,
                               bool settingsChanged) noexcept {
    increments.takeIn(cell);
    cellIndex = cell;
    if (settingsChanged || controlsChanged || mayRegroup)
        applySettings(settings);
    if (idle()) {
        if (asleep())
            envelope.updateFalls(bank.poles(), output.damping());
        return false;
    }
    // During a contact the set of ringing modes stays fixed. During a continuous force modes may
    // join but not leave.
    using Change = ActiveModes::Change;
    active.survey(!contacts.empty()               ? Change::none
                  : forces.actedIn(cellIndex - 1) ? Change::joinOnly
                                                  : Change::any);
    return true;
}

void ModalResonator::wake() noexcept {
    active.wake(cellIndex);
    active.survey(ActiveModes::Change::any);
}

void ModalResonator::measure() noexcept {
    envelope.updateFalls(bank.poles(), output.damping());
    envelope.set(bank.poles(), bank.energies(), active.demand().modes);
    active.reconsider();
}

void ModalResonator::applySettings(const SynthesisSettings& settings) noexcept {
    controlsChanged = false;
    SynthesisSettings own = settings;
    if (requestedMaterial)
        own.material = requestedMaterial;
    const LiveConditions live = liveConditions(slot, own, requestedFrequencyRatio);
    const GroupConditions wanted{.law = live.law,
                                 .compression = settings.compression,
                                 .thicknessRatio =
                                     object.hasLiveThickness() ? settings.thicknessRatio : 1,
                                 .imperfection = settings.imperfection};
    // Even τ = 0 drops states below an inaudible floor.
    const double newTau = std::max(settings.tau * pascalsPerTau, faintestVelocity);
    listening = {.nearGain = contactMicrophonePascals * live.gainRatio / wanted.thicknessRatio,
                 .farGain = live.radiationGainRatio / wanted.thicknessRatio,
                 .farShare = object.radiation.empty() ? 0 : settings.radiation};
    sizeNow = slot.sizeRatio * settings.sizeRatio;

    const bool differs = groups.differFrom(wanted);
    const bool regroups = std::exchange(mayRegroup, false) && (differs || groups.areOutdated());
    const bool polesMove = differs || regroups;
    const bool contactsMove = polesMove || requestedDamping != output.damping() ||
                              live.radiationRatio != residues.radiationRatio();
    const bool tauFalls = newTau < active.tau();
    if (!contactsMove && newTau == active.tau())
        return;
    // A contact's forced part belongs to the poles, radiation weights and damping that it was
    // computed with. Turn it into free motion before the change, and take it out again with the new
    // values.
    if (contactsMove)
        contacts.free(cellIndex);
    residues.setRadiationRatio(live.radiationRatio);
    forces.invalidate();
    envelope.invalidateFalls();
    output.setDamping(requestedDamping, cellIndex);
    active.setTau(newTau);
    groups.set(wanted);
    if (regroups)
        clearOldBank();
    // A silent object that does not sleep keeps its former poles until its turn or a strike.
    const bool moves = regroups || (groups.areBehind() && (!silent() || tauFalls));
    if (moves)
        movePoles(regroups);
    if (contactsMove)
        contacts.holdAgain(cellIndex);
    if ((moves || tauFalls) && !bankIsOld)
        active.wake(cellIndex);
}

void ModalResonator::movePoles(bool regroups) noexcept {
    forces.invalidate();
    residues.invalidate();
    envelope.invalidateFalls();
    regroups = regroups || groups.mustFollow();
    // Bring resting states up to date with their old poles.
    active.bringRestingUpToDate(cellIndex);
    if (!regroups)
        groups.keep();
    if (regroups && groups.follow())
        active.regroup(groups, cellIndex);
    else
        active.fadeInaudible(groups, cellIndex);
    bank.movePoles(groups.eigenvalues(), groups.conditions().law, lowestSoundingHz,
                   highestSoundingShare * output.sampleRateHz(), groups.dampings(),
                   groups.silences());
}

void ModalResonator::catchUp(const SynthesisSettings& settings) noexcept {
    if (!controlsChanged || !contacts.empty())
        return;
    increments.takeIn(cellIndex + 1);
    ++cellIndex; // the grid point of the states
    applySettings(settings);
    --cellIndex;
}

void ModalResonator::mix(std::int32_t allowance, const CellOutput& cell) noexcept {
    if (contacts.empty() && !forces.actedIn(cellIndex - 1)) {
        if (allowance == 0 && !active.blocks().none())
            measure(); // it falls asleep
        active.choose(allowance, cellIndex);
    }
    output.render(active.blocks().list(), active.mixedRuns(), cell);
    contacts.mix(increments, cellIndex, cell);
}

void ModalResonator::clearOldBank() noexcept {
    if (std::exchange(bankIsOld, false))
        bank.clear();
}

/// Updates poles and groups to the settings. A silent resonator starts again in one channel.
void ModalResonator::prepareBank() noexcept {
    clearOldBank();
    increments.takeIn(cellIndex + 1);
    const bool regroups = groups.areOutdated() && silent() && scratch.modesToRegroup > 0;
    if (silent())
        bank.setChannels(1);
    if (regroups)
        scratch.modesToRegroup -= static_cast<std::int64_t>(object.modeCount());
    if (groups.areBehind() || regroups)
        movePoles(regroups);
}

/// Opens the second channel at the first strike with far sound.
void ModalResonator::widen(double farShare) noexcept {
    if (!(farShare > 0) || outputChannels == 1 || bank.channels() == maximumChannels)
        return;
    bank.setChannels(maximumChannels);
    forces.invalidate();
    residues.invalidate();
    output.widen();
    contacts.widen();
}

bool ModalResonator::strike(const Strike& asked,
                            double sampleInCell,
                            const StrikeAllowance& allowed,
                            const CellOutput& cell) noexcept {
    const bool isPulse = asked.durationSeconds * output.sampleRateHz() >= shortestContactSamples;
    const bool isValid = isOn(object, asked.point) && allFinite(asked.impulseNewtonSeconds) &&
                         std::isfinite(asked.durationSeconds) && asked.durationSeconds >= 0 &&
                         sampleInCell >= 0 && sampleInCell < cellSamples;
    if (!isValid || (isPulse && contacts.full()))
        return false;
    prepareBank();
    Contact contact{.strike = asked,
                    .listening = listening,
                    .startCell = cellIndex,
                    .startSample = sampleInCell};
    widen(listening.farShare);
    double& seconds = contact.strike.durationSeconds;
    seconds = isPulse ? contactSecondsClearOf(bank.poles().resonances(), seconds) : 0;
    if (!(isPulse ? contacts.compute(contact)
                  : residues.compute(asked.point, asked.impulseNewtonSeconds, listening)))
        return false;
    if (!isPulse)
        contacts.computeImpulse();
    increments.start(isPulse ? -1 : 1, sampleInCell);
    const float* loudness = increments.energiesAfter(seconds);
    std::int32_t allowance = allowed.modes;
    if (allowed.ranking != nullptr) {
        envelope.add(bank.poles(), loudness);
        allowance = std::max(allowance,
                             allowed.ranking->allowance(envelope.amplitude() * allowed.advantage));
        if (allowance == 0 && strikeAsleep(contact, cell))
            return true;
    }
    const auto joined = active.join({increments.energies(), active.tauEnergy(), loudness},
                                    allowance, !contacts.empty(), cellIndex + 1);
    contacts.join(joined);
    if (isPulse && !joined.empty() && !contacts.empty())
        contacts.compute(contact); // the other contacts used the scratch

    int from = firstSampleFrom(sampleInCell);
    if (isPulse) {
        contacts.hold(contact, active.mixedRuns());
        const double end = contacts.sound(contact, cellIndex, cell);
        if (end <= cellSamples) {
            increments.sound(from, firstSampleFrom(end), cell);
            increments.finish(seconds, end);
            from = firstSampleFrom(end);
        } else {
            contacts.add(contact);
        }
    }
    increments.soundAndKeep(from, cell);
    contacts.startClick(contact, sizeNow, outputChannels, cellIndex, cell);
    return true;
}

/// Adds the strike to the resting states, and its click to the cell, if it ends in this cell.
bool ModalResonator::strikeAsleep(const Contact& contact, const CellOutput& cell) noexcept {
    const double seconds = contact.strike.durationSeconds;
    const double end = contact.startSample + seconds * output.sampleRateHz();
    if (!idle() || end > cellSamples)
        return false;
    if (seconds > 0)
        increments.finish(seconds, end);
    increments.joinAsleep(firstSampleFrom(end), cellIndex + 1);
    measure();
    contacts.startClick(contact, sizeNow, outputChannels, cellIndex, cell);
    return true;
}

bool ModalResonator::beginForce(const ForceCell& force,
                                std::int32_t allowance,
                                HeardForce& heard) noexcept {
    if (force.contact >= forceCapacity || !isOn(object, force.start) || !isOn(object, force.end) ||
        !allWithin(force.newtons, largestForceNewtons))
        return false;
    prepareBank();
    widen(forces.begin(cellIndex, listening));
    contacts.join(active.join({bank.poles().audibleWeights(), 0, bank.energies()}, allowance,
                              !contacts.empty(), cellIndex + 1));
    forces.hear(force, heard);
    return true;
}

void ModalResonator::reset() noexcept {
    bankIsOld = true;
    bank.setChannels(1);
    residues.invalidate();
    active.reset();
    contacts.reset();
    increments.reset();
    forces.reset();
    output.reset();
}

void ModalResonator::report(SoundingGroups& report, std::int64_t cell) const noexcept {
    reportGroups(groups, active, cell, report);
    if (bankIsOld)
        std::ranges::fill(report.amplitudes, 0.0f);
}

} // namespace idiophone
