#include "Instrument/CellRenderer.h"

#include "Instrument/SettingsOfParameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr float gainFractionPerCell = 0.15f; // of the distance to the goal: 10 ms

std::vector<SynthesiserSlot> copySlots(const Instrument& instrument) {
    return {instrument.slots().begin(), instrument.slots().end()};
}

} // namespace

CellRenderer::CellRenderer(const Instrument& played,
                           double sampleRateHz,
                           std::unique_ptr<CellStrategy> cellStrategy,
                           HeldContacts& contacts,
                           HandScrape& scrapingHand,
                           InputForce& soundIn)
    : instrument(played),
      synth(copySlots(played), sampleRateHz, cellStrategy->hasMallets() ? 2 : 1),
      strategy(std::move(cellStrategy)), held(contacts), hand(scrapingHand), input(soundIn),
      motor(cellSamples / sampleRateHz),
      slotDampers(played, synth.slotCount(), strategy->hasMallets()) {
    for (std::size_t slot = 0; slot < synth.slotCount(); ++slot)
        if (const auto* part = played.part(slot))
            synth.setMaterial(slot, materialOfPart(*part, *played.slots()[slot].object));
    strategy->layOut(cell, synth.slotCount());
    strategy->layOut(remains, synth.slotCount());
}

void CellRenderer::prepare(const ParameterValues& values, const KeyState& keys) {
    synth.setSettings(synthesisSettings(values));
    updateDampers(values, keys);
    synth.settle();
}

void CellRenderer::turnMotor(const ParameterValues& values,
                             double beatsPerMinute,
                             std::optional<double> songTurns,
                             bool isAtOnce) {
    if (songTurns)
        motor.keepTo(*songTurns, isAtOnce);
    const float before = motor.gain();
    const float after =
        motor.advance(motorTurnsPerSecond(values, beatsPerMinute), values[motorDepth] / 100);
    synth.setTubeOpening({.start = before, .end = after});
}

void CellRenderer::beginCell(const ParameterValues& values,
                             const KeyState& keys,
                             StrikeScheduler& strikes) {
    synth.setSettings(synthesisSettings(values));
    updateDampers(values, keys);
    sound(values, cell);
    addRemains();
    ++index;
    position = 0;
    if (strategy->hasMallets())
        input.beginCell(values);
    strategy->finish(begunCell(), strikes, cell);
}

void CellRenderer::sound(const ParameterValues& values, StereoCell& into) {
    strategy->begin(synth, into);
    held.sound(values, synthesisSettings(values), synth, into.slots);
    hand.sound(values, synth, into.slots);
}

void CellRenderer::endSilence(const ParameterValues& values, const KeyState& keys) {
    if (!std::exchange(silenced, false))
        return;
    updateDampers(values, keys);
    // Before the first cell nothing has sounded. On a second call in the same cell only strikes
    // that have just begun ring; drop them without a fade.
    if (index >= 0 && !std::exchange(hasRemains, true)) {
        synth.setTubeOpening({.start = motor.gain(), .end = motor.gain()});
        sound(values, remains);
        strategy->fadeForces(synth, remains);
    }
    synth.reset();
    held.forgetAll();
    hand.reset();
    input.reset();
}

void CellRenderer::addRemains() {
    if (!std::exchange(hasRemains, false))
        return;
    for (std::size_t k = 0; k < cellSamples; ++k) {
        const double fraction = static_cast<double>(k + 1) / cellSamples;
        const auto gain = static_cast<float>((1 + std::cos(std::numbers::pi * fraction)) / 2);
        cell.left[k] += gain * remains.left[k];
        cell.right[k] += gain * remains.right[k];
        for (std::size_t at = k; at < cell.slotSamples.size(); at += cellSamples)
            cell.slotSamples[at] += gain * remains.slotSamples[at];
    }
}

void CellRenderer::moveGain(float goal) {
    gainAtStart = index == 0 ? goal : gainAtEnd;
    gainAtEnd = index == 0 ? goal : gainAtEnd + gainFractionPerCell * (goal - gainAtEnd);
    if (std::abs(goal - gainAtEnd) < 1e-5f * goal)
        gainAtEnd = goal;
}

/// The force begins after the strikes before it, whatever the size of the parts.
void CellRenderer::soundInput(std::span<const float> heard,
                              std::size_t count,
                              StrikeScheduler& strikes) {
    const auto from = static_cast<std::size_t>(position);
    if (const auto onset = input.take(heard, from, count)) {
        strikes.strikeBefore(static_cast<double>(*onset), begunCell());
        input.press(synth);
    }
    strikes.strikeBefore(static_cast<double>(from + count), begunCell());
    input.sound(from, count, synth, cell.slots);
    if (from + count == cellSamples)
        input.endCell(synth);
}

void CellRenderer::copyOut(const StereoSpan& output,
                           std::span<const float> heard,
                           StrikeScheduler& strikes) {
    const int count = static_cast<int>(output.size());
    if (strategy->hasMallets())
        soundInput(heard, output.size(), strikes);
    else
        strikes.strikeBefore(position + count, begunCell());
    for (std::size_t k = 0; k < output.size(); ++k) {
        const auto from = static_cast<std::size_t>(position) + k;
        const float part = static_cast<float>(from + 1) / cellSamples;
        const float gain = gainAtStart + part * (gainAtEnd - gainAtStart);
        output.left[k] = gain * cell.left[from];
        output.right[k] = gain * cell.right[from];
    }
    position += count;
}

StrikeMoment CellRenderer::moment(const ParameterValues& values, double softness) {
    return {.cell = begunCell(),
            .sample = static_cast<double>(strategy->hasMallets() ? position : cellSamples),
            .values = values,
            .softness = softness};
}

void CellRenderer::updateDampers(const ParameterValues& values, const KeyState& keys) {
    slotDampers.update(values, keys, hand.heldSlot(), input.slotPressed(), silenced, synth);
}

void CellRenderer::liftHands() {
    slotDampers.liftHands();
    hand.lift();
}

void CellRenderer::setSilencedModes(const SilencedModes& modes) {
    const auto slots = instrument.slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const auto found = std::ranges::find(modes.objects, slots[slot].object.get(),
                                             &SilencedModes::OfObject::object);
        if (found == modes.objects.end())
            synth.setSilencedModes(slot, {});
        else
            synth.setSilencedModes(slot, found->isSilenced);
    }
}

void CellRenderer::reset() {
    synth.reset();
    cell.left.fill(0);
    cell.right.fill(0);
    position = cellSamples;
    index = -1;
    gainAtStart = gainAtEnd = 1;
    motor.reset();
    slotDampers.reset();
    held.forgetAll();
    input.reset();
    silenced = hasRemains = false;
}

bool CellRenderer::silent() const {
    const auto isCopied = [this](const auto& samples) {
        return std::all_of(samples.begin() + position, samples.end(),
                           [](float x) { return x == 0; });
    };
    return !hasRemains && synth.silent() && held.silent() && hand.silent() && input.silent() &&
           isCopied(cell.left) && isCopied(cell.right);
}

} // namespace idiophone
