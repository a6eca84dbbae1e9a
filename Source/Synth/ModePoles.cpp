#include "Synth/ModePoles.h"

#include <algorithm>
#include <utility>

namespace idiophone {

ModePoles::ModePoles(std::size_t capacity, double sampleRateHz)
    : secondsPerSample(1 / sampleRateHz), count(capacity), heavyModes(capacity, sampleRateHz),
      coefficients(paddedSize()), audibles(paddedSize()) {
    resonancesHz.reserve(capacity);
    std::ranges::fill(coefficients.stiffness, 1.0);
}

void ModePoles::regroup(std::size_t modes, std::span<const ModeShare> shares) noexcept {
    // `update` fills `cellRe` and `cellIm` again afterwards.
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
    resonancesHz.clear();
    std::ranges::fill(audibles, 0.0f);
}

void ModePoles::update(double lowestHz,
                       double highestHz,
                       std::span<const std::uint8_t> silenced) noexcept {
    forget();
    for (std::size_t g = 0; g < count; ++g) {
        const ModalPole own = pole(g);
        const double hz = naturalFrequencyHz(own);
        const bool inBand = hz >= lowestHz && hz < highestHz;
        const bool isLight = own.damping * own.damping < 4e-4 * own.stiffness;
        const bool isAudible = inBand && (silenced.empty() || silenced[g] == 0);
        audibles[g] = isAudible ? 1.0f : 0.0f;
        audibleModes += isAudible ? 1 : 0;
        if (inBand && isLight)
            resonancesHz.push_back(hz);
        if (!isOscillating(own))
            heavyModes.add(g, own);
    }
    if (!std::ranges::is_sorted(resonancesHz)) // a live thickness may change the order
        std::ranges::sort(resonancesHz);
    rotationsOfPoles(coefficients, paddedSize(), secondsPerSample);
    heavyModes.correct(coefficients);
}

} // namespace idiophone
