// SPDX-License-Identifier: Apache-2.0
#include "Synth/ContactSet.h"

#include "Synth/StrikeKernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {

ContactSet::ContactSet(const ModalObject& modalObject,
                       ModalBank& ownBank,
                       BankOutput& ownOutput,
                       ActiveModes& activeModes,
                       GroupResidues& groupResidues,
                       SynthesisScratch& sharedScratch)
    : object(modalObject), bank(ownBank), output(ownOutput), active(activeModes),
      residues(groupResidues), scratch(sharedScratch), rigidBody(rigidRadiator(object)) {
    contacts.reserve(capacity);
    clicks.reserve(capacity);
}

bool ContactSet::compute(const Contact& contact) noexcept {
    const Strike& strike = contact.strike;
    const bool reasonable =
        residues.compute(strike.point, strike.impulseNewtonSeconds, contact.listening);
    scratch.contact.setForced(bank.poles(), {.contactSeconds = strike.durationSeconds,
                                             .dampingPerSecond = output.damping()});
    return reasonable;
}

void ContactSet::computeImpulse() noexcept {
    scratch.contact.setImpulse(bank.poles());
    bank.poles().heavy().setImpulse(scratch.contact);
}

void ContactSet::hold(Contact& contact,
                      std::span<const ModeRun> modes,
                      double factor) const noexcept {
    addMotion(modes, factor, contact.mixed);
    for (const ModePart& part : output.tubePartsOf(modes)) {
        const ModeRun mode{part.mode, 1};
        addMotion({&mode, 1}, factor * static_cast<double>(part.share), contact.tube);
    }
}

void ContactSet::addMotion(std::span<const ModeRun> modes,
                           double factor,
                           ForcedMotion& motion) const noexcept {
    for (std::size_t c = 0; c < bank.channels(); ++c) {
        ForcedSum sum;
        for (const ModeRun& run : modes)
            sumForced(scratch.groupResidues[c], scratch.contact, run, sum);
        motion.steadyVelocity[c] += factor * sum.steady;
        motion.swing[c] += factor * sum.swing;
    }
}

void ContactSet::join(std::span<const ModeRun> modes) noexcept {
    if (modes.empty())
        return;
    for (Contact& contact : contacts) {
        compute(contact);
        hold(contact, modes);
    }
}

double ContactSet::sound(const Contact& contact,
                         std::int64_t index,
                         const CellOutput& cell) const noexcept {
    const double cells = static_cast<double>(index - contact.startCell);
    const double end = contact.startSample +
                       contact.strike.durationSeconds * output.sampleRateHz() - cells * cellSamples;
    const int from = cells > 0 ? 0 : firstSampleFrom(contact.startSample);
    const int until = firstSampleFrom(std::min(end, double(cellSamples)));
    if (from >= until)
        return end;
    const auto first = static_cast<std::size_t>(from);
    const auto samples = static_cast<std::size_t>(until - from);
    const std::complex<double> phase = contact.phaseAt(index, from, output.sampleRateHz());
    alignas(64) CellSound sound;
    render(contact, contact.mixed, phase, samples, sound);
    output.add(sound, first, samples, cell);
    if (output.tubesPulse()) {
        render(contact, contact.tube, phase, samples, sound);
        output.closeTubes(sound, first, samples, cell);
    }
    return end;
}

void ContactSet::render(const Contact& contact,
                        const ForcedMotion& motion,
                        std::complex<double> phase,
                        std::size_t samples,
                        CellSound& sound) const noexcept {
    const double radians =
        2 * std::numbers::pi / (output.sampleRateHz() * contact.strike.durationSeconds);
    for (std::size_t c = 0; c < bank.channels(); ++c)
        raisedCosine(motion.steadyVelocity[c], motion.swing[c] * phase, radians, samples,
                     sound[c].data());
}

void ContactSet::mix(PendingIncrements& increments,
                     std::int64_t index,
                     const CellOutput& cell) noexcept {
    for (std::size_t c = 0; c < contacts.size();) {
        const Contact contact = contacts[c];
        const double end = sound(contact, index, cell);
        if (end >= cellSamples) {
            ++c;
            continue;
        }
        contacts.erase(contacts.begin() + static_cast<std::ptrdiff_t>(c));
        increments.takeIn(index + 1);
        compute(contact);
        increments.start(1, end);
        increments.soundAndKeep(firstSampleFrom(end), cell);
    }
    std::erase_if(clicks,
                  [&](const Contact& click) { return sound(click, index, cell) <= cellSamples; });
}

void ContactSet::startClick(const Contact& contact,
                            double size,
                            std::size_t outputChannels,
                            std::int64_t index,
                            const CellOutput& cell) noexcept {
    const Listening& listening = contact.listening;
    if (!(listening.farShare > 0) || !(rigidBody.massKg > 0) || clicks.size() == capacity)
        return;
    const auto& directions = object.radiation.directions;
    const std::int32_t from = contact.strike.point.radiationDirection;
    const std::size_t left = from < 0 ? 0 : static_cast<std::size_t>(from);
    const std::size_t right = from < 0 ? std::min(directions.size(), maximumChannels) - 1 : left;
    auto [seconds, pascals] =
        rigidClick(rigidBody, contact.strike.impulseNewtonSeconds, contact.strike.durationSeconds,
                   size, output.sampleRateHz(), {directions[left], directions[right]});
    for (double& channel : pascals) // farGain is proportional to 1/size²
        channel *= listening.farShare * listening.farGain * size * size;
    if (outputChannels == 1)
        pascals[0] = (pascals[0] + pascals[1]) / 2;
    Contact click = contact;
    click.strike.durationSeconds = seconds;
    click.mixed = click.tube = {};
    for (std::size_t c = 0; c < maximumChannels; ++c) {
        if (!(std::abs(pascals[c]) <= static_cast<double>(largestResidue)))
            return;
        click.mixed.swing[c] = {0, -pascals[c]}; // Re(−i P e^{iΩt}) = P sin Ωt
    }
    if (sound(click, index, cell) > cellSamples)
        clicks.push_back(click);
}

/// Moves the forced parts of every mode into or out of the free motion, as the end of a contact
/// does.
void ContactSet::move(Forced become, std::int64_t grid) noexcept {
    if (contacts.empty())
        return;
    active.bringRestingUpToDate(grid);
    scratch.increments.clear();
    std::array<bool, capacity> moved{};
    for (std::size_t first = 0; first < contacts.size(); ++first) {
        if (moved[first])
            continue;
        compute(contacts[first]);
        move(contacts[first], 1, become, grid);
        for (std::size_t k = first + 1; k < contacts.size(); ++k) {
            const double share =
                moved[k] ? 0 : residueRatio(contacts[k].heard(), contacts[first].heard());
            if (share == 0)
                continue;
            moved[k] = true;
            move(contacts[k], share, become, grid);
        }
    }
    bank.join(scratch.increments, {});
}

/// Moves the forced parts of one contact, whose residues are `factor` times the current ones.
void ContactSet::move(Contact& contact, double factor, Forced become, std::int64_t grid) noexcept {
    const std::complex<double> phase = contact.phaseAt(grid, 0, output.sampleRateHz());
    scratch.contact.setForced(bank.poles(), {.contactSeconds = contact.strike.durationSeconds,
                                             .dampingPerSecond = output.damping(),
                                             .phase = phase});
    scratch.increments.gather(bank, scratch.contact, scratch.groupResidues,
                              become == Forced::freed ? factor : -factor, 1 - phase.real());
    if (become == Forced::freed)
        return;
    contact.mixed = contact.tube = {};
    hold(contact, active.mixedRuns(), factor);
}

void ContactSet::widen() noexcept {
    for (Contact& contact : contacts)
        for (ForcedMotion* motion : {&contact.mixed, &contact.tube}) {
            motion->steadyVelocity[1] = motion->steadyVelocity[0];
            motion->swing[1] = motion->swing[0];
        }
}

void ContactSet::reset() noexcept {
    contacts.clear();
    clicks.clear();
}

} // namespace idiophone
