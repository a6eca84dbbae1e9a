// Contacts under way: their sound, and how they follow moving poles.
#include "Synth/ModalResonator.h"

#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {

/// Adds the forced motion of `modes`, with `factor` times the current residues, to the contact.
void ModalResonator::hold(Contact& contact,
                          std::span<const ModeRun> modes,
                          double factor) noexcept {
    addMotion(modes, factor, contact.mixed);
    for (const ModePart& part : tubePartsOf(modes)) {
        const ModeRun mode{part.mode, 1};
        addMotion({&mode, 1}, factor * static_cast<double>(part.share), contact.tube);
    }
}

void ModalResonator::addMotion(std::span<const ModeRun> modes,
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

std::complex<double>
ModalResonator::phaseAt(const Contact& contact, std::int64_t cell, double sample) const noexcept {
    const double cells = static_cast<double>(cell - contact.startCell);
    const double samples = cells * cellSamples + sample - contact.startSample;
    const double turns = samples / (sampleRate * contact.strike.durationSeconds);
    return std::polar(1.0, 2 * std::numbers::pi * turns);
}

double ModalResonator::shareOfResidues(const Contact& contact, const Contact& other) noexcept {
    const Listening &own = contact.heard, &others = other.heard;
    if (own.farShare != others.farShare || contact.strike.point != other.strike.point ||
        own.nearGain * others.farGain != own.farGain * others.nearGain)
        return 0;
    double along = 0;
    double square = 0;
    double otherSquare = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto impulse = static_cast<double>(contact.strike.impulseNewtonSeconds[k]);
        const auto otherImpulse = static_cast<double>(other.strike.impulseNewtonSeconds[k]);
        along += impulse * otherImpulse;
        square += impulse * impulse;
        otherSquare += otherImpulse * otherImpulse;
    }
    if (!(otherSquare > 0) || along * along < (1 - 1e-12) * square * otherSquare)
        return 0;
    return along / otherSquare * own.nearGain / others.nearGain;
}

/// Turns the forced parts of all contacts into free motion at the grid point, or takes them out of
/// it again. It does so for every mode, as the ends of the contacts will.
void ModalResonator::moveContacts(Forced become) noexcept {
    if (contacts.empty())
        return;
    bringRestingUpToDate(cellIndex);
    scratch.increments.clear();
    std::array<bool, contactCapacity> moved{};
    for (std::size_t first = 0; first < contacts.size(); ++first) {
        if (moved[first])
            continue;
        computeResidues(contacts[first]);
        moveContact(contacts[first], 1, become);
        for (std::size_t k = first + 1; k < contacts.size(); ++k) {
            const double share = moved[k] ? 0 : shareOfResidues(contacts[k], contacts[first]);
            if (share == 0)
                continue;
            moved[k] = true;
            moveContact(contacts[k], share, become);
        }
    }
    bank.join(scratch.increments, {});
}

/// Does this for one contact, whose residues are `factor` times the current ones.
void ModalResonator::moveContact(Contact& contact, double factor, Forced become) noexcept {
    const std::complex<double> phase = phaseAt(contact, cellIndex, 0);
    scratch.contact.setForced(bank.poles(), {.contactSeconds = contact.strike.durationSeconds,
                                             .dampingPerSecond = damping,
                                             .phase = phase});
    scratch.increments.gather(bank, scratch.contact, scratch.groupResidues,
                              become == Forced::freed ? factor : -factor, 1 - phase.real());
    if (become == Forced::freed)
        return;
    contact.mixed = contact.tube = {};
    hold(contact, mixedRuns, factor);
}

} // namespace idiophone
