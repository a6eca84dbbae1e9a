// SPDX-License-Identifier: Apache-2.0
#include "Synth/HeavyModes.h"

#include "Synth/ContactPulse.h"
#include "Synth/ForceKernel.h"

#include <cmath>

namespace idiophone {

namespace {

ModalState operator*(double factor, const ModalState& state) noexcept {
    return {factor * state.x, factor * state.y};
}

ModalState operator+(const ModalState& a, const ModalState& b) noexcept {
    return {a.x + b.x, a.y + b.y};
}

float tableEntry(double value) noexcept {
    return std::abs(value) < faintestTableEntry ? 0.0f : static_cast<float>(value);
}

void store(const ModalState& state,
           std::size_t g,
           std::size_t channel,
           StateIncrements& increments) noexcept {
    increments.x[channel][g] = static_cast<float>(state.x);
    increments.y[channel][g] = static_cast<float>(state.y);
}

} // namespace

void HeavyMode::fillAhead(ModalState state,
                          std::size_t place,
                          SubBlockStates& ahead) const noexcept {
    for (std::size_t k = 0; k < subBlocks; ++k) {
        ahead.x[k][place] = static_cast<float>(state.x);
        ahead.y[k][place] = static_cast<float>(state.y);
        state = subBlock * state;
    }
}

HeavyModes::HeavyModes(std::size_t capacity, double sampleRateHz)
    : sampleSeconds(1 / sampleRateHz) {
    modes.reserve(capacity);
}

void HeavyModes::add(std::size_t mode, const ModalPole& pole) noexcept {
    modes.push_back({.mode = mode,
                     .pole = pole,
                     .subBlock = propagator(pole, sampleSeconds * subBlockSamples),
                     .cell = propagator(pole, sampleSeconds * cellSize)});
}

void HeavyModes::correct(std::size_t first, std::size_t end, PoleArrays& poles) const noexcept {
    for (const HeavyMode& heavy : in(first, end)) {
        const std::size_t g = heavy.mode;
        poles.cellRe[g] = poles.cellIm[g] = 0;
        for (auto* array : {&poles.sampleRe, &poles.sampleIm, &poles.subBlockRe, &poles.subBlockIm})
            (*array)[g] = 0;
        const Propagator sample = propagator(heavy.pole, sampleSeconds);
        Propagator power;
        float* table = poles.tables.data() + 2 * subBlockSamples * g;
        for (std::size_t k = 0; k < subBlockSamples; ++k) {
            table[k] = tableEntry(power.xx);
            table[subBlockSamples + k] = tableEntry(power.xy);
            power = power * sample;
        }
    }
}

void HeavyModes::makeReal(ModeResidues& residues, std::size_t channels) const noexcept {
    for (const HeavyMode& heavy : modes)
        for (std::size_t c = 0; c < channels; ++c) {
            float& re = residues[c].re[heavy.mode];
            float& im = residues[c].im[heavy.mode];
            re = std::copysign(std::hypot(re, im), re + im);
            im = 0;
        }
}

void HeavyModes::setForced(const PulseInstant& pulse, UnitContact& unit) const noexcept {
    for (const HeavyMode& heavy : modes) {
        const std::size_t g = heavy.mode;
        const ForcedResponse response(heavy.pole, pulse.contactSeconds, pulse.dampingPerSecond);
        const ModalState state = stateOf(heavy.pole, response.motion(pulse.phase));
        unit.x[g] = static_cast<float>(state.x);
        unit.y[g] = static_cast<float>(state.y);
        unit.steady[g] = static_cast<float>(response.steadyVelocity());
        unit.swingRe[g] = static_cast<float>(response.swingVelocity().real());
        unit.swingIm[g] = static_cast<float>(response.swingVelocity().imag());
        unit.quadratureRe[g] = unit.quadratureIm[g] = 0;
    }
}

// The integral of z'' + d z' + λ z = 0 over the time gives the mean displacement.
void HeavyModes::setImpulse(UnitContact& unit) const noexcept {
    for (const HeavyMode& heavy : modes) {
        const auto& pole = heavy.pole;
        const double seconds = sampleSeconds - 2 / pole.damping;
        if (!(seconds > 0))
            continue;
        const Motion end = motionOf(pole, propagator(pole, seconds) * ModalState{1, 0});
        const double displacement =
            (1 - end.velocity - pole.damping * end.displacement) / (pole.stiffness * seconds);
        const ModalState mean = stateOf(pole, {end.displacement / seconds, displacement});
        unit.x[heavy.mode] = static_cast<float>(mean.x);
        unit.y[heavy.mode] = static_cast<float>(mean.y);
    }
}

void HeavyModes::start(const UnitContact& unit,
                       const ModeResidues& residues,
                       const BeforeSample& before,
                       std::size_t channels,
                       StateIncrements& increments) const noexcept {
    for (const HeavyMode& heavy : modes) {
        const std::size_t g = heavy.mode;
        const ModalState increment =
            before.factor * (propagator(heavy.pole, before.samples * sampleSeconds) *
                             ModalState{unit.x[g], unit.y[g]});
        double largest = 0;
        for (std::size_t c = 0; c < channels; ++c) {
            const ModalState sounding = static_cast<double>(residues[c].re[g]) * increment;
            store(sounding, g, c, increments);
            largest = std::max(largest, amplitudeBound(heavy.pole, sounding));
        }
        increments.energies[g] = static_cast<float>(largest * largest);
    }
}

void HeavyModes::finish(const UnitContact& unit,
                        const ModeResidues& residues,
                        const BeforeSample& before,
                        const IncrementMove& contact,
                        std::size_t channels,
                        StateIncrements& increments) const noexcept {
    for (const HeavyMode& heavy : modes) {
        const std::size_t g = heavy.mode;
        const ModalState end{unit.x[g], unit.y[g]};
        const ModalState start =
            std::exp2(-contact.damperOctaves) * (propagator(heavy.pole, contact.seconds) * end);
        const ModalState both =
            before.factor * (propagator(heavy.pole, before.samples * sampleSeconds) *
                             ModalState{end.x - start.x, end.y - start.y});
        for (std::size_t c = 0; c < channels; ++c)
            store(static_cast<double>(residues[c].re[g]) * both, g, c, increments);
    }
}

void HeavyModes::save(const ModeStates& states,
                      std::size_t first,
                      std::size_t end,
                      std::size_t channels) noexcept {
    for (const HeavyMode& heavy : in(first, end)) {
        auto& saved = modes[static_cast<std::size_t>(&heavy - modes.data())].saved;
        for (std::size_t c = 0; c < channels; ++c)
            saved[c] = states.at(heavy.mode, c);
    }
}

void HeavyModes::advance(std::size_t first,
                         std::size_t end,
                         double seconds,
                         double factor,
                         std::size_t channels,
                         ModeStates& states) const noexcept {
    for (const HeavyMode& heavy : in(first, end)) {
        const Propagator motion = propagator(heavy.pole, seconds);
        for (std::size_t c = 0; c < channels; ++c)
            states.set(heavy.mode, c, factor * (motion * heavy.saved[c]));
    }
}

void HeavyModes::advanceCell(std::size_t first,
                             std::size_t end,
                             double scale,
                             std::size_t channel,
                             ModeStates& states,
                             float* energies,
                             SubBlockStates& ahead) const noexcept {
    for (const HeavyMode& heavy : in(first, end)) {
        const std::size_t place = heavy.mode - first;
        heavy.fillAhead(heavy.saved[channel], place, ahead);
        const ModalState next = scale * (heavy.cell * heavy.saved[channel]);
        states.set(heavy.mode, channel, next);
        const double size = amplitudeBound(heavy.pole, next);
        energies[place] = static_cast<float>(size * size);
    }
}

void HeavyModes::join(const StateIncrements& increments,
                      const IncrementMove& move,
                      std::size_t channels,
                      ModeStates& states) const noexcept {
    for (const HeavyMode& heavy : modes) {
        const std::size_t g = heavy.mode;
        const Propagator motion = propagator(heavy.pole, move.seconds);
        const double factor = std::exp2(-move.damperOctaves);
        for (std::size_t c = 0; c < channels; ++c)
            states.set(g, c,
                       heavy.saved[c] +
                           factor * (motion * ModalState{increments.x[c][g], increments.y[c][g]}));
    }
}

void HeavyModes::force(std::span<const float, cellSize> impulses,
                       const ModeResidues& startResidues,
                       const ModeResidues& endResidues,
                       std::size_t channels,
                       ModeStates& states) const noexcept {
    for (const HeavyMode& heavy : modes) {
        const std::size_t g = heavy.mode;
        const Propagator sample = propagator(heavy.pole, sampleSeconds);
        for (std::size_t c = 0; c < channels; ++c) {
            const auto start = static_cast<double>(startResidues[c].re[g]);
            const auto change = static_cast<double>(endResidues[c].re[g]) - start;
            ModalState moving;
            for (std::size_t k = 0; k < cellSize; ++k) {
                const double residue =
                    start + change * static_cast<double>(fractionAt(k / subBlockSamples));
                moving.x += residue * static_cast<double>(impulses[k]);
                moving = sample * moving;
            }
            states.set(g, c, heavy.saved[c] + moving);
        }
    }
}

void HeavyModes::measure(std::size_t first,
                         std::size_t end,
                         const ModeStates& states,
                         std::size_t channels,
                         AlignedVector<float>& energies) const noexcept {
    for (const HeavyMode& heavy : in(first, end))
        energies[heavy.mode] = states.energy(heavy.mode, heavy.pole, channels);
}

} // namespace idiophone
