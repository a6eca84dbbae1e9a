#include "Instrument/InputForce.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

using enum ParameterId;

constexpr int middleC = 60;
constexpr double loudestSample = 1000;  // 60 dB above full scale
constexpr double faintestSample = 1e-9; // 180 dB below full scale

int keyNearMiddleC(const Instrument& instrument) {
    const auto distance = [&](int note) {
        const int slotless = instrument.key(note).slot < 0 ? 512 : 0;
        const int borrowed = instrument.hasOwn(note) ? 0 : 256;
        return slotless + borrowed + std::abs(note - middleC);
    };
    int nearest = middleC;
    for (int note = 0; note < 128; ++note)
        if (distance(note) < distance(nearest))
            nearest = note;
    return instrument.key(nearest).slot < 0 ? -1 : nearest;
}

} // namespace

void InputForce::LowCut::tune(double hertz, double sampleRateHz) noexcept {
    g = std::tan(std::numbers::pi * std::min(hertz / sampleRateHz, 0.49));
}

double InputForce::LowCut::pass(double sample) noexcept {
    if (g == 0)
        return sample;
    constexpr double k = std::numbers::sqrt2;
    const double difference = sample - second;
    const double band = (first + g * difference) / (1 + g * (g + k));
    const double low = second + g * band;
    first = 2 * band - first;
    second = 2 * low - second;
    return sample - k * band - low;
}

bool InputForce::LowCut::isFaint() const noexcept {
    return std::abs(first) < faintestSample && std::abs(second) < faintestSample;
}

InputForce::InputForce(const Instrument& played,
                       double sampleRateHz,
                       const std::array<double, 128>& newtonsOfFullScale,
                       std::size_t contactOfForce)
    : instrument(played), rateHz(sampleRateHz), newtonsOfKeys(newtonsOfFullScale),
      contact(contactOfForce), note(keyNearMiddleC(played)) {}

void InputForce::choose(int chosen) noexcept {
    if (instrument.key(chosen).slot >= 0)
        note = chosen;
}

void InputForce::chooseSlot(std::size_t slot) noexcept {
    for (int key = 0; key < 128; ++key)
        if (instrument.key(key).slot == static_cast<int>(slot))
            return choose(key);
}

void InputForce::beginCell(const ParameterValues& values) noexcept {
    if (!presses && lowCut.isFaint())
        lowCut.reset();
    presses = false;
    newtons.fill(0);
    if (!isConnected || note < 0)
        return;
    gainBefore = gain;
    if (note != noteNow && gainBefore > 0) {
        gain = 0;
    } else {
        const bool isFirst = noteNow < 0;
        if (note != std::exchange(noteNow, note))
            changeKey(values);
        gain = newtonsOfKeys[static_cast<std::size_t>(noteNow)] *
               std::pow(10, values[inputDrive] / 20);
        if (isFirst)
            gainBefore = gain;
    }
    const auto& key = instrument.key(noteNow);
    const auto& slot = instrument.slots()[static_cast<std::size_t>(key.slot)];
    start = place.force();
    place.moveTo(key, aimedPlace(key.along, values), slot.sizeRatio * values[size],
                 cellSamples / rateHz);
    end = place.force();
    const bool isOff = values[inputLowCut] <= parameterInfo(inputLowCut).minimum;
    lowCut.tune(isOff ? 0 : values[inputLowCut], rateHz);
}

void InputForce::changeKey(const ParameterValues& values) noexcept {
    const auto& key = instrument.key(noteNow);
    place.jumpTo(key, aimedPlace(key.along, values));
}

std::optional<std::size_t>
InputForce::take(std::span<const float> input, std::size_t position, std::size_t count) noexcept {
    if (noteNow < 0 || (input.empty() && lowCut.isQuiet()))
        return std::nullopt;
    std::optional<std::size_t> from;
    for (std::size_t k = 0; k < count; ++k) {
        const double given = input.empty() || !std::isfinite(input[k]) ? 0 : input[k];
        const double sample = lowCut.pass(std::clamp(given, -loudestSample, loudestSample));
        if (std::abs(sample) < faintestSample)
            continue;
        const double share = static_cast<double>(position + k + 1) / cellSamples;
        newtons[position + k] = static_cast<float>(sample * std::lerp(gainBefore, gain, share));
        if (!from)
            from = position + k;
    }
    return presses ? std::nullopt : from;
}

void InputForce::press(Synthesiser& synthesiser) noexcept {
    auto begun = force();
    constexpr static std::array<float, cellSamples> unknown{};
    begun.newtons = unknown;
    presses = synthesiser.beginForce(static_cast<std::size_t>(instrument.key(noteNow).slot), begun,
                                     heard);
}

void InputForce::sound(std::size_t position,
                       std::size_t count,
                       const Synthesiser& synthesiser,
                       std::span<const CellOutput> cellsOfSlots) const noexcept {
    if (!presses)
        return;
    const auto slot = static_cast<std::size_t>(instrument.key(noteNow).slot);
    synthesiser.hearForce(slot, heard, force(), position, count, cellsOfSlots[slot]);
}

void InputForce::endCell(Synthesiser& synthesiser) noexcept {
    pressed.reset();
    if (!presses)
        return;
    pressed = static_cast<std::size_t>(instrument.key(noteNow).slot);
    synthesiser.endForce(*pressed, force());
}

void InputForce::reset() noexcept {
    presses = false;
    pressed.reset();
    newtons.fill(0);
    lowCut.reset();
    noteNow = -1;
    gain = 0;
}

} // namespace idiophone
