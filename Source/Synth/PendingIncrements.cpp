// SPDX-License-Identifier: Apache-2.0
#include "Synth/PendingIncrements.h"

#include <numbers>

namespace idiophone {

PendingIncrements::PendingIncrements(ModalBank& ownBank,
                                     BankOutput& ownOutput,
                                     ActiveModes& activeModes,
                                     SynthesisScratch& sharedScratch)
    : bank(ownBank), output(ownOutput), active(activeModes), scratch(sharedScratch),
      increments(ownBank.emptyIncrements()) {}

BeforeSample PendingIncrements::beforeSample(double at) const noexcept {
    const double samples = firstSampleFrom(at) - at;
    const double damping = output.damping();
    return {samples, damping > 0 ? std::exp(-damping * samples / output.sampleRateHz()) : 1};
}

IncrementMove PendingIncrements::moveBy(double seconds) const noexcept {
    return {seconds, seconds * output.sampleRateHz(),
            output.damping() * seconds * std::numbers::log2e};
}

void PendingIncrements::start(double sign, double at) noexcept {
    const BeforeSample before = beforeSample(at);
    increments.start(bank, scratch.contact, scratch.groupResidues,
                     {before.samples, sign * before.factor});
}

const float* PendingIncrements::energiesAfter(double contactSeconds) const noexcept {
    if (contactSeconds == 0)
        return energies();
    increments.energiesAfter(bank, contactSeconds * output.sampleRateHz(), scratch.energiesAfter);
    return scratch.energiesAfter.data();
}

void PendingIncrements::finish(double contactSeconds, double end) noexcept {
    increments.finish(bank, scratch.contact, scratch.groupResidues, beforeSample(end),
                      moveBy(contactSeconds));
}

void PendingIncrements::sound(int from, int until, const CellOutput& cell) noexcept {
    if (from >= until)
        return;
    const auto first = static_cast<std::size_t>(from);
    const auto samples = static_cast<std::size_t>(until - from);
    alignas(64) CellSound sound{};
    const bool pulses = output.tubesPulse();
    const ChannelOutputs tube = outputsOf(scratch.tubeSound);
    if (pulses)
        scratch.tubeSound = {};
    increments.sound(bank, active.mixedRuns(), (samples + subBlockSamples - 1) / subBlockSamples,
                     outputsOf(sound), output.pulsing(active.mixedRuns()), tube);
    output.fadeByDamper(outputsOf(sound), samples);
    output.add(sound, first, samples, cell);
    if (!pulses)
        return;
    output.fadeByDamper(tube, samples);
    output.closeTubes(scratch.tubeSound, first, samples, cell);
}

void PendingIncrements::soundAndKeep(int from, const CellOutput& cell) noexcept {
    sound(from, cellSamples, cell);
    move = moveToGridFrom(from);
}

void PendingIncrements::joinAsleep(int from, std::int64_t grid) noexcept {
    active.bringRestingUpToDate(grid);
    bank.join(increments, moveToGridFrom(from));
    active.listResting();
}

void PendingIncrements::takeIn(std::int64_t grid) noexcept {
    if (!move)
        return;
    active.bringRestingUpToDate(grid);
    bank.join(increments, *move);
    move.reset();
    if (!active.allMixed())
        active.listRinging();
}

} // namespace idiophone
