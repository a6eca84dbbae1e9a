#include "Synth/ModalBank.h"

#include "Synth/ModeIndex.h"
#include "Synth/PoleKernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace idiophone {

namespace {

float tableEntry(double value) noexcept {
    return std::abs(value) < faintestTableEntry ? 0.0f : static_cast<float>(value);
}

} // namespace

void findRuns(std::span<const std::int32_t> modes, std::vector<ModeRun>& runs) noexcept {
    runs.clear();
    for (const std::int32_t mode : modes)
        if (!runs.empty() && runs.back().first + runs.back().count == mode)
            ++runs.back().count;
        else
            runs.push_back({mode, 1});
}

ModalBank::ModalBank(std::size_t capacity, std::size_t channelCapacity, double sampleRateHz)
    : sampleSeconds(1 / sampleRateHz) {
    const std::size_t padded = (capacity + modeBlock - 1) / modeBlock * modeBlock;
    for (auto* array : {&stiffness, &damping, &decay, &frequency, &velocityShare, &cellRe, &cellIm})
        array->resize(padded);
    for (auto* array : {&audibles, &halfTurnsPerSample, &octavesPerSample, &sampleRe, &sampleIm,
                        &subBlockRe, &subBlockIm, &energy})
        array->resize(padded);
    for (std::size_t c = 0; c < channelCapacity; ++c) {
        states.x[c].resize(padded);
        states.y[c].resize(padded);
    }
    tables.resize(2 * subBlockSamples * padded);
    heavyModes.reserve(capacity);
    firstHeavy.resize(padded / modeBlock + 1);
    resonancesHz.reserve(capacity);
    blockNumbers.resize(padded / modeBlock);
    std::iota(blockNumbers.begin(), blockNumbers.end(), 0);
    count = capacity;
}

ModeStates ModalBank::emptyStates() const {
    ModeStates empty;
    for (std::size_t c = 0; c < maximumChannels; ++c) {
        empty.x[c].resize(states.x[c].size());
        empty.y[c].resize(states.y[c].size());
    }
    return empty;
}

StateIncrements ModalBank::emptyIncrements() const {
    StateIncrements empty;
    empty.energies.resize(energy.size());
    for (std::size_t c = 0; c < maximumChannels; ++c) {
        empty.x[c].resize(states.x[c].size());
        empty.y[c].resize(states.y[c].size());
    }
    return empty;
}

void ModalBank::setChannels(std::size_t wanted) noexcept {
    for (; channelCount < wanted && !states.x[channelCount].empty(); ++channelCount) {
        std::copy(states.x[0].begin(), states.x[0].end(), states.x[channelCount].begin());
        std::copy(states.y[0].begin(), states.y[0].end(), states.y[channelCount].begin());
    }
    channelCount = std::min(channelCount, wanted);
}

void ModalBank::resize(std::size_t modes) noexcept {
    count = modes;
    forgetHeavy();
    std::fill(audibles.begin(), audibles.end(), 0.0f);
    resonancesHz.clear();
    // Padding and future modes are oscillating modes at rest.
    std::fill(stiffness.begin(), stiffness.end(), 1.0);
    std::fill(damping.begin(), damping.end(), 0.0);
    clear();
}

void ModalBank::clear() noexcept {
    for (auto* arrays : {&states.x, &states.y})
        for (auto& array : *arrays)
            std::fill(array.begin(), array.end(), 0.0);
    std::fill(energy.begin(), energy.end(), 0.0f);
}

void ModalBank::regroup(std::size_t modes,
                        std::span<const ModeShare> shares,
                        ModeStates& room) noexcept {
    // A new mode starts with the pole of the first mode that it takes from. The arrays that serve
    // as scratch are refilled by `movePoles`.
    auto& newStiffness = cellRe;
    auto& newDamping = cellIm;
    std::fill(newStiffness.begin(), newStiffness.end(), 1.0);
    std::fill(newDamping.begin(), newDamping.end(), 0.0);
    for (std::size_t c = 0; c < channelCount; ++c) {
        std::fill_n(room.x[c].begin(), states.x[c].size(), 0.0);
        std::fill_n(room.y[c].begin(), states.y[c].size(), 0.0);
    }
    std::int32_t last = -1;
    for (const ModeShare& taken : shares) {
        const ModalPole before = pole(index(taken.from));
        const std::size_t g = index(taken.to);
        if (std::exchange(last, taken.to) != taken.to) {
            newStiffness[g] = before.stiffness;
            newDamping[g] = before.damping;
        }
        const ModalPole after{newStiffness[g], newDamping[g]};
        const bool sameKind = isOscillating(before) == isOscillating(after);
        for (std::size_t c = 0; c < channelCount; ++c) {
            const ModalState old = state(index(taken.from), c);
            const ModalState moved = sameKind ? old : stateOf(after, motionOf(before, old));
            room.x[c][g] += taken.share * moved.x;
            room.y[c][g] += taken.share * moved.y;
        }
    }
    std::swap(stiffness, newStiffness);
    std::swap(damping, newDamping);
    for (std::size_t c = 0; c < channelCount; ++c) {
        std::copy_n(room.x[c].begin(), states.x[c].size(), states.x[c].begin());
        std::copy_n(room.y[c].begin(), states.y[c].size(), states.y[c].begin());
    }
    count = modes;
    forgetHeavy();
    std::fill(audibles.begin(), audibles.end(), 0.0f);
    for (std::size_t g = 0; g < energy.size(); ++g)
        measure(g);
}

void ModalBank::movePoles(std::span<const double> referenceEigenvalues,
                          const PoleLaw& law,
                          double lowestHz,
                          double highestHz,
                          std::span<const ModeDamping> dampings,
                          std::span<const std::uint8_t> silenced) noexcept {
    heavyModes.clear();
    audibleModes = 0;
    resonancesHz.clear();
    for (std::size_t g = 0; g < count; ++g) {
        const ModalPole moved = law.pole(referenceEigenvalues[g], dampingOf(dampings, g));
        const bool oscillates = isOscillating(moved);
        if (oscillates != isOscillating(pole(g)) && energy[g] > 0)
            for (std::size_t c = 0; c < channelCount; ++c) {
                const ModalState changed = stateOf(moved, motionOf(pole(g), state(g, c)));
                states.x[c][g] = changed.x;
                states.y[c][g] = changed.y;
            }
        stiffness[g] = moved.stiffness;
        damping[g] = moved.damping;
        const double hz = naturalFrequencyHz(moved);
        const bool inBand = hz >= lowestHz && hz < highestHz;
        const bool light = moved.damping * moved.damping < 4e-4 * moved.stiffness;
        const bool isHeard = inBand && (silenced.empty() || silenced[g] == 0);
        audibles[g] = isHeard ? 1.0f : 0.0f;
        audibleModes += isHeard ? 1 : 0;
        if (inBand && light)
            resonancesHz.push_back(hz);
        if (g % modeBlock == 0)
            firstHeavy[g / modeBlock] = heavyModes.size();
        if (!oscillates)
            heavyModes.emplace_back().mode = static_cast<std::int32_t>(g);
    }
    if (!std::ranges::is_sorted(resonancesHz)) // a live thickness may change the order
        std::ranges::sort(resonancesHz);
    std::fill(firstHeavy.begin() + static_cast<std::ptrdiff_t>(blockCount()), firstHeavy.end(),
              heavyModes.size());
    rotationsOfPoles({.stiffness = stiffness.data(),
                      .damping = damping.data(),
                      .decay = decay.data(),
                      .frequency = frequency.data(),
                      .velocityShare = velocityShare.data(),
                      .halfTurnsPerSample = halfTurnsPerSample.data(),
                      .octavesPerSample = octavesPerSample.data(),
                      .sampleRe = sampleRe.data(),
                      .sampleIm = sampleIm.data(),
                      .subBlockRe = subBlockRe.data(),
                      .subBlockIm = subBlockIm.data(),
                      .cellRe = cellRe.data(),
                      .cellIm = cellIm.data(),
                      .tables = tables.data()},
                     paddedSize(), sampleSeconds);
    for (HeavyMode& heavy : heavyModes) {
        const std::size_t g = index(heavy.mode);
        heavy.subBlock = propagator(pole(g), sampleSeconds * subBlockSamples);
        heavy.cell = propagator(pole(g), sampleSeconds * cellSize);
        correctHeavy(g);
        measure(g);
    }
}

void ModalBank::forgetHeavy() noexcept {
    heavyModes.clear();
    std::fill(firstHeavy.begin(), firstHeavy.end(), std::size_t{0});
}

void ModalBank::correctHeavy(std::size_t g) noexcept {
    velocityShare[g] = 0;
    sampleRe[g] = 0;
    sampleIm[g] = 0;
    subBlockRe[g] = 0;
    subBlockIm[g] = 0;
    cellRe[g] = 0;
    cellIm[g] = 0;
    const Propagator sample = propagator(pole(g), sampleSeconds);
    Propagator power;
    float* table = tables.data() + 2 * subBlockSamples * g;
    for (std::size_t k = 0; k < subBlockSamples; ++k) {
        table[k] = tableEntry(power.xx);
        table[subBlockSamples + k] = tableEntry(power.xy);
        power = power * sample;
    }
}

void ModalBank::measure(std::size_t g) noexcept {
    double largest = 0;
    for (std::size_t c = 0; c < channelCount; ++c)
        largest = std::max(largest, amplitudeBound(pole(g), state(g, c)));
    energy[g] = static_cast<float>(largest * largest);
}

void ModalBank::measureModes(std::size_t first, std::size_t end) noexcept {
    for (std::size_t c = 0; c < channelCount; ++c) {
        const double* x = states.x[c].data();
        const double* y = states.y[c].data();
        for (std::size_t g = first; g < end; ++g) {
            const auto size = static_cast<float>(x[g] * x[g] + y[g] * y[g]);
            energy[g] = c == 0 ? size : std::max(energy[g], size);
        }
    }
    for (const HeavyMode& heavy : heavyIn(first, end))
        measure(index(heavy.mode));
}

void ModalBank::setState(std::size_t g, const ModalState& state, std::size_t channel) noexcept {
    states.x[channel][g] = state.x;
    states.y[channel][g] = state.y;
    measure(g);
}

void ModalBank::silence(std::size_t g) noexcept {
    for (std::size_t c = 0; c < channelCount; ++c)
        states.x[c][g] = states.y[c][g] = 0;
    energy[g] = 0;
}

float ModalBank::energyOfLoudest(std::size_t block) const noexcept {
    const float* first = energy.data() + block * modeBlock;
    return *std::max_element(first, first + modeBlock);
}

void ModalBank::clearFaint(std::size_t block, double faintest) noexcept {
    for (std::size_t g = block * modeBlock; g < (block + 1) * modeBlock; ++g)
        if (!(static_cast<double>(energy[g]) > faintest * faintest && energy[g] < largestEnergy))
            silence(g);
}

} // namespace idiophone
