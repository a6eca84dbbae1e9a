// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModePoles.h"

#include "Synth/PoleLawKernel.h"

#include <algorithm>
#include <utility>

namespace idiophone {

ModePoles::ModePoles(std::size_t capacity, double sampleRateHz)
    : secondsPerSample(1 / sampleRateHz), count(capacity), heavyModes(capacity, sampleRateHz),
      coefficients(paddedSize()), audibles(paddedSize()), resonancesHz(paddedSize() + 8),
      isPrepared(blockCount()) {
    std::ranges::fill(coefficients.stiffness, 1.0);
}

void ModePoles::regroup(std::size_t modes, std::span<const ModeShare> shares) noexcept {
    // `prepare` fills `cellRe` and `cellIm` again afterwards.
    auto& newStiffness = coefficients.cellRe;
    auto& newDamping = coefficients.cellIm;
    std::ranges::fill(newStiffness, 1.0);
    std::ranges::fill(newDamping, 0.0);
    std::int32_t last = -1;
    for (const ModeShare& taken : shares)
        if (std::exchange(last, taken.to) != taken.to) {
            newStiffness[index(taken.to)] = coefficients.stiffness[index(taken.from)];
            newDamping[index(taken.to)] = coefficients.damping[index(taken.from)];
        }
    std::swap(coefficients.stiffness, newStiffness);
    std::swap(coefficients.damping, newDamping);
    count = modes;
    forget();
}

void ModePoles::forget() noexcept {
    heavyModes.clear();
    audibleModes = 0;
    resonanceCount = 0;
    std::ranges::fill(audibles, 0.0f);
    std::ranges::fill(isPrepared, false);
}

void ModePoles::set(const PoleLaw& law,
                    std::span<const double> referenceEigenvalues,
                    std::span<const ModeDamping> dampings) noexcept {
    std::swap(coefficients.stiffness, coefficients.cellRe);
    std::swap(coefficients.damping, coefficients.cellIm);
    polesOfLaw(law, referenceEigenvalues.first(count), dampings, coefficients.stiffness.data(),
               coefficients.damping.data());
    for (std::size_t g = count; g < paddedSize(); ++g)
        set(g, {});
}

void ModePoles::update(const AudibleBand& band, std::span<const std::uint8_t> silenced) noexcept {
    forget();
    const PolesFound found = coefficientsOfPoles(coefficients, paddedSize(), secondsPerSample, band,
                                                 audibles.data(), resonancesHz.data());
    resonanceCount = found.resonances;
    std::fill(audibles.begin() + static_cast<std::ptrdiff_t>(count), audibles.end(), 0.0f);
    for (std::size_t g = 0; g < silenced.size(); ++g)
        if (silenced[g] != 0)
            audibles[g] = 0;
    audibleModes = static_cast<std::size_t>(
        std::count(audibles.begin(), audibles.begin() + static_cast<std::ptrdiff_t>(count), 1.0f));
    foundHeavy = !found.allOscillate;
    for (std::size_t g = 0; g < count && foundHeavy; ++g)
        if (!isOscillating(pole(g))) {
            heavyModes.add(g, pole(g));
            coefficients.velocityShare[g] = 0;
        }
}

void ModePoles::findRotations(std::size_t block) noexcept {
    const std::size_t first = block * modeBlock;
    rotationsOfPoles(coefficients, first, modeBlock, secondsPerSample);
    heavyModes.correct(first, first + modeBlock, coefficients);
}

} // namespace idiophone
