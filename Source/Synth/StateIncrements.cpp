// SPDX-License-Identifier: Apache-2.0
#include "Synth/StateIncrements.h"

#include "Synth/IncrementKernel.h"
#include "Synth/ModalBank.h"
#include "Synth/ModeMix.h"
#include "Synth/UnitContact.h"

#include <algorithm>
#include <numbers>

namespace idiophone {

StateIncrements::StateIncrements(std::size_t modes, std::size_t channels) : energies(modes) {
    for (std::size_t c = 0; c < channels; ++c) {
        x[c].resize(modes);
        y[c].resize(modes);
    }
}

void StateIncrements::start(const ModalBank& bank,
                            const UnitContact& unit,
                            const ModeResidues& residues,
                            const BeforeSample& before) noexcept {
    startIncrements(bank.poles().arrays(), unit, before, residues, bank.paddedSize(),
                    bank.channels(), *this);
    bank.poles().heavy().start(unit, residues, before, bank.channels(), *this);
}

void StateIncrements::finish(const ModalBank& bank,
                             const UnitContact& unit,
                             const ModeResidues& residues,
                             const BeforeSample& before,
                             const IncrementMove& contact) noexcept {
    finishIncrements(bank.poles().arrays(), unit, before, contact, residues, bank.paddedSize(),
                     bank.channels(), *this);
    bank.poles().heavy().finish(unit, residues, before, contact, bank.channels(), *this);
}

// The forced part is the same at both ends of a contact, so the increments there differ by the free
// motion between them: |1 − e^{iωT}|² = 4 sin² (ωT/2), with the sine by Bhaskara's fraction.
void StateIncrements::energiesAfter(const ModalBank& bank,
                                    double contactSamples,
                                    std::vector<float>& after) const noexcept {
    const float* halfTurns = bank.poles().arrays().halfTurnsPerSample.data();
    const auto half = static_cast<float>(contactSamples / 2);
    for (std::size_t g = 0; g < bank.size(); ++g) {
        const float turns = half * halfTurns[g];
        const float rest = turns - static_cast<float>(static_cast<std::int32_t>(turns));
        const float parabola = 4 * rest * (1 - rest);
        const float twoSines = 8 * parabola / (5 - parabola);
        after[g] = twoSines * twoSines * energies[g];
    }
    for (const HeavyMode& heavy : bank.poles().heavy().in(0, bank.size()))
        after[heavy.mode] = energies[heavy.mode];
}

void StateIncrements::clear() noexcept {
    for (auto* arrays : {&x, &y})
        for (auto& array : *arrays)
            std::ranges::fill(array, 0.0f);
}

void StateIncrements::gather(const ModalBank& bank,
                             const UnitContact& unit,
                             const ModeResidues& residues,
                             double factor,
                             double force) noexcept {
    gatherIncrements(unit, residues, factor, force / (2 * std::numbers::pi), bank.paddedSize(),
                     bank.channels(), *this);
}

void StateIncrements::sound(ModalBank& bank,
                            std::span<const ModeRun> runs,
                            std::size_t subBlockCount,
                            const ChannelOutputs& outputs,
                            std::span<const ModePart> parts,
                            const ChannelOutputs& partOutputs) const noexcept {
    if (runs.empty())
        return;
    bank.prepare(runs);
    const ModePoles& poles = bank.poles();
    SubBlockStates ahead;
    const std::size_t last = index(runs.back().first + runs.back().count);
    for (std::size_t first = index(runs.front().first) / modeBlock * modeBlock; first < last;
         first += batchModes) {
        const std::size_t end = std::min(first + batchModes, bank.paddedSize());
        for (std::size_t c = 0; c < bank.channels(); ++c) {
            fillAhead(poles.rotations(first), end - first, subBlockCount, x[c].data() + first,
                      y[c].data() + first, ahead);
            for (const HeavyMode& heavy : poles.heavy().in(first, end))
                heavy.fillAhead({x[c][heavy.mode], y[c][heavy.mode]}, heavy.mode - first, ahead);
            const MixBatch batch{poles.arrays().tables.data(), first, end, subBlockCount};
            batch.mix(runs, ahead, outputs[c]);
            batch.mix(parts, ahead, partOutputs[c]);
        }
    }
}

} // namespace idiophone
