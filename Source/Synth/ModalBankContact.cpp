// Contacts of a modal bank: state increments and continuous force.
#include "Synth/ContactPulse.h"
#include "Synth/ForceKernel.h"
#include "Synth/ModalBank.h"
#include "Synth/ModeIndex.h"
#include "Synth/PoleKernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {

namespace {

ModalState operator*(double factor, const ModalState& state) noexcept {
    return {factor * state.x, factor * state.y};
}

std::array<IncrementChannel, maximumChannels> channelsOf(const ModeResidues& residues,
                                                         StateIncrements& increments) noexcept {
    std::array<IncrementChannel, maximumChannels> channels{};
    for (std::size_t c = 0; c < maximumChannels; ++c)
        channels[c] = {residues[c].re.data(), residues[c].im.data(), increments.x[c].data(),
                       increments.y[c].data()};
    return channels;
}

bool isIn(std::span<const ModeRun> runs, std::int32_t mode) noexcept {
    return std::ranges::any_of(runs, [mode](const ModeRun& run) {
        return mode >= run.first && mode < run.first + run.count;
    });
}

} // namespace

IncrementModes ModalBank::incrementModes() const noexcept {
    return {frequency.data(), halfTurnsPerSample.data(), octavesPerSample.data()};
}

void ModalBank::makeHeavyReal(ModeResidues& residues) const noexcept {
    for (const HeavyMode& heavy : heavyModes)
        for (std::size_t c = 0; c < channelCount; ++c) {
            float& re = residues[c].re[index(heavy.mode)];
            float& im = residues[c].im[index(heavy.mode)];
            re = std::copysign(std::hypot(re, im), re + im);
            im = 0;
        }
}

// Σ' ρ^k b over k ≥ 0, the first term halved, is b (1 + ρ)/(2 (1 − ρ)) with b = 1 + iα/ω.
std::array<float, maximumChannels>
ModalBank::directSound(const ModeResidues& residues, std::span<const ModeRun> runs) const noexcept {
    std::array<float, maximumChannels> sums{};
    for (const ModeRun& run : runs)
        for (std::size_t g = index(run.first); g < index(run.first + run.count); ++g) {
            const float re = 1 - sampleRe[g], im = -sampleIm[g];
            const float perNorm = 0.5f / (re * re + im * im);
            const float quotientRe = ((2 - re) * re - im * im) * perNorm;
            const float quotientIm = -2 * im * perNorm;
            const auto share = static_cast<float>(velocityShare[g]);
            const float restRe = quotientRe - share * quotientIm;
            const float restIm = quotientIm + share * quotientRe;
            for (std::size_t c = 0; c < channelCount; ++c)
                sums[c] -= residues[c].re[g] * restRe - residues[c].im[g] * restIm;
        }
    // Heavy modes have rotations of 0 in the loop above. Let their whole first sample sound.
    for (const HeavyMode& heavy : heavyModes)
        if (const std::size_t g = index(heavy.mode); isIn(runs, heavy.mode))
            for (std::size_t c = 0; c < channelCount; ++c)
                sums[c] += residues[c].re[g];
    return sums;
}

void ModalBank::forcedStates(const PulseInstant& pulse, UnitContact& unit) const noexcept {
    idiophone::forcedStates(pulse,
                            {.decay = decay.data(),
                             .frequency = frequency.data(),
                             .x = unit.x.data(),
                             .y = unit.y.data(),
                             .steady = unit.steady.data(),
                             .swingRe = unit.swingRe.data(),
                             .swingIm = unit.swingIm.data(),
                             .quadratureRe = unit.quadratureRe.data(),
                             .quadratureIm = unit.quadratureIm.data()},
                            paddedSize());
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        const ForcedResponse response(pole(g), pulse.contactSeconds, pulse.dampingPerSecond);
        const ModalState state = stateOf(pole(g), response.motion(pulse.phase));
        unit.x[g] = static_cast<float>(state.x);
        unit.y[g] = static_cast<float>(state.y);
        unit.steady[g] = static_cast<float>(response.steadyVelocity());
        unit.swingRe[g] = static_cast<float>(response.swingVelocity().real());
        unit.swingIm[g] = static_cast<float>(response.swingVelocity().imag());
        unit.quadratureRe[g] = unit.quadratureIm[g] = 0;
    }
}

void ModalBank::impulseStates(UnitContact& unit) const noexcept {
    std::fill_n(unit.x.begin(), paddedSize(), 1.0f);
    for (std::size_t g = 0; g < paddedSize(); ++g)
        unit.y[g] = static_cast<float>(velocityShare[g]);
}

void ModalBank::startIncrements(const UnitContact& unit,
                                const ModeResidues& residues,
                                const BeforeSample& before,
                                StateIncrements& increments) const noexcept {
    const auto channels = channelsOf(residues, increments);
    idiophone::startIncrements(
        incrementModes(), {unit.x.data(), unit.y.data(), before.samples, before.factor},
        paddedSize(), std::span(channels).first(channelCount), increments.energies.data());
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        const ModalState increment =
            before.factor * (propagator(pole(g), before.samples * sampleSeconds) *
                             ModalState{unit.x[g], unit.y[g]});
        double largest = 0;
        for (std::size_t c = 0; c < channelCount; ++c) {
            const ModalState heard = static_cast<double>(residues[c].re[g]) * increment;
            increments.x[c][g] = static_cast<float>(heard.x);
            increments.y[c][g] = static_cast<float>(heard.y);
            largest = std::max(largest, amplitudeBound(pole(g), heard));
        }
        increments.energies[g] = static_cast<float>(largest * largest);
    }
}

void ModalBank::clearIncrements(StateIncrements& increments) const noexcept {
    for (std::size_t c = 0; c < channelCount; ++c) {
        std::fill_n(increments.x[c].begin(), paddedSize(), 0.0f);
        std::fill_n(increments.y[c].begin(), paddedSize(), 0.0f);
    }
}

void ModalBank::gatherIncrements(const UnitContact& unit,
                                 const ModeResidues& residues,
                                 double factor,
                                 double share,
                                 StateIncrements& increments) const noexcept {
    const auto channels = channelsOf(residues, increments);
    idiophone::gatherIncrements({.x = unit.x.data(),
                                 .y = unit.y.data(),
                                 .perFrequency = unit.quadratureIm.data(),
                                 .force = share / (2 * std::numbers::pi),
                                 .factor = factor},
                                paddedSize(), std::span(channels).first(channelCount));
}

void ModalBank::finishIncrements(const UnitContact& unit,
                                 const ModeResidues& residues,
                                 const BeforeSample& before,
                                 const IncrementMove& contact,
                                 StateIncrements& increments) const noexcept {
    const auto channels = channelsOf(residues, increments);
    idiophone::finishIncrements(incrementModes(),
                                {unit.x.data(), unit.y.data(), before.samples, before.factor},
                                contact, paddedSize(), std::span(channels).first(channelCount));
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        const ModalState end{unit.x[g], unit.y[g]};
        const ModalState start =
            std::exp2(-contact.damperOctaves) * (propagator(pole(g), contact.seconds) * end);
        const ModalState both =
            before.factor * (propagator(pole(g), before.samples * sampleSeconds) *
                             ModalState{end.x - start.x, end.y - start.y});
        for (std::size_t c = 0; c < channelCount; ++c) {
            const auto residue = static_cast<double>(residues[c].re[g]);
            increments.x[c][g] = static_cast<float>(residue * both.x);
            increments.y[c][g] = static_cast<float>(residue * both.y);
        }
    }
}

void ModalBank::join(const StateIncrements& increments, const IncrementMove& move) noexcept {
    setAside(states, heavyModes);
    std::array<JoinedChannel, maximumChannels> channels{};
    for (std::size_t c = 0; c < channelCount; ++c)
        channels[c] = {.incrementX = increments.x[c].data(),
                       .incrementY = increments.y[c].data(),
                       .x = states.x[c].data(),
                       .y = states.y[c].data()};
    joinIncrements(incrementModes(), move, paddedSize(), std::span(channels).first(channelCount),
                   energy.data());
    for (const HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        const Propagator motion = propagator(pole(g), move.seconds);
        const double factor = std::exp2(-move.damperOctaves);
        for (std::size_t c = 0; c < channelCount; ++c) {
            const ModalState moved =
                factor * (motion * ModalState{increments.x[c][g], increments.y[c][g]});
            states.x[c][g] = heavy.aside[c].x + moved.x;
            states.y[c][g] = heavy.aside[c].y + moved.y;
        }
        measure(g);
    }
}

void ModalBank::sound(const StateIncrements& increments,
                      std::span<const ModeRun> runs,
                      std::size_t subBlockCount,
                      const ChannelOutputs& outputs,
                      std::span<const ModePart> parts,
                      const ChannelOutputs& partOutputs) noexcept {
    if (runs.empty())
        return;
    SubBlockStates ahead;
    const std::size_t last = index(runs.back().first + runs.back().count);
    for (std::size_t first = index(runs.front().first) / modeBlock * modeBlock; first < last;
         first += batchModes) {
        const std::size_t modes = std::min(batchModes, paddedSize() - first);
        const std::span<HeavyMode> heavyHere = heavyIn(first, first + modes);
        setAside(increments, heavyHere);
        for (std::size_t c = 0; c < channelCount; ++c) {
            fillAhead(rotations(first), modes, subBlockCount, increments.x[c].data() + first,
                      increments.y[c].data() + first, ahead);
            for (const HeavyMode& heavy : heavyHere)
                fillHeavyAhead(heavy, c, index(heavy.mode) - first, ahead);
            mixRuns(runs, first, first + modes, ahead, subBlockCount, outputs[c]);
            mixParts(parts, first, first + modes, ahead, subBlockCount, partOutputs[c]);
        }
    }
}

void ModalBank::force(std::span<const float, cellSize> impulses,
                      const ModeResidues& startResidues,
                      const ModeResidues& endResidues,
                      double dampingPerSecond) noexcept {
    // The damper has attenuated each impulse by the end of the cell.
    alignas(64) std::array<float, cellSize> fallen;
    std::copy(impulses.begin(), impulses.end(), fallen.begin());
    if (dampingPerSecond > 0) {
        const double fall = std::exp(-dampingPerSecond * sampleSeconds);
        double factor = 1;
        for (std::size_t k = cellSize; k-- > 0;)
            fallen[k] *= static_cast<float>(factor *= fall);
    }
    setAside(states, heavyModes);
    std::array<ForcedChannel, maximumChannels> channels{};
    for (std::size_t c = 0; c < channelCount; ++c)
        channels[c] = {.startRe = startResidues[c].re.data(),
                       .startIm = startResidues[c].im.data(),
                       .endRe = endResidues[c].re.data(),
                       .endIm = endResidues[c].im.data(),
                       .x = states.x[c].data(),
                       .y = states.y[c].data()};
    forceModes({.sampleRe = sampleRe.data(),
                .sampleIm = sampleIm.data(),
                .subBlockRe = subBlockRe.data(),
                .subBlockIm = subBlockIm.data(),
                .velocityShare = velocityShare.data()},
               fallen.data(), paddedSize(), std::span(channels).first(channelCount), energy.data());
    for (const HeavyMode& heavy : heavyModes)
        forceHeavy(heavy, fallen, startResidues, endResidues);
}

void ModalBank::forceHeavy(const HeavyMode& heavy,
                           std::span<const float, cellSize> impulses,
                           const ModeResidues& startResidues,
                           const ModeResidues& endResidues) noexcept {
    const std::size_t g = index(heavy.mode);
    const Propagator sample = propagator(pole(g), sampleSeconds);
    for (std::size_t c = 0; c < channelCount; ++c) {
        const auto start = static_cast<double>(startResidues[c].re[g]);
        const auto change = static_cast<double>(endResidues[c].re[g]) - start;
        ModalState moving;
        for (std::size_t k = 0; k < cellSize; ++k) {
            const double residue =
                start + change * static_cast<double>(fractionAt(k / subBlockSamples));
            moving.x += residue * static_cast<double>(impulses[k]);
            moving = sample * moving;
        }
        states.x[c][g] = heavy.aside[c].x + moving.x;
        states.y[c][g] = heavy.aside[c].y + moving.y;
    }
    measure(g);
}

} // namespace idiophone
