#include "Synth/ModalBank.h"

#include "Synth/ModalBankKernel.h"

#include <cmath>

namespace idiophone {

namespace {

// Far below the rounding of a table, far above denormals even when multiplied by a faint state.
constexpr double faintestTableEntry = 1e-15;

float tableEntry(double value) noexcept {
    return std::abs(value) < faintestTableEntry ? 0.0f : static_cast<float>(value);
}

} // namespace

ModalBank::ModalBank(std::size_t capacity, double sampleRateHz)
    : sampleSeconds(1 / sampleRateHz), poles(capacity), tables(2 * subBlockSamples * capacity),
      steps(4 * capacity), cellSteps(capacity), states(2 * capacity) {}

void ModalBank::setPole(std::size_t g, const ModalPole& pole) noexcept {
    if (isOscillating(pole) != isOscillating(poles[g]))
        setState(g, stateOf(pole, motionOf(poles[g], state(g))));
    poles[g] = pole;

    const Propagator sample = propagator(pole, sampleSeconds);
    Propagator power;
    float* table = tables.data() + 2 * subBlockSamples * g;
    for (std::size_t k = 0; k < subBlockSamples; ++k) {
        table[k] = tableEntry(power.xx);
        table[subBlockSamples + k] = tableEntry(power.xy);
        power = power * sample;
    }
    const Propagator step = propagator(pole, sampleSeconds * static_cast<double>(subBlockSamples));
    double* row = steps.data() + 4 * g;
    row[0] = step.xx;
    row[1] = step.xy;
    row[2] = step.yx;
    row[3] = step.yy;
    cellSteps[g] = step * step * step * step;
}

void ModalBank::setState(std::size_t g, const ModalState& state) noexcept {
    states[2 * g] = state.x;
    states[2 * g + 1] = state.y;
}

void ModalBank::add(std::size_t g, const ModalState& state) noexcept {
    states[2 * g] += state.x;
    states[2 * g + 1] += state.y;
}

void ModalBank::scale(std::size_t g, double factor) noexcept {
    states[2 * g] *= factor;
    states[2 * g + 1] *= factor;
}

void ModalBank::advance(std::size_t g, double seconds) noexcept {
    setState(g, propagator(poles[g], seconds) * state(g));
}

void ModalBank::advanceCell(std::size_t g) noexcept {
    setState(g, cellSteps[g] * state(g));
}

void ModalBank::render(std::span<const std::int32_t> active, std::span<float> output) noexcept {
    renderModalBank({tables.data(), steps.data(), states.data()}, active, output);
}

void ModalBank::renderFrom(std::span<double> otherStates,
                           std::span<const std::int32_t> active,
                           std::span<float> output) const noexcept {
    renderModalBank({tables.data(), steps.data(), otherStates.data()}, active, output);
}

} // namespace idiophone
