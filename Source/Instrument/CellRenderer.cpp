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
      motor(cellSamples / sampleRateHz), slotOutputs(played),
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
    followOutputs(values);
    sound(values, cell);
    addRemains();
    ++index;
    position = 0;
    if (strategy->hasMallets())
        input.beginCell(values);
    strategy->finish(begunCell(), strikes, cell);
}

/// Ringing slots change their output after a fade over one cell, and before another one.
void CellRenderer::followOutputs(const ParameterValues& values) {
    const bool differs =
        slotOutputs.find(static_cast<int>(values[ParameterId::outputs]), connected);
    const bool changes = differs && !hasRemains && (index < 0 || openAtEnd == 0);
    if (changes) {
        slotOutputs.change();
        cell.route(slotOutputs.ofSlots());
        remains.route(slotOutputs.ofSlots());
    }
    openAtStart = openAtEnd;
    openAtEnd = differs && !changes ? 0.0f : 1.0f;
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
        for (std::size_t output = 0; output < remains.outputsInUse; ++output) {
            cell.channels[output].left[k] += gain * remains.channels[output].left[k];
            cell.channels[output].right[k] += gain * remains.channels[output].right[k];
        }
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

void CellRenderer::copyOut(std::span<const StereoSpan> to,
                           std::size_t from,
                           std::size_t until,
                           std::span<const float> heard,
                           StrikeScheduler& strikes) {
    const auto count = until - from;
    if (strategy->hasMallets())
        soundInput(heard.empty() ? heard : heard.subspan(from, count), count, strikes);
    else
        strikes.strikeBefore(position + static_cast<int>(count), begunCell());
    const auto begin = static_cast<std::size_t>(position);
    alignas(64) std::array<float, cellSamples> gains;
    for (std::size_t k = 0; k < count; ++k) {
        const float part = static_cast<float>(begin + k + 1) / cellSamples;
        gains[k] = (gainAtStart + part * (gainAtEnd - gainAtStart)) *
                   (openAtStart + part * (openAtEnd - openAtStart));
    }
    const auto copy = [&](std::span<const float> samples, std::span<float> into) {
        for (std::size_t k = 0; k < count; ++k)
            into[from + k] = gains[k] * samples[begin + k];
    };
    for (std::size_t output = 0; output < to.size(); ++output) {
        if (to[output].left.data() == nullptr)
            continue;
        if (output < cell.outputsInUse) {
            copy(cell.channels[output].left, to[output].left);
            copy(cell.channels[output].right, to[output].right);
        } else {
            std::ranges::fill(to[output].left.subspan(from, count), 0.0f);
            std::ranges::fill(to[output].right.subspan(from, count), 0.0f);
        }
    }
    position += static_cast<int>(count);
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
    for (auto& output : cell.channels)
        output.output().clear();
    position = cellSamples;
    index = -1;
    gainAtStart = gainAtEnd = openAtStart = openAtEnd = 1;
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
           std::ranges::all_of(cell.used(), [&](const StereoCell::Channels& output) {
               return isCopied(output.left) && isCopied(output.right);
           });
}

} // namespace idiophone
